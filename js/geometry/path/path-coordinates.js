// Locations on a path where a coordinate has a given value or an extremum.
import * as check from "../check.js";

/**
 * @import { Curve } from "../curve/curve.js"
 * @import { PathTime } from "./path-queries.js"
 * @import { PathValue } from "./path-value.js"
 */

/** The names of the coordinates. */
const AXES = /** @type {const} */ (["x", "y"]);

/**
 * The locations where a coordinate has a local extremum.
 *
 * @typedef {{ x: PathTime[], y: PathTime[] }} PathExtrema
 */

/**
 * @internal
 * @param {PathValue} path
 * @returns {PathExtrema}
 */
export function extremaOfPath(path) {
  const [x, y] = AXES.map((_, axis) =>
    path.subpaths.flatMap(({ closed }, subpath) =>
      extremaOfSubpath(path._segments(subpath), closed, axis).map((t) => ({ subpath, t })),
    ),
  );
  return { x, y };
}

/**
 * The sorted values of t at which a coordinate has a local extremum: inside the segments and at joints. Where the
 * coordinate is constant between increasing and decreasing, it is the start of the constant part.
 *
 * @param {readonly Curve[]} segments
 * @param {boolean} closed
 * @param {number} axis
 * @returns {number[]}
 */
function extremaOfSubpath(segments, closed, axis) {
  const directions = segments.map((curve) => endDirections(curve._flat, axis));
  const moving = directions.flatMap(([start], k) => (start === 0 ? [] : [k]));
  if (moving.length === 0) return [];
  const ts = [];
  // The last segment in which the coordinate is not constant; for an open subpath there is none before the first one.
  let previous = closed ? /** @type {number} */ (moving.at(-1)) : -1;
  for (const k of moving) {
    const isTurn = previous >= 0 && directions[previous][1] !== directions[k][0];
    if (isTurn) ts.push((previous + 1) % (closed ? segments.length : Infinity));
    for (const t of segments[k].extrema()[AXES[axis]]) ts.push(k + t);
    previous = k;
  }
  return ts.sort((a, b) => a - b);
}

/**
 * The signs of a coordinate's derivative just after the start and just before the end of a curve; 0 where the coordinate
 * is constant.
 *
 * @param {Float64Array} flat
 * @param {number} axis
 * @returns {[number, number]}
 */
function endDirections(flat, axis) {
  const steps = [];
  let largest = 0;
  for (let k = axis; k < flat.length; k += 2) largest = Math.max(largest, Math.abs(flat[k]));
  // Rounding is no step, as in src/curve/extrema.rs.
  for (let k = axis + 2; k < flat.length; k += 2) {
    const step = flat[k] - flat[k - 2];
    if (Math.abs(step) > Number.EPSILON * largest) steps.push(Math.sign(step));
  }
  return steps.length ? [steps[0], steps[steps.length - 1]] : [0, 0];
}

/**
 * @internal
 * @param {PathValue} path
 * @param {{ x: number } | { y: number }} where
 * @returns {PathTime[]}
 */
export function timesAtCoordinateOfPath(path, where) {
  const [axis, value] = requestedCoordinate(where);
  const query = /** @type {{ x: number }} */ ({ [AXES[axis]]: value });
  return path.subpaths.flatMap(({ closed }, subpath) => {
    const segments = path._segments(subpath);
    /** @type {number[]} */
    const ts = [];
    segments.forEach((curve, k) => {
      if (!mayContain(curve._flat, axis, value)) return;
      for (const t of curve.timesAtCoordinate(query)) if (ts.at(-1) !== k + t) ts.push(k + t);
    });
    // The end of a closed subpath is its start.
    if (closed && ts.length > 1 && ts[0] === 0 && ts.at(-1) === segments.length) ts.pop();
    return ts.map((t) => ({ subpath, t }));
  });
}

/**
 * The index and the value of the coordinate that a query names.
 *
 * @param {unknown} where
 * @returns {[number, number]}
 */
function requestedCoordinate(where) {
  const values = /** @type {Record<string, unknown>} */ (check.object(/** @type {object} */ (where), "where"));
  const given = AXES.filter((name) => values[name] !== undefined);
  if (given.length !== 1) throw new TypeError(`where: expected exactly one of x, y, got ${check.describe(where)}`);
  return [AXES.indexOf(given[0]), check.finite(values[given[0]], given[0])];
}

/**
 * Whether a value lies in the range of a coordinate of the control points.
 *
 * @param {Float64Array} flat
 * @param {number} axis
 * @param {number} value
 */
function mayContain(flat, axis, value) {
  let [min, max] = [flat[axis], flat[axis]];
  for (let k = axis + 2; k < flat.length; k += 2) {
    min = Math.min(min, flat[k]);
    max = Math.max(max, flat[k]);
  }
  return min <= value && value <= max;
}
