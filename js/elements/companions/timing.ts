// The text of a timing function, and the picture of it in numbers.
import { quoted, readNumber } from "../../ui/numbers.js";
import { translatedTable } from "../../editor/translations.js";

/** X1, y1, x2, y2 */
export type Handles = [number, number, number, number];

/** The keywords of CSS, and common curves without one. */
export const PRESETS: Record<string, Handles> = {
  ease: [0.25, 0.1, 0.25, 1],
  linear: [0, 0, 1, 1],
  "ease-in": [0.42, 0, 1, 1],
  "ease-out": [0, 0, 0.58, 1],
  "ease-in-out": [0.42, 0, 0.58, 1],
  "gentle stop": [0.16, 1, 0.3, 1],
  overshoot: [0.34, 1.56, 0.64, 1],
  "wind up": [0.36, 0, 0.66, -0.56],
  both: [0.68, -0.6, 0.32, 1.6],
};
/** What those that are no keywords are called. */
export const PRESET_NAMES: Record<string, string> = translatedTable({
  "gentle stop": "gentle stop",
  overshoot: "overshoot",
  "wind up": "wind up",
  both: "both",
});
/** So many of them are words of CSS. */
const KEYWORDS = 5;

/**
 * @param text "cubic-bezier(x1, y1, x2, y2)" or a keyword of CSS for one
 * @throws {RangeError}
 */
export function readTiming(text: string): Handles {
  const word = text.trim().toLowerCase();
  const keyword = Object.keys(PRESETS)
    .slice(0, KEYWORDS)
    .find((name) => name === word);
  if (keyword) return [...PRESETS[keyword]];
  const inside = word.match(/^cubic-bezier\((.*)\)$/)?.[1];
  const numbers = inside?.split(",").map(readNumber) ?? [];
  if (numbers.length !== 4 || numbers.some(Number.isNaN))
    throw new RangeError(`expected cubic-bezier(x1, y1, x2, y2), got ${quoted(text)}`);
  ["x1", "", "x2"].forEach((name, k) => name && checkAbscissa(name, numbers[k]));
  return numbers as Handles;
}

export function checkAbscissa(name: string, x: number) {
  if (!(x >= 0 && x <= 1)) throw new RangeError(`${name}: expected a number from 0 to 1, got ${x}`);
}

export function timingText(handles: Handles) {
  return `cubic-bezier(${handles.join(", ")})`;
}

/**
 * The preset with these handles.
 *
 * @returns empty: none
 */
export function presetOf(handles: Handles): string {
  return Object.keys(PRESETS).find((name) => PRESETS[name].every((x, k) => x === handles[k])) ?? "";
}

/** The picture in its own units. */
export const SQUARE = { width: 260, height: 312, side: 26 };
/** Air above and below what is shown. */
const AIR = 0.25;

/** The interval of y that is shown */
export type Heights = [number, number];

/** Enough for both handles. */
export function heightsOf([, y1, , y2]: Handles): Heights {
  return [Math.min(0, y1, y2) - AIR, Math.max(1, y1, y2) + AIR];
}

export function across(x: number) {
  return SQUARE.side + x * (SQUARE.width - 2 * SQUARE.side);
}

export function down([low, high]: Heights, y: number) {
  return SQUARE.height * (1 - (y - low) / (high - low));
}

/**
 * Where a place in the picture is; x within 0 and 1, y within what is shown, both to two digits.
 *
 * @param left in parts of the width
 * @param top in parts of the height
 */
export function placeAt([low, high]: Heights, left: number, top: number): [number, number] {
  const x = (left * SQUARE.width - SQUARE.side) / (SQUARE.width - 2 * SQUARE.side);
  const clamp = (value: number, min: number, max: number) => Math.min(Math.max(value, min), max);
  return [rounded(clamp(x, 0, 1)), rounded(clamp(high - top * (high - low), low, high))];
}

export const rounded = (x: number) => Math.round(100 * x) / 100 + 0;
