// What the chapter's tasks say and measure.

/** @typedef {[number, number, number]} Vector */

/** @param {boolean} done @param {string} words */
export const verdict = (done, words) => ({ done, words });

/** A number for reading. @param {number} x @param {number} [digits] */
export const formatNumber = (x, digits = 2) => x.toFixed(digits).replace("-", "−");

/** A count with commas. @param {number} count */
export const formatCount = (count) => count.toLocaleString("en");

/** The length of a point as the package gives it. @param {{ x: number, y: number, z?: number }} vector */
export const lengthOf = ({ x, y, z = 0 }) => Math.hypot(x, y, z);

/** The control points of the first patch of a surface. @param {{ patch(k: number): { controlPoints(): Float64Array } }} surface */
export function pointsOf(surface) {
  const flat = surface.patch(0).controlPoints();
  return Array.from({ length: flat.length / 3 }, (_, k) => [flat[3 * k], flat[3 * k + 1], flat[3 * k + 2]]);
}
