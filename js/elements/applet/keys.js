// The keyboard, while the focus is inside.
import { arrowStep, isForText } from "../../applet/keys.js";

/**
 * @typedef {object} KeyPort
 * @property {() => boolean} off whether there are no keys but the arrows
 * @property {(event: Event) => number} pointOf the point that has the focus; −1 for none
 * @property {(index: number, step: [number, number]) => void} nudge
 * @property {() => void} settled the key is up again
 * @property {() => boolean} escape
 * @property {(index: number, bare: boolean) => void} remove
 * @property {(index: number) => boolean} cycle another mode for a joint; false where there is none
 * @property {() => void} insert
 * @property {() => void} undo
 * @property {() => void} redo
 * @property {() => void} randomize
 * @property {() => void} toggle
 * @property {() => void} help
 */

/**
 * @param {HTMLElement} host
 * @param {KeyPort} port
 */
export function listenToKeys(host, port) {
  host.addEventListener("keydown", (event) => {
    const elsewhere =
      event.defaultPrevented ||
      isForText(event) ||
      event.composedPath().some((each) => each instanceof HTMLDialogElement);
    if (!elsewhere && pressed(event, port)) event.preventDefault();
  });
  for (const type of ["keyup", "focusout"]) host.addEventListener(type, () => port.settled());
}

/**
 * @param {KeyboardEvent} event
 * @param {KeyPort} port
 * @returns {boolean} whether it was used
 */
function pressed(event, port) {
  const index = port.pointOf(event);
  const step = index < 0 ? null : arrowStep(event);
  if (step) return used(port.nudge(index, step));
  if (event.key === "Escape") return port.escape();
  if (port.off() || event.isComposing) return false;
  if (event.ctrlKey || event.metaKey) return commanded(event, port);
  if (event.altKey || event.repeat) return false;
  if (index >= 0 && event.key === "Enter") return port.cycle(index);
  if (index >= 0 && ["Delete", "Backspace"].includes(event.key)) return used(port.remove(index, event.shiftKey));
  const act = { r: port.randomize, m: port.toggle, i: port.insert, "?": port.help }[(event.key ?? "").toLowerCase()];
  return act !== undefined && used(act());
}

/**
 * @param {KeyboardEvent} event
 * @param {KeyPort} port
 */
function commanded(event, port) {
  const key = (event.key ?? "").toLowerCase();
  if (key === "y" || (key === "z" && event.shiftKey)) return used(port.redo());
  return key === "z" && used(port.undo());
}

/** @param {void} _ what was done */
const used = (_) => true;
