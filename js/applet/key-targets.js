// Which applet the letters on a page are for, when there are several.

/** A property of the document, so that applets of different bundles find each other. */
const TARGETS = Symbol.for("casteljau.keyTargets");

/**
 * All applets in a document.
 *
 * @param {Document} page
 * @returns {Set<HTMLElement>}
 */
function targetsOf(page) {
  const owner = /** @type {Document & { [TARGETS]?: Set<HTMLElement> }} */ (page);
  owner[TARGETS] ??= new Set();
  return owner[TARGETS];
}

/**
 * Adds an applet; returns the function that removes it.
 *
 * @param {HTMLElement} host
 * @returns {() => void}
 */
export function addKeyTarget(host) {
  const targets = targetsOf(host.ownerDocument);
  targets.add(host);
  return () => void targets.delete(host);
}

/**
 * The applet that has the focus, else the one under the pointer, else the only one in view.
 *
 * @param {KeyboardEvent} event
 * @param {Document} page
 * @returns {{ host: HTMLElement | null, focused: boolean }}
 */
export function keyTarget(event, page) {
  const targets = targetsOf(page);
  const focused = event.composedPath().find((each) => targets.has(/** @type {HTMLElement} */ (each)));
  if (focused) return { host: /** @type {HTMLElement} */ (focused), focused: true };
  const hovered = [...targets].find((host) => host.matches(":hover"));
  if (hovered) return { host: hovered, focused: false };
  const visible = [...targets].filter(isInView);
  return { host: visible.length === 1 ? visible[0] : null, focused: false };
}

/** @param {HTMLElement} host */
function isInView(host) {
  const { clientWidth, clientHeight } = host.ownerDocument.documentElement;
  const { left, right, top, bottom, width, height } = host.getBoundingClientRect();
  return width > 0 && height > 0 && right > 0 && bottom > 0 && left < clientWidth && top < clientHeight;
}
