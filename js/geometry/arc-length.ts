// Arc length of curves, and points at arc lengths.
import { curvesModule } from "../wasm/curves-module.js";
import * as check from "./check.js";
import type { Point } from "./points.js";

/** A point of a curve or a spline at an arc length: its parameter, the point, the unit tangent and the unit normal. */
export type PointAtLength<D extends 2 | 3 = 2 | 3> = {
  t: number;
  point: Point<D>;
  tangent: Point<D>;
  normal: Point<D>;
};

/**
 * The point, the unit tangent and the unit normal of a curve or a spline at t.
 *
 * @internal
 */
export function pointAndDirections<D extends 2 | 3>(
  curve: { dimension: D; eval(t: number): Point<D>; tangent(t: number): Point<D>; normal(t: number): Point<D> },
  t: number,
): PointAtLength<D> {
  const [point, tangent] = [curve.eval(t), curve.tangent(t)];
  if (curve.dimension === 3) return { t, point, tangent, normal: curve.normal(t) };
  const normal = { x: 0 - tangent.y, y: tangent.x } as Point<D>;
  return { t, point, tangent, normal };
}

/**
 * The arc length of a curve.
 *
 * @internal
 */
export function curveLength(p: Float64Array, dimension: 2 | 3, tolerance: number | undefined): number {
  // The coordinates of a 2D cubic, the most common kind of curve, are passed as arguments; this function has no
  // tolerance.
  if (tolerance === undefined && p.length === 8 && dimension === 2) {
    return curvesModule.functions.cubic_length(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7]);
  }
  const maxError = check.optionalTolerance(tolerance);
  curvesModule.write(p);
  return curvesModule.read(0, curvesModule.functions.curve_length(dimension, p.length / dimension, maxError))[0];
}

/**
 * The t at an arc length.
 *
 * @internal
 */
export function curveTimeAtLength(p: Float64Array, dimension: 2 | 3, s: number, tolerance: number | undefined): number {
  check.finite(s, "s");
  const maxError = check.optionalTolerance(tolerance);
  curvesModule.write(p);
  return curvesModule.read(
    0,
    curvesModule.functions.curve_time_at_length(dimension, p.length / dimension, s, maxError),
  )[0];
}
