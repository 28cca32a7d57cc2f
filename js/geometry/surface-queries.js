// Queries of patches and surfaces: a patch is passed to the core as a surface of one patch.
import { boxAt, pointAt, writePoint } from "./points.js";
import { core, writeArguments, readResult } from "../wasm/surfaces-transfer.js";

/**
 * @import { PointLike } from "./check.js"
 * @import { Bounds, Point } from "./points.js"
 */

/**
 * Gaussian, mean and principal curvatures, k1 ≥ k2; positive where the surface bends toward its normal ∂u × ∂v.
 *
 * @typedef {{ gaussian: number, mean: number, k1: number, k2: number }} Curvature
 */

/**
 * All intermediate points of de Casteljau's algorithm for S(u, v): `rows`, for each row of the net all levels at u;
 * `column`, all levels at v of the curve whose control points are the last points of the rows; `point`, S(u, v).
 *
 * @typedef {{ rows: Float64Array[][], column: Float64Array[], point: Point<3> }} PatchDeCasteljau
 */

/**
 * A point of a patch, and its distance from the query point or from the ray's origin.
 *
 * @typedef {{ u: number, v: number, point: Point<3>, distance: number }} PatchPoint
 */

/**
 * A point of a surface, with the index of its patch.
 *
 * @typedef {PatchPoint & { patch: number }} SurfacePoint
 */

/**
 * Writes a surface to the arena with room for `extra` more numbers, and returns the arena and the index of that room.
 *
 * @internal
 * @typedef {(extra: number) => { view: Float64Array, at: number }} SurfaceWriter
 */

/** The numbers of a point of a surface: patch, u, v, x, y, z, the distance. */
const RECORD_LENGTH = 7;

/**
 * Writes a patch as a surface.
 *
 * @internal
 * @param {Float64Array} flat
 * @param {number} degreeU
 * @param {number} degreeV
 * @returns {SurfaceWriter}
 */
export function patchWriter(flat, degreeU, degreeV) {
  const count = flat.length / 3;
  const at = 5 + 4 * count;
  return (extra) => {
    const view = writeArguments(Float64Array.of(count, 1, 0, degreeU, degreeV), at + extra - 5);
    view.set(flat, 5);
    for (let i = 0; i < count; i++) view[5 + 3 * count + i] = i;
    return { view, at };
  };
}

/**
 * @internal
 * @param {SurfaceWriter} write
 * @returns {Bounds<3> | null}
 */
export function bounds(write) {
  write(0);
  const numbers = readResult(0, core().surface_bounds());
  return numbers.length ? boxAt(numbers, 3) : null;
}

/**
 * @internal
 * @param {SurfaceWriter} write
 * @returns {number}
 */
export function area(write) {
  write(0);
  return readResult(0, core().surface_area())[0];
}

/**
 * @internal
 * @param {SurfaceWriter} write
 * @returns {number | null}
 */
export function volume(write) {
  write(0);
  return readResult(0, core().surface_volume())[0] ?? null;
}

/**
 * @internal
 * @param {SurfaceWriter} write
 * @param {PointLike} point
 * @returns {SurfacePoint | null}
 */
export function nearest(write, point) {
  const [p] = coordinatesOf([point, "point"]);
  const { view, at } = write(3);
  view.set(p, at);
  return readPoints(readResult(0, core().surface_nearest()))[0] ?? null;
}

/**
 * @internal
 * @param {SurfaceWriter} write
 * @param {PointLike} origin
 * @param {PointLike} direction
 * @returns {SurfacePoint[]}
 */
export function intersectRay(write, origin, direction) {
  const [start, along] = coordinatesOf([origin, "origin"], [direction, "direction"]);
  const { view, at } = write(6);
  view.set(start, at);
  view.set(along, at + 3);
  return readPoints(readResult(0, core().surface_ray()));
}

/**
 * A point of a surface without the index of its patch.
 *
 * @internal
 * @param {SurfacePoint} point
 * @returns {PatchPoint}
 */
export function withoutPatch({ u, v, point, distance }) {
  return { u, v, point, distance };
}

/**
 * @internal
 * @param {Float64Array} flat
 * @param {number} columns
 * @param {number} u
 * @param {number} v
 * @param {(row: Float64Array, t: number) => Float64Array[]} levels all levels at t of a curve
 * @returns {PatchDeCasteljau}
 */
export function deCasteljau(flat, columns, u, v, levels) {
  const rows = [];
  for (let i = 0; i < flat.length; i += 3 * columns) rows.push(levels(flat.slice(i, i + 3 * columns), u));
  const ends = new Float64Array(3 * rows.length);
  rows.forEach((row, j) => ends.set(row[columns - 1], 3 * j));
  const column = levels(ends, v);
  return { rows, column, point: pointAt(column[rows.length - 1], 0, 3) };
}

/**
 * The coordinates of 3D points, checked.
 *
 * @param {[PointLike, string][]} named the points with their names for messages
 * @returns {Float64Array[]}
 */
function coordinatesOf(...named) {
  return named.map(([point, name]) => {
    const numbers = new Float64Array(3);
    writePoint(numbers, 0, point, 3, name);
    return numbers;
  });
}

/**
 * @param {Float64Array} numbers
 * @returns {SurfacePoint[]}
 */
function readPoints(numbers) {
  return Array.from({ length: numbers.length / RECORD_LENGTH }, (_, k) => {
    const [patch, u, v, x, y, z, distance] = numbers.subarray(RECORD_LENGTH * k, RECORD_LENGTH * (k + 1));
    return { patch, u, v, point: { x, y, z }, distance };
  });
}
