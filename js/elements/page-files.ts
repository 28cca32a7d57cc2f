// Files from and to a page.

/** Hands a file to the user. */
export function save(page: Document, name: string, blob: Blob) {
  const link = Object.assign(page.createElement("a"), { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href));
}

/**
 * Lets files be dropped on a part of the page.
 *
 * @returns ends it
 */
export function acceptDrops(target: HTMLElement, dropped: (file: File) => void): () => void {
  const over = (event: DragEvent) => event.dataTransfer?.types.includes("Files") && event.preventDefault();
  const drop = (event: DragEvent) => {
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
