import * as check from "../check.js";
import { boxAt } from "../points.js";
import { SplineValue } from "./spline-value.js";
import { core } from "../../wasm/init.js";
import { readPolyline, readResult, readResultInto, releaseMemory } from "../../wasm/transfer.js";
import type { CoreCurve } from "../curve/core-curve.js";
import type { Bounds, Point } from "../points.js";

/**
 * Points and derivatives of a spline at given parameters, its polylines and boxes. The parameter t runs from 0 to the
 * number of segments; values outside extrapolate the first and the last segment.
 */
export class SplineEvaluation<D extends 2 | 3 = 2 | 3, C extends CoreCurve<D> = CoreCurve<D>> extends SplineValue<
  D,
  C
> {
  /** The smallest and the largest coordinates, once asked for */
  #bounds: Float64Array | undefined;

  /**
   * The point at t, from 0 to the number of segments.
   *
   * @param t the parameter, from 0 to the number of segments; others extrapolate
   */
  eval(t: number): Point<D> {
    const { segment, rest } = this._locate(t);
    return segment.eval(rest);
  }

  /**
   * The k-th derivative with respect to t; k = 0 is the point itself. At a joint the segment that starts there counts,
   * at the end the last segment. It is zero if k is greater than the degree of the segment.
   *
   * @param t 0 to the number of segments
   * @param k 1 by default
   * @returns in the unit of the points
   * @throws {RangeError} for a t that is not finite, and a k that is negative or no integer
   */
  derivativeAt(t: number, k = 1): Point<D> {
    const { segment, rest } = this._locate(t);
    return segment.derivativeAt(rest, k);
  }

  /**
   * The unit tangent at t, see `Curve.tangent`. At a joint the segment that starts there counts, at the end the last
   * segment. It is zero if all control points of that segment are equal.
   *
   * @param t 0 to the number of segments
   * @throws {RangeError} for a t that is not finite
   */
  tangent(t: number): Point<D> {
    const { segment, rest } = this._locate(t);
    return segment.tangent(rest);
  }

  /**
   * The unit normal at t: in 2D the tangent turned by +90°, (x, y) → (−y, x); in 3D the principal normal, which is zero
   * where the spline is straight. At a joint the segment that starts there counts, at the end the last segment.
   *
   * @param t 0 to the number of segments
   * @throws {RangeError} for a t that is not finite
   */
  normal(t: number): Point<D> {
    const { segment, rest } = this._locate(t);
    return segment.normal(rest);
  }

  /**
   * The curvature at t: in 2D positive when turning counter-clockwise (x right, y up), in 3D never negative. At a joint
   * the segment that starts there counts, at the end the last segment. Infinite at a cusp.
   *
   * @param t 0 to the number of segments
   * @returns in 1 / unit of the points
   * @throws {RangeError} for a t that is not finite
   */
  curvature(t: number): number {
    const { segment, rest } = this._locate(t);
    return segment.curvature(rest);
  }

  /**
   * Points at equally spaced t, both ends included.
   *
   * @param segmentsPerCurve how many parts for each segment, at least 1
   * @param options `into`: an array for the result, long enough
   */
  sample(segmentsPerCurve: number, options?: { into?: Float64Array }): Float64Array {
    check.segmentCount(segmentsPerCurve, "segmentsPerCurve");
    const into = check.options(options, ["into"]).into;
    const length = (segmentsPerCurve * this.segmentCount + 1) * this.dimension;
    if (into !== undefined) check.resultArray(into, length);
    const count = core().spline_sample(this._write(), segmentsPerCurve);
    const result = into ? readResultInto(into, count) : readResult(0, count);
    releaseMemory();
    return result;
  }

  /**
   * The points at the given parameters.
   *
   * @param ts the parameters
   * @param options `into`: an array for the result, long enough
   */
  evalAt(ts: ArrayLike<number>, options?: { into?: Float64Array }): Float64Array {
    const parameters = check.numbers(ts, "ts");
    const length = parameters.length * this.dimension;
    const into = check.resultArray(check.options(options, ["into"]).into, length);
    core().spline_eval_at(this._write(parameters), parameters.length);
    return readResultInto(into, length);
  }

  /**
   * A polyline whose distance from the spline is nowhere greater than `tolerance`; joints are vertices.
   *
   * @param tolerance the largest distance, in the unit of the points
   */
  flatten(tolerance: number, ...surplus: never[]): { points: Float64Array; ts: Float64Array } {
    check.noSurplus(surplus, "flatten", 1);
    check.positive(tolerance, "tolerance");
    return readPolyline(core().spline_flatten(this._write(), tolerance), this.dimension);
  }

  /** The smallest box that contains the spline. */
  bounds(...surplus: never[]): Bounds<D> {
    check.noSurplus(surplus, "bounds", 0, "subsegment(t0, t1).bounds()");
    if (!this.#bounds) {
      core().spline_bounds(this._write(), true);
      this.#bounds = readResult(0, 6);
    }
    return boxAt(this.#bounds, this.dimension);
  }

  /** The box of the control points. */
  controlBounds(): Bounds<D> {
    core().spline_bounds(this._write(), false);
    return boxAt(readResult(0, 6), this.dimension);
  }
}
