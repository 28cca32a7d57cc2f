// Files from and to a page.

/** Offers a file for download. */
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

/**
 * Listens for files and text.
 *
 * @param port `busy`: the event is for something else; `textIn` reads a file
 */
export function listenToFiles(
  host: HTMLElement,
  {
    busy,
    take,
    textIn,
  }: { busy: (event: Event) => boolean; take: (text: string) => void; textIn: (file: File) => Promise<string> },
) {
  host.addEventListener(
    "dragover",
    (event) =>
      event.dataTransfer?.types.some((type) => type === "Files" || type === "text/plain") && event.preventDefault(),
  );
  host.addEventListener("drop", async (event) => {
    if (busy(event) || !event.dataTransfer) return;
    event.preventDefault();
    const [file] = event.dataTransfer.files;
    take(file ? await textIn(file) : event.dataTransfer.getData("text/plain"));
  });
  host.addEventListener("paste", (event) => {
    const text = event.clipboardData?.getData("text/plain");
    if (!text || busy(event)) return;
    event.preventDefault();
    take(text);
  });
}
