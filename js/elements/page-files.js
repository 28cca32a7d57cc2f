// Files from and to a page.

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
  const over = (/** @type {DragEvent} */ event) =>
    event.dataTransfer?.types.includes("Files") && event.preventDefault();
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
