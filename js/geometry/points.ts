import { coordinate, isCoordinate, isList, nonNegative, optionalDimension, describe } from "./check.js";
import type { PointsLike } from "./check.js";

/** A point in a result: `{x, y}` in 2D, `{x, y, z}` in 3D. Where the dimension is not known, `z` may be missing. */
export type Point<D extends 2 | 3 = 2 | 3> = [D] extends [2]
  ? { x: number; y: number }
  : [D] extends [3]
    ? { x: number; y: number; z: number }
    : { x: number; y: number; z?: number };

/** The corners of a box whose sides are parallel to the axes. */
export type Bounds<D extends 2 | 3 = 2 | 3> = { min: Point<D>; max: Point<D> };

/** Points as arrays of D coordinates each, from which TypeScript infers the dimension. */
export type PointArrays<D extends 2 | 3 = 2 | 3> = readonly (readonly number[] & {
  readonly 0: number;
  readonly length: D;
})[];

/**
 * Points as one flat array of coordinates.
 *
 * @internal
 */
export type Flat = { dimension: 2 | 3; flat: Float64Array };

/**
 * Refuses what is no list of points. Functions call it before they check options, which `new Curve(0, 0, 100, 100)` seems to have.
 *
 * @internal
 */
export function requireList(points: unknown, name = "points") {
  if (isList(points)) return;
  const hint = typeof points === "number" ? "; did you mean [[x, y], …]?" : "";
  throw new TypeError(`${name}: expected an array of points, got ${describe(points)}${hint}`);
}

/**
 * Converts points of any form to one flat array, copied and checked.
 *
 * @internal
 * @param dimension the option of the caller
 * @param flatDimension the dimension of a flat array without that option
 */
export function flatten(points: PointsLike, dimension: unknown, flatDimension: 2 | 3, name = "points"): Flat {
  const requested = optionalDimension(dimension);
  requireList(points, name);
  if (ArrayBuffer.isView(points) || typeof points[0] === "number") {
    return fromNumbers(points as ArrayLike<unknown>, requested ?? flatDimension, name);
  }
  const list = points as ArrayLike<unknown>;
  return fromPoints(list, requested ?? (list.length ? dimensionOf(list[0], `${name}[0]`) : 2), name);
}

function fromNumbers(numbers: ArrayLike<unknown>, dimension: 2 | 3, name: string): Flat {
  if (numbers.length % dimension !== 0) {
    throw new RangeError(`${name}: expected a multiple of ${dimension} numbers (${dimension}D), got ${numbers.length}`);
  }
  const flat = new Float64Array(numbers.length);
  for (let i = 0; i < flat.length; i++) {
    const value = numbers[i];
    if (typeof value !== "number" || !isCoordinate(value)) coordinate(value, `${name}[${i}]`);
    flat[i] = value as number;
  }
  return { dimension, flat };
}

function fromPoints(list: ArrayLike<unknown>, dimension: 2 | 3, name: string): Flat {
  const flat = new Float64Array(list.length * dimension);
  for (let i = 0; i < list.length; i++) writePoint(flat, i * dimension, list[i], dimension, `${name}[${i}]`);
  return { dimension, flat };
}

/**
 * The dimension of a point: the length of an array; an object is 3D if it has a `z` but no `w` (as a DOMPoint has).
 *
 * @internal
 */
export function dimensionOf(point: unknown, name: string): 2 | 3 {
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
 */
export function writePoint(flat: Float64Array, at: number, point: unknown, dimension: 2 | 3, name: string) {
  if (isList(point)) {
    if (point.length !== dimension) {
      throw new RangeError(`${name}: expected ${dimension} coordinates, got ${point.length}`);
    }
    for (let i = 0; i < dimension; i++) flat[at + i] = coordinate(point[i], `${name}[${i}]`);
    return;
  }
  if (typeof point !== "object" || point === null) throw notAPoint(point, name);
  const { x, y, z } = point as { x: unknown; y: unknown; z?: unknown };
  flat[at] = coordinate(x, `${name}.x`);
  flat[at + 1] = coordinate(y, `${name}.y`);
  if (dimension === 3) flat[at + 2] = coordinate(z, `${name}.z`);
}

function notAPoint(value: unknown, name: string): TypeError {
  const hint = typeof value === "number" && !name.endsWith("]") ? "; did you mean [x, y]?" : "";
  return new TypeError(
    `${name}: expected a point ([x, y], [x, y, z], {x, y} or {x, y, z}), got ${describe(value)}${hint}`,
  );
}

/**
 * The point whose coordinates start at an index of a flat array.
 *
 * @internal
 */
export function pointAt<D extends 2 | 3>(flat: Float64Array, at: number, dimension: D): Point<D> {
  const [x, y] = [flat[at], flat[at + 1]];
  return (dimension === 2 ? { x, y } : { x, y, z: flat[at + 2] }) as Point<D>;
}

/**
 * All points of a flat array.
 *
 * @internal
 */
export function pointList<D extends 2 | 3>(flat: Float64Array, dimension: D): Point<D>[] {
  return Array.from({ length: flat.length / dimension }, (_, k) => pointAt(flat, k * dimension, dimension));
}

/**
 * A box from its two corners in a flat array.
 *
 * @internal
 */
export function boxAt<D extends 2 | 3>(flat: Float64Array, dimension: D): Bounds<D> {
  return { min: pointAt(flat, 0, dimension), max: pointAt(flat, dimension, dimension) };
}

/**
 * The points of a flat array as one array each, for JSON.
 *
 * @internal
 */
export function nested(flat: Float64Array, dimension: number): number[][] {
  const points: number[][] = [];
  for (let i = 0; i < flat.length; i += dimension) points.push([...flat.subarray(i, i + dimension)]);
  return points;
}

/**
 * Whether two flat arrays of points are equal within a distance.
 *
 * @internal
 */
export function samePoints(a: Float64Array, b: Float64Array, dimension: number, tolerance: unknown): boolean {
  const maxDistance = nonNegative(tolerance, "tolerance");
  if (a.length !== b.length) return false;
  for (let i = 0; i < a.length; i += dimension) {
    const z = dimension === 3 ? a[i + 2] - b[i + 2] : 0;
    if (!(Math.hypot(a[i] - b[i], a[i + 1] - b[i + 1], z) <= maxDistance)) return false;
  }
  return true;
}
