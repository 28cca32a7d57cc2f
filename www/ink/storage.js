// The drawing in the browser's storage (localStorage), so that it is there after a reload.

/** @import { Drawing, Stroke } from "./ink-pad.js" */

const KEY = "casteljau-ink";
/** The length of the text at which older strokes are left out, about 20,000 samples. Browsers keep some millions of characters for a site. */
const MAX_CHARACTERS = 500_000;
/** No surface is as high as this, in units. */
const MAX_HEIGHT = 1000;
/** Decimals of a sample: x, y, pressure, time. */
const DIGITS = [2, 2, 3, 1];

/** What is kept of a sample, at the precision of pointers. @param {import("./ink-pad.js").Sample} sample */
export const rounded = (sample) =>
  /** @type {typeof sample} */ (sample.map((value, k) => Number(value.toFixed(DIGITS[k]))));

/**
 * Keeps the last strokes of a drawing, as many as there is room for.
 *
 * @param {Drawing} drawing
 * @returns {number} how many strokes are kept; 0, too, where the browser keeps nothing
 */
export function keepDrawing({ strokes, height }) {
  /** @type {string[]} */
  const texts = [];
  const frame = `{"height":${height},"strokes":[`;
  let length = frame.length + 2;
  for (const stroke of strokes.toReversed()) {
    const text = JSON.stringify(stroke);
    length += text.length + 1;
    if (length > MAX_CHARACTERS) break;
    texts.unshift(text);
  }
  try {
    localStorage.setItem(KEY, `${frame}${texts}]}`);
    return texts.length;
  } catch {
    return 0;
  }
}

/** The drawing that is kept; null if there is none, or if it is not ours. @returns {Drawing | null} */
export function keptDrawing() {
  try {
    const text = localStorage.getItem(KEY);
    const drawing = text === null || text.length > MAX_CHARACTERS ? null : JSON.parse(text);
    const { strokes, height } = drawing ?? {};
    return Array.isArray(strokes) && strokes.every(isStroke) && height >= 0 && height <= MAX_HEIGHT ? drawing : null;
  } catch {
    return null;
  }
}

/** @param {any} stroke @returns {stroke is Stroke} */
const isStroke = (stroke) =>
  typeof stroke?.device === "boolean" &&
  Array.isArray(stroke.samples) &&
  stroke.samples.length > 0 &&
  stroke.samples.every(
    (/** @type {unknown} */ sample) =>
      Array.isArray(sample) && sample.length === DIGITS.length && sample.every((value) => Math.abs(value) < 1e9),
  );
