// Which applet the letters on a page are for, when there are several.

/** A property of the document, so that applets of different bundles find each other. */
const TARGETS = Symbol.for("casteljau.keyTargets");

/** All applets in a document. */
function targetsOf(page: Document): Set<HTMLElement> {
  const owner = page as Document & { [TARGETS]?: Set<HTMLElement> };
  owner[TARGETS] ??= new Set();
  return owner[TARGETS];
}

/** Adds an applet; returns the function that removes it. */
export function addKeyTarget(host: HTMLElement): () => void {
  const targets = targetsOf(host.ownerDocument);
  targets.add(host);
  return () => void targets.delete(host);
}

/** The applet that has the focus, else the one under the pointer, else the only one in view. */
export function keyTarget(event: KeyboardEvent, page: Document): { host: HTMLElement | null; focused: boolean } {
  const targets = targetsOf(page);
  const focused = event.composedPath().find((each) => targets.has(each as HTMLElement));
  if (focused) return { host: focused as HTMLElement, focused: true };
  const hovered = [...targets].find((host) => host.matches(":hover"));
  if (hovered) return { host: hovered, focused: false };
  const visible = [...targets].filter(isInView);
  return { host: visible.length === 1 ? visible[0] : null, focused: false };
}

function isInView(host: HTMLElement) {
  const { clientWidth, clientHeight } = host.ownerDocument.documentElement;
  const { left, right, top, bottom, width, height } = host.getBoundingClientRect();
  return width > 0 && height > 0 && right > 0 && bottom > 0 && left < clientWidth && top < clientHeight;
}
