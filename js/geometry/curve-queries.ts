// Queries of curves: nearest points, parameters of given coordinates, extrema, tangents, distances.
import { curvesModule } from "../wasm/curves-module.js";
import { describe, finite, object } from "./check.js";
import { pointAt, writePoint } from "./points.js";
import type { PointLike } from "./check.js";
import type { Point } from "./points.js";

/** The point of a curve or a spline that is nearest to another point. */
export interface Nearest<D extends 2 | 3 = 2 | 3> {
  /** The parameter of the nearest point */
  t: number;
  /** The nearest point */
  point: Point<D>;
  /** Its distance from the other point */
  distance: number;
}

/**
 * See `Curve.nearest`.
 *
 * @internal
 */
export function nearest<D extends 2 | 3>(flat: Float64Array, dimension: D, p: PointLike): Nearest<D> {
  if (flat.length === 8) return nearestOnCubic(flat, p) as Nearest<D>;
  writePoint(curvesModule.write(flat, dimension), flat.length, p, dimension, "p");
  curvesModule.functions.curve_nearest(dimension, flat.length / dimension);
  return readNearest(dimension);
}

/** The coordinates of a point that is not an object with two finite numbers x and y. */
const checked = new Float64Array(2);

/**
 * The nearest point of a 2D cubic, the most common kind of curve, whose coordinates are passed as arguments; see
 * `cubicAt` in curve.js.
 */
function nearestOnCubic(c: Float64Array, p: PointLike): Nearest<2> {
  let { x, y } = (p ?? checked) as { x: number; y: number };
  if (typeof x !== "number" || typeof y !== "number" || x - x !== 0 || y - y !== 0) {
    writePoint(checked, 0, p, 2, "p");
    [x, y] = checked;
  }
  const t = curvesModule.functions.cubic_nearest(c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], x, y);
  const at = curvesModule.cubicEval;
  const point = { x: at(c[0], c[2], c[4], c[6], t), y: at(c[1], c[3], c[5], c[7], t) };
  const [dx, dy] = [point.x - x, point.y - y];
  const square = dx * dx + dy * dy; // Math.hypot takes as long as the rest of this function
  return { t, point, distance: square > 1e-280 && square < 1e280 ? Math.sqrt(square) : Math.hypot(dx, dy) };
}

/**
 * Reads the nearest point from the arena.
 *
 * @internal
 */
export function readNearest<D extends 2 | 3>(dimension: D): Nearest<D> {
  const numbers = curvesModule.arena(5);
  return { t: numbers[0], point: pointAt(numbers, 2, dimension), distance: numbers[1] };
}

/** The parameters of the inner extrema of each coordinate. */
export type Extrema = { x: Float64Array; y: Float64Array; z?: Float64Array };

/** The names of the coordinates. */
const AXES = ["x", "y", "z"] as const;

/**
 * See `Curve.extrema`.
 *
 * @internal
 */
export function extrema(flat: Float64Array, dimension: 2 | 3): Extrema {
  const timesOf = (_: string, axis: number) => {
    curvesModule.write(flat);
    return curvesModule.read(0, curvesModule.functions.curve_extrema(dimension, flat.length / dimension, axis));
  };
  const [x, y, z] = AXES.slice(0, dimension).map(timesOf);
  return dimension === 2 ? { x, y } : { x, y, z };
}

/**
 * See `Curve.timesAtCoordinate`.
 *
 * @internal
 */
export function timesAtCoordinate(
  flat: Float64Array,
  dimension: 2 | 3,
  where: { x: number } | { y: number } | { z: number },
): Float64Array {
  const [axis, value] = requestedCoordinate(where, dimension);
  curvesModule.write(flat);
  return curvesModule.read(
    0,
    curvesModule.functions.curve_times_at_coordinate(dimension, flat.length / dimension, axis, value),
  );
}

/**
 * The index and the value of the coordinate that a query names.
 *
 * @internal
 */
export function requestedCoordinate(where: unknown, dimension: number): [number, number] {
  const values = object(where as object, "where") as Record<string, unknown>;
  const axes = AXES.slice(0, dimension);
  const given = AXES.filter((name) => values[name] !== undefined);
  const axis = axes.indexOf(given[0]);
  if (axis < 0 || given.length > 1) {
    throw new TypeError(`where: expected exactly one of ${axes.join(", ")}, got ${describe(where)}`);
  }
  return [axis, finite(values[axes[axis]], axes[axis])];
}

/** The kind of a curve. */
export type CurveKind = "point" | "line" | "quadratic" | "arch" | "serpentine" | "loop" | "cusp" | "twisted";

/**
 * In the order of the core's codes.
 *
 * @internal
 */
export const CURVE_KINDS: readonly CurveKind[] = [
  "point",
  "line",
  "quadratic",
  "arch",
  "serpentine",
  "loop",
  "cusp",
  "twisted",
];

/**
 * See `Curve.tangentsFrom`.
 *
 * @internal
 */
export function tangentsFrom(flat: Float64Array, p: PointLike): Float64Array {
  writePoint(curvesModule.write(flat, 2), flat.length, p, 2, "p");
  return curvesModule.read(0, curvesModule.functions.curve_tangents_from(flat.length / 2));
}

/** The smallest distance of two curves, and where it occurs: at t on the first, at u on the second. */
export type Distance = { distance: number; t: number; u: number };

/**
 * See `Curve.distance`.
 *
 * @internal
 */
export function distance(flat: Float64Array, other: Float64Array, dimension: 2 | 3): Distance {
  curvesModule.write(flat, other.length).set(other, flat.length);
  curvesModule.functions.curve_distance(dimension, flat.length / dimension, other.length / dimension);
  const numbers = curvesModule.arena(3);
  return { distance: numbers[0], t: numbers[1], u: numbers[2] };
}

/**
 * See `Curve.hausdorff`.
 *
 * @internal
 */
export function hausdorff(flat: Float64Array, other: Float64Array, dimension: 2 | 3): number {
  curvesModule.write(flat, other.length).set(other, flat.length);
  return curvesModule.functions.curve_hausdorff(dimension, flat.length / dimension, other.length / dimension);
}
