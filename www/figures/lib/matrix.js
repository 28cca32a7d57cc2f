// Numbers of a basis matrix as people read and write them, and what they mean.

const ROWS = 4;

/** What the numbers mean for the curve. @param {number[]} matrix */
export function matrixSummary(matrix) {
  const sums = Array.from({ length: ROWS }, (_, i) => matrix.slice(4 * i, 4 * i + 4).reduce((sum, x) => sum + x, 0));
  const near = (/** @type {number} */ a, /** @type {number} */ b) => Math.abs(a - b) < 1e-6;
  const mixture = near(sums[3], 1) && sums.slice(0, 3).every((sum) => near(sum, 0));
  return mixture
    ? "At every t the weights add up to 1."
    : "The weights do not add up to 1. If all points move by the same vector, the curve does not move by that vector.";
}

/** "−1/6" or "0.5" as a number. @param {string} text */
export function parseNumber(text) {
  const [top, bottom, ...more] = text
    .replace("−", "-")
    .split("/")
    .map((part) => (part.trim() === "" ? NaN : Number(part)));
  return more.length > 0 ? NaN : bottom === undefined ? top : top / bottom;
}

/** Sixths are written as people do. @param {number} value */
export function formatNumber(value) {
  const sixths = Math.round(6 * value);
  if (Math.abs(value - sixths / 6) > 1e-12 || sixths % 3 === 0) return signed(String(value));
  return signed(sixths % 2 === 0 ? `${sixths / 2}/3` : `${sixths}/6`);
}

/** @param {string} text */
const signed = (text) => text.replace("-", "−");
