// What a pressed key means.

const DIRECTIONS: Map<string, readonly [number, number]> = new Map([
  ["ArrowLeft", [-1, 0]],
  ["ArrowRight", [1, 0]],
  ["ArrowUp", [0, -1]],
  ["ArrowDown", [0, 1]],
]);
/** Input types in which letters are not text. */
const TEXTLESS = new Set(["button", "checkbox", "color", "file", "image", "radio", "range", "reset", "submit"]);
const [STEP, WIDE_STEP, FINE_STEP] = [1, 10, 0.1];

/** The direction of an arrow key, to the right and downwards; null for every other key, and with Ctrl or Cmd. */
export function arrowDirection(event: KeyboardEvent): readonly [number, number] | null {
  return event.ctrlKey || event.metaKey ? null : (DIRECTIONS.get(event.key) ?? null);
}

/** How far an arrow key moves a point: one step, ten with Shift, a tenth with Alt; null for every other key. */
export function arrowStep(event: KeyboardEvent): [number, number] | null {
  const direction = arrowDirection(event);
  if (!direction) return null;
  const step = event.shiftKey ? WIDE_STEP : event.altKey ? FINE_STEP : STEP;
  return [direction[0] * step, direction[1] * step];
}

/** In lower case; a browser that fills in a form sends events without a key. */
export const keyOf = (event: KeyboardEvent) => (event.key ?? "").toLowerCase();

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
