// Surfaces from files and to files.
import { Surface } from "../../index.js";

/** Longer files are refused unread: a browser would stand still over them. */
const MOST_BYTES = 16e6;
/** More cannot be drawn at sixty frames a second. */
const MOST_PATCHES = 20_000;
const MEGABYTE = 1e6;

/**
 * The surface in a file.
 *
 * @param {File} file
 * @returns {Promise<Surface>}
 * @throws {RangeError} says what is wrong with the file
 */
export async function surfaceIn(file) {
  if (file.size > MOST_BYTES) {
    throw new RangeError(`expected at most ${MOST_BYTES / MEGABYTE} MB, got ${(file.size / MEGABYTE).toFixed(1)} MB`);
  }
  const surface = Surface.parse(await file.text());
  if (surface.patchCount === 0) throw new RangeError("expected patches, got none");
  if (surface.patchCount > MOST_PATCHES) throw new RangeError(`expected at most ${MOST_PATCHES} patches, got ${surface.patchCount}`);
  return surface;
}

/**
 * Hands a file to the user.
 *
 * @param {Document} page
 * @param {string} name
 * @param {Blob} blob
 */
export function save(page, name, blob) {
  const link = Object.assign(page.createElement("a"), { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href));
}

/**
 * Lets files be dropped on a part of the page.
 *
 * @param {HTMLElement} target
 * @param {(file: File) => void} dropped
 * @returns {() => void} ends it
 */
export function acceptDrops(target, dropped) {
  const over = (/** @type {DragEvent} */ event) => event.dataTransfer?.types.includes("Files") && event.preventDefault();
  const drop = (/** @type {DragEvent} */ event) => {
    const file = event.dataTransfer?.files[0];
    if (!file) return;
    event.preventDefault();
    dropped(file);
  };
  target.addEventListener("dragover", over);
  target.addEventListener("drop", drop);
  return () => {
    target.removeEventListener("dragover", over);
    target.removeEventListener("drop", drop);
  };
}
