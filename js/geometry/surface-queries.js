// Questions that patches and surfaces are asked alike: a patch goes to the core as a surface of one patch.
import { Curve } from "./curve.js";
import { boxAt, pointAt, writePoint } from "./points.js";
import { core, load, take } from "../wasm/surfaces-transfer.js";
import { Checked } from "../wasm/transfer.js";

/**
 * @import { PointLike } from "./check.js"
 * @import { Point } from "./points.js"
 */

/**
 * Gaussian, mean and principal curvatures, k1 ≥ k2; positive where the surface bends toward its normal ∂u × ∂v.
 *
 * @typedef {{ gaussian: number, mean: number, k1: number, k2: number }} Curvature
 */

/**
 * De Casteljau's construction of a point: for each row of the net all levels at u, from the row's points to the row's
 * one point; then all levels at v of the curve that these points control; then the point.
 *
 * @typedef {{ rows: Float64Array[][], column: Float64Array[], point: Point }} PatchDeCasteljau
 */

/**
 * A point of a patch, and its distance from the point that was asked for or from the ray's origin.
 *
 * @typedef {{ u: number, v: number, point: Point, distance: number }} PatchPoint
 */

/**
 * The same of a surface, with the number of the patch.
 *
 * @typedef {PatchPoint & { patch: number }} SurfacePoint
 */

/**
 * Writes a surface to the arena, with room behind it, and says where it ends.
 *
 * @internal
 * @typedef {(extra: number) => { view: Float64Array, at: number }} Loader
 */

/** The numbers that the core leaves for a place: patch, u, v, the point, the distance. */
const PLACE = 7;

/**
 * A patch as a surface.
 *
 * @internal
 * @param {Float64Array} flat
 * @param {number} degreeU
 * @param {number} degreeV
 * @returns {Loader}
 */
export function patchLoader(flat, degreeU, degreeV) {
  const count = flat.length / 3;
  const at = 5 + 4 * count;
  return (extra) => {
    const view = load(Float64Array.of(count, 1, 0, degreeU, degreeV), at + extra - 5);
    view.set(flat, 5);
    for (let i = 0; i < count; i++) view[5 + 3 * count + i] = i;
    return { view, at };
  };
}

/**
 * @internal
 * @param {Loader} loader
 * @returns {{ min: Point, max: Point } | null}
 */
export function bounds(loader) {
  loader(0);
  const numbers = take(0, core().surface_bounds());
  return numbers.length ? boxAt(numbers, 3) : null;
}

/**
 * @internal
 * @param {Loader} loader
 * @returns {number}
 */
export function area(loader) {
  loader(0);
  return take(0, core().surface_area())[0];
}

/**
 * @internal
 * @param {Loader} loader
 * @returns {number | null}
 */
export function volume(loader) {
  loader(0);
  return take(0, core().surface_volume())[0] ?? null;
}

/**
 * @internal
 * @param {Loader} loader
 * @param {PointLike} point
 * @returns {SurfacePoint | null}
 */
export function nearest(loader, point) {
  const [p] = points([point, "point"]);
  const { view, at } = loader(3);
  view.set(p, at);
  return places(take(0, core().surface_nearest()))[0] ?? null;
}

/**
 * @internal
 * @param {Loader} loader
 * @param {PointLike} origin
 * @param {PointLike} direction
 * @returns {SurfacePoint[]}
 */
export function intersectRay(loader, origin, direction) {
  const [from, along] = points([origin, "origin"], [direction, "direction"]);
  const { view, at } = loader(6);
  view.set(from, at);
  view.set(along, at + 3);
  return places(take(0, core().surface_ray()));
}

/**
 * A place without the number of its patch.
 *
 * @internal
 * @param {SurfacePoint} place
 * @returns {PatchPoint}
 */
export function onPatch({ u, v, point, distance }) {
  return { u, v, point, distance };
}

/**
 * @internal
 * @param {Float64Array} flat
 * @param {number} columns
 * @param {number} u
 * @param {number} v
 * @returns {PatchDeCasteljau}
 */
export function deCasteljau(flat, columns, u, v) {
  const levels = (/** @type {Float64Array} */ row, /** @type {number} */ t) =>
    new Curve(/** @type {any} */ (new Checked(row, 3))).deCasteljau(t);
  const rows = [];
  for (let i = 0; i < flat.length; i += 3 * columns) rows.push(levels(flat.slice(i, i + 3 * columns), u));
  const ends = new Float64Array(3 * rows.length);
  rows.forEach((row, j) => ends.set(row[columns - 1], 3 * j));
  const column = levels(ends, v);
  return { rows, column, point: pointAt(column[rows.length - 1], 0, 3) };
}

/**
 * Points of space, checked.
 *
 * @param {[PointLike, string][]} given with their names
 * @returns {Float64Array[]}
 */
function points(...given) {
  return given.map(([point, name]) => {
    const numbers = new Float64Array(3);
    writePoint(numbers, 0, point, 3, name);
    return numbers;
  });
}

/**
 * @param {Float64Array} numbers
 * @returns {SurfacePoint[]}
 */
function places(numbers) {
  return Array.from({ length: numbers.length / PLACE }, (_, k) => {
    const [patch, u, v, x, y, z, distance] = numbers.subarray(PLACE * k, PLACE * (k + 1));
    return { patch, u, v, point: { x, y, z }, distance };
  });
}
