// The keyboard: letters on the whole page, arrows on the points.
import { addKeyTarget, keyTarget } from "./key-targets.js";

/**
 * What the letters do.
 *
 * @typedef {object} KeyPort
 * @property {HTMLElement} host
 * @property {() => boolean} pageWide whether letters count when the focus is elsewhere
 * @property {() => void} randomize
 * @property {() => void} toggle
 * @property {() => boolean} escape ends a drag; false if there is none
 */

/** Input types in which letters are not text. */
const TEXTLESS = new Set(["button", "checkbox", "color", "file", "image", "radio", "range", "reset", "submit"]);

const ARROWS = new Map([
  ["ArrowLeft", [-1, 0]],
  ["ArrowRight", [1, 0]],
  ["ArrowUp", [0, -1]],
  ["ArrowDown", [0, 1]],
]);
const STEP = 1;
const WIDE_STEP = 10;
const FINE_STEP = 0.1;

/**
 * Listens to the page.
 *
 * @param {KeyPort} port
 * @returns {() => void} ends it
 */
export function listenToKeys(port) {
  const page = port.host.ownerDocument;
  const listener = (/** @type {KeyboardEvent} */ event) => pressed(event, port);
  const removeTarget = addKeyTarget(port.host);
  page.addEventListener("keydown", listener);
  return () => {
    removeTarget();
    page.removeEventListener("keydown", listener);
  };
}

/**
 * @param {KeyboardEvent} event
 * @param {KeyPort} port
 */
function pressed(event, port) {
  if (event.key === "Escape" && port.escape()) return event.preventDefault();
  const act = { r: port.randomize, m: port.toggle }[(event.key ?? "").toLowerCase()]; // a browser that fills in a form sends events without a key
  if (!act || !isPlain(event) || isForText(event)) return;
  const { host, focused } = keyTarget(event, port.host.ownerDocument);
  if (host !== port.host || !(focused || port.pageWide())) return;
  event.preventDefault();
  act();
}

/**
 * Whether a key was pressed without modifiers; Shift is allowed, as for capital letters.
 *
 * @param {KeyboardEvent} event
 * @returns {boolean}
 */
export function isPlain(event) {
  const modified = event.ctrlKey || event.altKey || event.metaKey;
  return !modified && !event.repeat && !event.isComposing && !event.defaultPrevented;
}

/**
 * Whether the key goes to something that takes text, in a shadow root or not.
 *
 * @param {Event} event
 * @returns {boolean}
 */
export function isForText(event) {
  const target = /** @type {HTMLElement | undefined} */ (event.composedPath()[0]);
  if (!target || !("localName" in target)) return false;
  if (target.isContentEditable || target.ownerDocument.designMode === "on") return true;
  if (target.localName === "input") return !TEXTLESS.has(/** @type {HTMLInputElement} */ (target).type);
  return target.localName === "textarea" || target.localName === "select";
}

/**
 * How far an arrow key moves a point.
 *
 * @param {KeyboardEvent} event
 * @returns {[number, number] | null} null for every other key
 */
export function arrowStep(event) {
  const arrow = ARROWS.get(event.key);
  if (!arrow || event.ctrlKey || event.metaKey) return null;
  const step = event.shiftKey ? WIDE_STEP : event.altKey ? FINE_STEP : STEP;
  return [arrow[0] * step, arrow[1] * step];
}
