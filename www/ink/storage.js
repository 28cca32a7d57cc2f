// The drawing in the browser's storage (localStorage), so that it is there after a reload.

/** @typedef {import("./ink-pad.js").Stroke} Stroke */

const KEY = "casteljau-ink";
/** The length of the text at which older strokes are left out, about 20,000 samples. Browsers keep some millions of characters for a site. */
const MAX_CHARACTERS = 500_000;
/** Decimals of a sample: x, y, pressure, time. */
const DIGITS = [2, 2, 3, 1];

/** What is kept of a sample, at the precision of pointers. @param {import("./ink-pad.js").Sample} sample */
export const rounded = (sample) =>
  /** @type {typeof sample} */ (sample.map((value, k) => Number(value.toFixed(DIGITS[k]))));

/**
 * Keeps the last strokes of a drawing, as many as there is room for.
 *
 * @param {readonly Stroke[]} strokes
 * @returns {number} how many strokes are kept; 0, too, where the browser keeps nothing
 */
export function keepStrokes(strokes) {
  /** @type {string[]} */
  const texts = [];
  let length = 2;
  for (const stroke of strokes.toReversed()) {
    const text = JSON.stringify(stroke);
    length += text.length + 1;
    if (length > MAX_CHARACTERS) break;
    texts.unshift(text);
  }
  try {
    localStorage.setItem(KEY, `[${texts}]`);
    return texts.length;
  } catch {
    return 0;
  }
}

/** The strokes that are kept; null if there are none, or if they are not ours. @returns {Stroke[] | null} */
export function keptStrokes() {
  try {
    const text = localStorage.getItem(KEY);
    const strokes = text === null || text.length > MAX_CHARACTERS ? null : JSON.parse(text);
    return Array.isArray(strokes) && strokes.every(isStroke) ? strokes : null;
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
