// Queries of patches and surfaces: a patch is passed to the core as a surface of one patch.
import { surfacesModule } from "../wasm/surfaces-module.js";
import * as check from "./check.js";
import { boxAt, pointAt, writePoint } from "./points.js";
import type { MatrixLike, PointLike } from "./check.js";
import type { Bounds, Point } from "./points.js";

/** Gaussian, mean and principal curvatures, k1 ≥ k2; positive where the surface bends toward its normal ∂u × ∂v. */
export type Curvature = { gaussian: number; mean: number; k1: number; k2: number };

/**
 * All intermediate points of de Casteljau's algorithm for S(u, v): `rows`, for each row of the net all levels at u;
 * `column`, all levels at v of the curve whose control points are the last points of the rows; `point`, S(u, v).
 */
export type PatchDeCasteljau = { rows: Float64Array[][]; column: Float64Array[]; point: Point<3> };

/** A point of a patch, and its distance from the query point or from the ray's origin. */
export type PatchPoint = { u: number; v: number; point: Point<3>; distance: number };

/** A point of a surface, with the index of its patch. */
export type SurfacePoint = PatchPoint & { patch: number };

/**
 * Writes a surface to the arena with room for `extra` more numbers, and returns the arena and the index of that room.
 *
 * @internal
 */
export type SurfaceWriter = (extra: number) => { view: Float64Array; at: number };

/** The numbers of a point of a surface: patch, u, v, x, y, z, the distance. */
const RECORD_LENGTH = 7;

/**
 * Writes a patch as a surface.
 *
 * @internal
 */
export function patchWriter(flat: Float64Array, degreeU: number, degreeV: number): SurfaceWriter {
  const count = flat.length / 3;
  const at = 5 + 4 * count;
  return (extra) => {
    const view = surfacesModule.write(Float64Array.of(count, 1, 0, degreeU, degreeV), at + extra - 5);
    view.set(flat, 5);
    for (let i = 0; i < count; i++) view[5 + 3 * count + i] = i;
    return { view, at };
  };
}

/**
 * See `Surface.bounds`.
 *
 * @internal
 */
export function bounds(write: SurfaceWriter): Bounds<3> | null {
  write(0);
  const numbers = surfacesModule.read(0, surfacesModule.functions.surface_bounds());
  return numbers.length ? boxAt(numbers, 3) : null;
}

/**
 * See `Surface.area`.
 *
 * @internal
 */
export function area(write: SurfaceWriter): number {
  write(0);
  return surfacesModule.read(0, surfacesModule.functions.surface_area())[0];
}

/**
 * See `Surface.volume`.
 *
 * @internal
 */
export function volume(write: SurfaceWriter): number | null {
  write(0);
  return surfacesModule.read(0, surfacesModule.functions.surface_volume())[0] ?? null;
}

/**
 * See `Surface.nearest`.
 *
 * @internal
 */
export function nearest(write: SurfaceWriter, point: PointLike): SurfacePoint | null {
  const [p] = coordinatesOf([point, "point"]);
  const { view, at } = write(3);
  view.set(p, at);
  return readPoints(surfacesModule.read(0, surfacesModule.functions.surface_nearest()))[0] ?? null;
}

/**
 * See `Surface.intersectRay`.
 *
 * @internal
 */
export function intersectRay(write: SurfaceWriter, origin: PointLike, direction: PointLike): SurfacePoint[] {
  const [start, along] = coordinatesOf([origin, "origin"], [direction, "direction"]);
  const { view, at } = write(6);
  view.set(start, at);
  view.set(along, at + 3);
  return readPoints(surfacesModule.read(0, surfacesModule.functions.surface_ray()));
}

/**
 * The 16 numbers of a projection, of 6 numbers of the plane or 16.
 *
 * @internal
 */
export function projectionNumbers(matrix: MatrixLike): ArrayLike<number> {
  const m = check.matrixNumbers(matrix);
  return m.length === 6 ? [m[0], m[1], 0, 0, m[2], m[3], 0, 0, 0, 0, 1, 0, m[4], m[5], 0, 1] : m;
}

/**
 * A point of a surface without the index of its patch.
 *
 * @internal
 */
export function withoutPatch({ u, v, point, distance }: SurfacePoint): PatchPoint {
  return { u, v, point, distance };
}

/**
 * The points of de Casteljau's algorithm on a net.
 *
 * @internal
 * @param levels all levels at t of a curve
 */
export function deCasteljau(
  flat: Float64Array,
  columns: number,
  u: number,
  v: number,
  levels: (row: Float64Array, t: number) => Float64Array[],
): PatchDeCasteljau {
  const rows: Float64Array[][] = [];
  for (let i = 0; i < flat.length; i += 3 * columns) rows.push(levels(flat.slice(i, i + 3 * columns), u));
  const ends = new Float64Array(3 * rows.length);
  rows.forEach((row, j) => ends.set(row[columns - 1], 3 * j));
  const column = levels(ends, v);
  return { rows, column, point: pointAt(column[rows.length - 1], 0, 3) };
}

/**
 * The coordinates of 3D points, checked.
 *
 * @internal
 * @param named the points with their names for messages
 */
export function coordinatesOf(...named: [PointLike, string][]): Float64Array[] {
  return named.map(([point, name]) => {
    const numbers = new Float64Array(3);
    writePoint(numbers, 0, point, 3, name);
    return numbers;
  });
}

/**
 * The points of a surface that the core has written.
 *
 * @internal
 */
export function readPoints(numbers: Float64Array): SurfacePoint[] {
  return Array.from({ length: numbers.length / RECORD_LENGTH }, (_, k) => {
    const [patch, u, v, x, y, z, distance] = numbers.subarray(RECORD_LENGTH * k, RECORD_LENGTH * (k + 1));
    return { patch, u, v, point: { x, y, z }, distance };
  });
}
