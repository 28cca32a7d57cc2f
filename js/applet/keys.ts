// The keyboard: letters on the whole page, arrows on the points.
import { addKeyTarget, keyTarget } from "./key-targets.js";

/** What the letters do. */
export interface KeyPort {
  host: HTMLElement;
  /** Whether letters count when the focus is elsewhere */
  pageWide: () => boolean;
  randomize: () => void;
  toggle: () => void;
  undo: () => void;
  redo: () => void;
  /** Ends a drag; false if there is none */
  escape: () => boolean;
}

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
 * @returns ends it
 */
export function listenToKeys(port: KeyPort): () => void {
  const page = port.host.ownerDocument;
  const listener = (event: KeyboardEvent) => pressed(event, port);
  const removeTarget = addKeyTarget(port.host);
  page.addEventListener("keydown", listener);
  return () => {
    removeTarget();
    page.removeEventListener("keydown", listener);
  };
}

function pressed(event: KeyboardEvent, port: KeyPort) {
  if (event.key === "Escape" && port.escape()) return event.preventDefault();
  const step = historyStep(event);
  const letter = isPlain(event) && { r: port.randomize, m: port.toggle }[keyOf(event)];
  const act = step ? port[step] : letter;
  if (!act || isForText(event)) return;
  const { host, focused } = keyTarget(event, port.host.ownerDocument);
  if (host !== port.host || !(focused || (!step && port.pageWide()))) return;
  event.preventDefault();
  act();
}

/** In lower case; a browser that fills in a form sends events without a key. */
const keyOf = (event: KeyboardEvent) => (event.key ?? "").toLowerCase();

/** What Ctrl or Cmd with Z, Shift+Z or Y asks for. */
export function historyStep(event: KeyboardEvent): "undo" | "redo" | null {
  if (!(event.ctrlKey || event.metaKey) || event.altKey || event.defaultPrevented) return null;
  const key = keyOf(event);
  if (key === "y" || (key === "z" && event.shiftKey)) return "redo";
  return key === "z" ? "undo" : null;
}

/** Whether a key was pressed without modifiers; Shift is allowed, as for capital letters. */
export function isPlain(event: KeyboardEvent): boolean {
  const modified = event.ctrlKey || event.altKey || event.metaKey;
  return !modified && !event.repeat && !event.isComposing && !event.defaultPrevented;
}

/** Whether the key goes to something that takes text, in a shadow root or not. */
export function isForText(event: Event): boolean {
  const target = event.composedPath()[0] as HTMLElement | undefined;
  if (!target || !("localName" in target)) return false;
  if (target.isContentEditable || target.ownerDocument.designMode === "on") return true;
  if (target.localName === "input") return !TEXTLESS.has((target as HTMLInputElement).type);
  return target.localName === "textarea" || target.localName === "select";
}

/**
 * How far an arrow key moves a point.
 *
 * @returns null for every other key
 */
export function arrowStep(event: KeyboardEvent): [number, number] | null {
  const arrow = ARROWS.get(event.key);
  if (!arrow || event.ctrlKey || event.metaKey) return null;
  const step = event.shiftKey ? WIDE_STEP : event.altKey ? FINE_STEP : STEP;
  return [arrow[0] * step, arrow[1] * step];
}
