// B-splines: other control points for the same chains.
import * as check from "./check.js";
import { core } from "../wasm/init.js";
import { flatten } from "./points.js";
import { load } from "../wasm/transfer.js";

/**
 * @import { PointsLike } from "./check.js"
 * @import { Parts } from "./spline.js"
 */

/**
 * What a B-spline is besides its control points.
 *
 * @typedef {object} BSplineOptions
 * @property {number} [degree] 1 to 64, by default 3
 * @property {boolean} [closed]
 * @property {ArrayLike<number>} [knots] in ascending order: points + degree + 1 of them, closed points + 1 (the joints of one
 *   period); by default 0, 1, 2, …
 * @property {2 | 3} [dimension]
 */

/**
 * A B-spline, as `Spline.fromBSpline(points, options)` takes it back: `const { points, ...options } = spline.toBSpline()`.
 *
 * @typedef {{ points: Float64Array, knots: Float64Array, degree: number, closed: boolean, dimension: 2 | 3 }} BSpline
 */

/**
 * Leaves the Bézier form of a B-spline in the arena.
 *
 * @internal
 * @param {PointsLike} points
 * @param {BSplineOptions} [options]
 * @returns {{ length: number, dimension: 2 | 3 }}
 */
export function fromBSpline(points, options) {
  const { degree = 3, closed = false, knots: given, dimension: wanted } = check.options(options);
  check.whole(degree, "degree", 1, 64);
  const { flat, dimension } = flatten(points, wanted, 2);
  const count = flat.length / dimension;
  const knots = given === undefined ? new Float64Array(0) : check.numbers(given, "knots");
  if (given !== undefined && knots.length === 0) {
    const needed = count + 1 + (closed ? 0 : degree);
    throw new RangeError(`knots: expected ${needed} (for ${count} points of degree ${degree}), got 0`);
  }
  load(flat, knots.length).set(knots, flat.length);
  return { length: core().spline_from_bspline(dimension, count, degree, Boolean(closed), knots.length), dimension };
}

/**
 * A chain as a B-spline whose knots are the joints, each as often as the degree: the control points are its own.
 *
 * @internal
 * @param {Parts} parts
 * @returns {BSpline}
 */
export function toBSpline({ flat, dimension, degrees, closed }) {
  const degree = degrees[0];
  const other = degrees.findIndex((each) => each !== degree);
  if (other > 0) {
    throw new RangeError(
      `degrees[${other}]: expected the degree of the first segment (${degree}), got ${degrees[other]}`,
    );
  }
  const count = flat.length / dimension;
  const shift = closed ? degree - 1 : 0;
  const points = new Float64Array(flat.length);
  points.set(flat.subarray(0, flat.length - shift * dimension), shift * dimension);
  points.set(flat.subarray(flat.length - shift * dimension));
  const first = closed ? 0 : 1; // one more 0 before the first joint's, and one more of the last at the end
  const knots = new Float64Array(count + 1 + (closed ? 0 : degree));
  knots.forEach((_, i) => (knots[i] = Math.min(Math.max(Math.floor((i - first) / degree), 0), degrees.length)));
  return { points, knots, degree, closed, dimension };
}
