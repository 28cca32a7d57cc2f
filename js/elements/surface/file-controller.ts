// Opens and saves files, and keeps the message about what failed.
import { meshFile, surfaceIn } from "./files.js";
import { save } from "../../ui/files.js";
import type { Mesh, Surface } from "../../surfaces.js";
import type { Rational } from "./loading.js";

export interface FileControllerPort {
  show: (surface: Surface) => void;
  /** Fetches what surfaces with weights need; null where it cannot be fetched */
  rational: () => Promise<Rational | null>;
  /** The message has changed */
  changed: () => void;
  picture: () => Promise<Blob | null>;
  /** Null before there is one */
  mesh: () => { mesh: Mesh; up: "z" | "y" } | null;
  /** The document for downloads, and the name of the files */
  names: () => { page: Document; name: string };
}

export class FileController {
  #port;
  #message = "";
  /** What is wrong with a file stays until the next one; what is wrong with a setting goes with it. */
  #lasting = false;
  /** The file that was opened last: an earlier one that is read later is not shown. */
  #opened: File | null = null;

  constructor(port: FileControllerPort) {
    this.#port = port;
  }

  get message() {
    return this.#message;
  }

  say(message: string, lasting = false) {
    if (message === this.#message) return;
    [this.#message, this.#lasting] = [message, lasting];
    this.#port.changed();
  }

  /** All went well. */
  clear() {
    if (!this.#lasting) this.say("");
  }

  /** Shows the surface of a file; where there is none in it, says why and leaves all as it was. */
  async open(file: File) {
    this.#opened = file;
    try {
      const surface = await surfaceIn(file, this.#port.rational);
      if (file !== this.#opened) return;
      this.#port.show(surface);
      this.say("");
    } catch (error) {
      if (file === this.#opened) this.say(`${file.name}: ${wordsOf(error)}`, true);
    }
  }

  saveMesh(kind: "obj" | "stl" | "glb") {
    const found = this.#port.mesh();
    const { page, name } = this.#port.names();
    if (found) save(page, `${name}.${kind}`, meshFile(found.mesh, kind, found.up));
  }

  async savePicture() {
    const blob = await this.#port.picture();
    const { page, name } = this.#port.names();
    if (blob) save(page, `${name}.png`, blob);
  }
}

/** What went wrong, in words. */
export function wordsOf(error: unknown) {
  return error instanceof Error ? error.message : String(error);
}
