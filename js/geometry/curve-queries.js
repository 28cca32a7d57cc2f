// Queries of curves: nearest points, parameters of given coordinates, extrema, tangents, distances.
import { arena } from "../wasm/arena.js";
import { describe, finite, object } from "./check.js";
import { core, cubicEval } from "../wasm/init.js";
import { pointAt, writePoint } from "./points.js";
import { writeArguments, readResult } from "../wasm/transfer.js";

/**
 * @import { PointLike } from "./check.js"
 * @import { Point } from "./points.js"
 */

/**
 * The point of a curve or a spline that is nearest to another point.
 *
 * @template {2 | 3} [D=2 | 3]
 * @typedef {object} Nearest
 * @property {number} t the parameter of the nearest point
 * @property {Point<D>} point the nearest point
 * @property {number} distance its distance from the other point
 */

/**
 * @internal
 * @template {2 | 3} D
 * @param {Float64Array} flat
 * @param {D} dimension
 * @param {PointLike} p
 * @returns {Nearest<D>}
 */
export function nearest(flat, dimension, p) {
  if (flat.length === 8) return /** @type {Nearest<D>} */ (nearestOnCubic(flat, p));
  writePoint(writeArguments(flat, dimension), flat.length, p, dimension, "p");
  core().curve_nearest(dimension, flat.length / dimension);
  return readNearest(dimension);
}

/** The coordinates of a point that is not an object with two finite numbers x and y. */
const checked = new Float64Array(2);

/**
 * The nearest point of a 2D cubic, the most common kind of curve, whose coordinates are passed as arguments; see
 * `cubicAt` in curve.js.
 *
 * @param {Float64Array} c
 * @param {PointLike} p
 * @returns {Nearest<2>}
 */
function nearestOnCubic(c, p) {
  let { x, y } = /** @type {{ x: number, y: number }} */ (p ?? checked);
  if (typeof x !== "number" || typeof y !== "number" || x - x !== 0 || y - y !== 0) {
    writePoint(checked, 0, p, 2, "p");
    [x, y] = checked;
  }
  const t = core().cubic_nearest(c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], x, y);
  const at = cubicEval();
  const point = { x: at(c[0], c[2], c[4], c[6], t), y: at(c[1], c[3], c[5], c[7], t) };
  const [dx, dy] = [point.x - x, point.y - y];
  const square = dx * dx + dy * dy; // Math.hypot takes as long as the rest of this function
  return { t, point, distance: square > 1e-280 && square < 1e280 ? Math.sqrt(square) : Math.hypot(dx, dy) };
}

/**
 * Reads the nearest point from the arena.
 *
 * @internal
 * @template {2 | 3} D
 * @param {D} dimension
 * @returns {Nearest<D>}
 */
export function readNearest(dimension) {
  const numbers = arena(5);
  return { t: numbers[0], point: pointAt(numbers, 2, dimension), distance: numbers[1] };
}

/**
 * The parameters of the inner extrema of each coordinate.
 *
 * @typedef {{ x: Float64Array, y: Float64Array, z?: Float64Array }} Extrema
 */

/** The names of the coordinates. */
const AXES = /** @type {const} */ (["x", "y", "z"]);

/**
 * @internal
 * @param {Float64Array} flat
 * @param {2 | 3} dimension
 * @returns {Extrema}
 */
export function extrema(flat, dimension) {
  const timesOf = (/** @type {string} */ _, /** @type {number} */ axis) => {
    writeArguments(flat);
    return readResult(0, core().curve_extrema(dimension, flat.length / dimension, axis));
  };
  const [x, y, z] = AXES.slice(0, dimension).map(timesOf);
  return dimension === 2 ? { x, y } : { x, y, z };
}

/**
 * @internal
 * @param {Float64Array} flat
 * @param {2 | 3} dimension
 * @param {{ x: number } | { y: number } | { z: number }} where
 * @returns {Float64Array}
 */
export function timesAtCoordinate(flat, dimension, where) {
  const [axis, value] = requestedCoordinate(where, dimension);
  writeArguments(flat);
  return readResult(0, core().curve_times_at_coordinate(dimension, flat.length / dimension, axis, value));
}

/**
 * The index and the value of the coordinate that a query names.
 *
 * @internal
 * @param {unknown} where
 * @param {number} dimension
 * @returns {[number, number]}
 */
export function requestedCoordinate(where, dimension) {
  const values = /** @type {Record<string, unknown>} */ (object(/** @type {object} */ (where), "where"));
  const axes = AXES.slice(0, dimension);
  const given = AXES.filter((name) => values[name] !== undefined);
  const axis = axes.indexOf(given[0]);
  if (axis < 0 || given.length > 1) {
    throw new TypeError(`where: expected exactly one of ${axes.join(", ")}, got ${describe(where)}`);
  }
  return [axis, finite(values[axes[axis]], axes[axis])];
}

/**
 * The kind of a curve.
 *
 * @typedef {"point" | "line" | "quadratic" | "arch" | "serpentine" | "loop" | "cusp" | "twisted"} CurveKind
 */

/**
 * In the order of the core's codes.
 *
 * @internal
 * @type {readonly CurveKind[]}
 */
export const CURVE_KINDS = ["point", "line", "quadratic", "arch", "serpentine", "loop", "cusp", "twisted"];

/**
 * @internal
 * @param {Float64Array} flat
 * @param {PointLike} p
 * @returns {Float64Array}
 */
export function tangentsFrom(flat, p) {
  writePoint(writeArguments(flat, 2), flat.length, p, 2, "p");
  return readResult(0, core().curve_tangents_from(flat.length / 2));
}

/**
 * The smallest distance of two curves, and where it occurs: at t on the first, at u on the second.
 *
 * @typedef {{ distance: number, t: number, u: number }} Distance
 */

/**
 * @internal
 * @param {Float64Array} flat
 * @param {Float64Array} other
 * @param {2 | 3} dimension
 * @returns {Distance}
 */
export function distance(flat, other, dimension) {
  writeArguments(flat, other.length).set(other, flat.length);
  core().curve_distance(dimension, flat.length / dimension, other.length / dimension);
  const numbers = arena(3);
  return { distance: numbers[0], t: numbers[1], u: numbers[2] };
}

/**
 * @internal
 * @param {Float64Array} flat
 * @param {Float64Array} other
 * @param {2 | 3} dimension
 * @returns {number}
 */
export function hausdorff(flat, other, dimension) {
  writeArguments(flat, other.length).set(other, flat.length);
  return core().curve_hausdorff(dimension, flat.length / dimension, other.length / dimension);
}
