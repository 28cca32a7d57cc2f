// Which applet the letters on a page are for, when there are several.

/** A property of the document, so that applets of different bundles find each other. */
const TARGETS = Symbol.for("casteljau.keyTargets");

/** All applets in a document. */
function targetsOf(page: Document): Set<HTMLElement> {
  const owner = page as Document & { [TARGETS]?: Set<HTMLElement> };
  owner[TARGETS] ??= new Set();
  return owner[TARGETS];
}

/** Whether a key is for an applet: because it has the focus, or because of its place on the page. */
export type KeyTarget = "focus" | "page" | null;

/**
 * Listens to the keys of the page.
 *
 * @param press gets a function, as the answer asks for the layout; returns whether it has used the key
 * @returns stops listening
 */
export function listenToPageKeys(
  host: HTMLElement,
  press: (event: KeyboardEvent, target: () => KeyTarget) => boolean,
): () => void {
  const page = host.ownerDocument;
  const targets = targetsOf(page);
  const listener = (event: KeyboardEvent) => {
    const target = () => {
      const found = keyTarget(event, page);
      return found.host !== host ? null : found.focused ? "focus" : "page";
    };
    if (press(event, target)) event.preventDefault();
  };
  targets.add(host);
  page.addEventListener("keydown", listener);
  return () => {
    targets.delete(host);
    page.removeEventListener("keydown", listener);
  };
}

/** The applet that has the focus, else the one under the pointer, else the only one in view. */
function keyTarget(event: KeyboardEvent, page: Document): { host: HTMLElement | null; focused: boolean } {
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
