import { coordinate, finite, isCoordinate, isList, optionalDimension, describe } from "./check.js";

/**
 * @import { PointsLike } from "./check.js"
 */

/**
 * A point in a result: `{x, y}` in 2D, `{x, y, z}` in 3D. Where the dimension is not known, `z` may be missing.
 *
 * @template {2 | 3} [D=2 | 3]
 * @typedef {[D] extends [2] ? { x: number, y: number } : [D] extends [3] ? { x: number, y: number, z: number } : { x: number, y: number, z?: number }} Point
 */

/**
 * The corners of a box whose sides are parallel to the axes.
 *
 * @template {2 | 3} [D=2 | 3]
 * @typedef {{ min: Point<D>, max: Point<D> }} Bounds
 */

/**
 * Points as arrays of D coordinates each, from which TypeScript infers the dimension.
 *
 * @template {2 | 3} [D=2 | 3]
 * @typedef {readonly (readonly number[] & { readonly 0: number, readonly length: D })[]} PointArrays
 */

/**
 * Points as one flat array of coordinates.
 *
 * @internal
 * @typedef {{ dimension: 2 | 3, flat: Float64Array }} Flat
 */

/**
 * Refuses what is no list of points. Functions call it before they check options, which `new Curve(0, 0, 100, 100)` seems to have.
 *
 * @internal
 * @param {unknown} points
 * @param {string} [name]
 */
export function requireList(points, name = "points") {
  if (isList(points)) return;
  const hint = typeof points === "number" ? "; did you mean [[x, y], …]?" : "";
  throw new TypeError(`${name}: expected an array of points, got ${describe(points)}${hint}`);
}

/**
 * Converts points of any form to one flat array, copied and checked.
 *
 * @internal
 * @param {PointsLike} points
 * @param {unknown} dimension the option of the caller
 * @param {2 | 3} flatDimension the dimension of a flat array without that option
 * @param {string} [name]
 * @returns {Flat}
 */
export function flatten(points, dimension, flatDimension, name = "points") {
  const requested = optionalDimension(dimension);
  requireList(points, name);
  if (ArrayBuffer.isView(points) || typeof points[0] === "number") {
    return fromNumbers(/** @type {ArrayLike<unknown>} */ (points), requested ?? flatDimension, name);
  }
  const list = /** @type {ArrayLike<unknown>} */ (points);
  return fromPoints(list, requested ?? (list.length ? dimensionOf(list[0], `${name}[0]`) : 2), name);
}

/**
 * @param {ArrayLike<unknown>} numbers
 * @param {2 | 3} dimension
 * @param {string} name
 * @returns {Flat}
 */
function fromNumbers(numbers, dimension, name) {
  if (numbers.length % dimension !== 0) {
    throw new RangeError(`${name}: expected a multiple of ${dimension} numbers (${dimension}D), got ${numbers.length}`);
  }
  const flat = new Float64Array(numbers.length);
  for (let i = 0; i < flat.length; i++) {
    const value = numbers[i];
    if (typeof value !== "number" || !isCoordinate(value)) coordinate(value, `${name}[${i}]`);
    flat[i] = /** @type {number} */ (value);
  }
  return { dimension, flat };
}

/**
 * @param {ArrayLike<unknown>} list
 * @param {2 | 3} dimension
 * @param {string} name
 * @returns {Flat}
 */
function fromPoints(list, dimension, name) {
  const flat = new Float64Array(list.length * dimension);
  for (let i = 0; i < list.length; i++) writePoint(flat, i * dimension, list[i], dimension, `${name}[${i}]`);
  return { dimension, flat };
}

/**
 * The dimension of a point: the length of an array; an object is 3D if it has a `z` but no `w` (as a DOMPoint has).
 *
 * @param {unknown} point
 * @param {string} name
 * @returns {2 | 3}
 */
function dimensionOf(point, name) {
  if (isList(point)) {
    if (point.length === 2 || point.length === 3) return point.length;
    throw new RangeError(`${name}: expected 2 or 3 coordinates, got ${point.length}`);
  }
  if (typeof point !== "object" || point === null) throw notAPoint(point, name);
  return "z" in point && !("w" in point) ? 3 : 2;
}

/**
 * Writes one point into a flat array, checked.
 *
 * @internal
 * @param {Float64Array} flat
 * @param {number} at
 * @param {unknown} point
 * @param {2 | 3} dimension
 * @param {string} name
 */
export function writePoint(flat, at, point, dimension, name) {
  if (isList(point)) {
    if (point.length !== dimension) {
      throw new RangeError(`${name}: expected ${dimension} coordinates, got ${point.length}`);
    }
    for (let i = 0; i < dimension; i++) flat[at + i] = coordinate(point[i], `${name}[${i}]`);
    return;
  }
  if (typeof point !== "object" || point === null) throw notAPoint(point, name);
  const { x, y, z } = /** @type {{ x: unknown, y: unknown, z?: unknown }} */ (point);
  flat[at] = coordinate(x, `${name}.x`);
  flat[at + 1] = coordinate(y, `${name}.y`);
  if (dimension === 3) flat[at + 2] = coordinate(z, `${name}.z`);
}

/**
 * @param {unknown} value
 * @param {string} name
 * @returns {TypeError}
 */
function notAPoint(value, name) {
  const hint = typeof value === "number" && !name.endsWith("]") ? "; did you mean [x, y]?" : "";
  return new TypeError(
    `${name}: expected a point ([x, y], [x, y, z], {x, y} or {x, y, z}), got ${describe(value)}${hint}`,
  );
}

/**
 * The point whose coordinates start at an index of a flat array.
 *
 * @internal
 * @template {2 | 3} D
 * @param {Float64Array} flat
 * @param {number} at
 * @param {D} dimension
 * @returns {Point<D>}
 */
export function pointAt(flat, at, dimension) {
  const [x, y] = [flat[at], flat[at + 1]];
  return /** @type {Point<D>} */ (dimension === 2 ? { x, y } : { x, y, z: flat[at + 2] });
}

/**
 * All points of a flat array.
 *
 * @internal
 * @template {2 | 3} D
 * @param {Float64Array} flat
 * @param {D} dimension
 * @returns {Point<D>[]}
 */
export function pointList(flat, dimension) {
  return Array.from({ length: flat.length / dimension }, (_, k) => pointAt(flat, k * dimension, dimension));
}

/**
 * A box from its two corners in a flat array.
 *
 * @internal
 * @template {2 | 3} D
 * @param {Float64Array} flat
 * @param {D} dimension
 * @returns {Bounds<D>}
 */
export function boxAt(flat, dimension) {
  return { min: pointAt(flat, 0, dimension), max: pointAt(flat, dimension, dimension) };
}

/**
 * The points of a flat array as one array each, for JSON.
 *
 * @internal
 * @param {Float64Array} flat
 * @param {number} dimension
 * @returns {number[][]}
 */
export function nested(flat, dimension) {
  const points = [];
  for (let i = 0; i < flat.length; i += dimension) points.push([...flat.subarray(i, i + dimension)]);
  return points;
}

/**
 * Whether two flat arrays of points are equal within a distance.
 *
 * @internal
 * @param {Float64Array} a
 * @param {Float64Array} b
 * @param {number} dimension
 * @param {unknown} tolerance
 * @returns {boolean}
 */
export function samePoints(a, b, dimension, tolerance) {
  const maxDistance = finite(tolerance, "tolerance");
  if (maxDistance < 0) throw new RangeError(`tolerance: expected a number from 0, got ${maxDistance}`);
  if (a.length !== b.length) return false;
  for (let i = 0; i < a.length; i += dimension) {
    const z = dimension === 3 ? a[i + 2] - b[i + 2] : 0;
    if (!(Math.hypot(a[i] - b[i], a[i + 1] - b[i + 1], z) <= maxDistance)) return false;
  }
  return true;
}
