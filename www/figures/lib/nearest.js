// The distance of a point from the points of a curve, as a function of t, and its minima.

/** @typedef {{ eval(t: number): { x: number, y: number } }} Evaluated */
/** @typedef {{ t: number, distance: number, point: { x: number, y: number } }} Foot */

/** Steps of t in which minima are looked for: no cubic has more than three. */
const STEPS = 240;
/** Halvings of such a step. */
const REFINEMENTS = 40;

/** @param {Evaluated} curve @param {readonly [number, number]} point @param {number} t */
function footAt(curve, [x, y], t) {
  const point = curve.eval(t);
  return { t, point, distance: Math.hypot(point.x - x, point.y - y) };
}

/** @param {Evaluated} curve @param {readonly [number, number]} point */
export const distances = (curve, point) => Array.from({ length: STEPS + 1 }, (_, i) => footAt(curve, point, i / STEPS));

/**
 * The local minima of the distance, the nearest first.
 *
 * @param {Evaluated} curve
 * @param {readonly [number, number]} point
 * @returns {Foot[]}
 */
export function feet(curve, point) {
  const all = distances(curve, point);
  const isLow = (/** @type {Foot} */ foot, /** @type {number} */ i) =>
    foot.distance <= (all[i - 1]?.distance ?? Infinity) && foot.distance < (all[i + 1]?.distance ?? Infinity);
  return all
    .filter(isLow)
    .map(({ t }) => refined(curve, point, t))
    .sort((a, b) => a.distance - b.distance);
}

/** @param {Evaluated} curve @param {readonly [number, number]} point @param {number} t */
function refined(curve, point, t) {
  let best = footAt(curve, point, t);
  for (let k = 0, step = 1 / STEPS; k < REFINEMENTS; k++, step /= 2) {
    for (const next of [best.t - step, best.t + step]) {
      const foot = footAt(curve, point, Math.min(Math.max(next, 0), 1));
      if (foot.distance < best.distance) best = foot;
    }
  }
  return best;
}
