// Conversion between B-splines and splines of Bézier curves.
import { curvesModule } from "../wasm/curves-module.js";
import * as check from "./check.js";
import { flatten } from "./points.js";
import type { PointsLike } from "./check.js";
import type { SplineData } from "./brand.js";

/** The properties of a B-spline besides its control points. */
export interface BSplineOptions {
  /** 1 to 64, by default 3 */
  degree?: number;
  closed?: boolean;
  /**
   * In ascending order: degree + 1 more than there are points; if closed, one more (the joints of one period). By
   * default 0, 1, 2, …
   */
  knots?: ArrayLike<number>;
  dimension?: 2 | 3;
}

/**
 * A B-spline with the arguments of `Spline.fromBSpline(points, options)`: `const { points, ...options } =
 * spline.toBSpline()`.
 */
export type BSpline = { points: Float64Array; knots: Float64Array; degree: number; closed: boolean; dimension: 2 | 3 };

/**
 * Computes the Bézier form of a B-spline and leaves it in the arena.
 *
 * @internal
 */
export function fromBSpline(points: PointsLike, options?: BSplineOptions): { length: number; dimension: 2 | 3 } {
  const checked = check.options(options, ["degree", "closed", "knots", "dimension"]);
  const { degree = 3, knots: customKnots, dimension: requested } = checked;
  const closed = check.optionalBoolean(checked.closed, "closed");
  check.whole(degree, "degree", 1, 64);
  const { flat, dimension } = flatten(points, requested, 2);
  const count = flat.length / dimension;
  const knots = customKnots === undefined ? new Float64Array(0) : check.numbers(customKnots, "knots");
  if (customKnots !== undefined && knots.length === 0) {
    const needed = count + 1 + (closed ? 0 : degree);
    throw new RangeError(`knots: expected ${needed} (for ${count} points of degree ${degree}), got 0`);
  }
  curvesModule.write(flat, knots.length).set(knots, flat.length);
  return {
    length: curvesModule.functions.spline_from_bspline(dimension, count, degree, closed, knots.length),
    dimension,
  };
}

/**
 * A spline as a B-spline with the same control points, whose knots are the joints with the degree as multiplicity.
 *
 * @internal
 */
export function toBSpline({ flat, dimension, degrees, closed }: SplineData): BSpline {
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
  const first = closed ? 0 : 1; // clamped: the first and the last knot have one more than the degree as multiplicity
  const knots = new Float64Array(count + 1 + (closed ? 0 : degree));
  for (let i = 0; i < knots.length; i++) {
    knots[i] = Math.min(Math.max(Math.floor((i - first) / degree), 0), degrees.length);
  }
  return { points, knots, degree, closed, dimension };
}
