import { curveOf } from "./curve.js";
import { CoreSpline, joinCurves, CheckedSplineData, readSplineData, splineDataOf } from "../spline/core-spline.js";
import { CheckedPoints } from "../../wasm/transfer.js";
import type { SplineData } from "../brand.js";
import type { Curve } from "./curve.js";
import type { CoreCurve } from "../curve/core-curve.js";
import type { SplineJSON } from "../spline/core-spline.js";

/**
 * Bézier curves joined end to end. Segment k covers t from k to k + 1 and has its own degree.
 *
 *     const spline = new Spline([[0, 0], [0, 2], [2, 2], [2, 0], [2, -2], [4, -2], [4, 0]]);
 *     spline.continuity(1).c1; // true
 *
 * In TypeScript, `Spline<2>` and `Spline<3>` have points `{x, y}` and `{x, y, z}`, see `Curve`.
 */
export class Spline<D extends 2 | 3 = 2 | 3> extends CoreSpline<D, Curve<D>> {
  /**
   * The spline of consecutive curves, whose degrees may differ.
   *
   * @param curves curves that each start where the one before ends
   * @param options `closed`: whether the last curve ends where the first starts, false by default
   * @throws {RangeError} if a curve does not start at the end of the previous one
   */
  static fromCurves<D extends 2 | 3 = 2 | 3>(
    curves: readonly CoreCurve<D>[],
    options?: { closed?: boolean },
  ): Spline<D> {
    const { length, dimension } = joinCurves(curves, options);
    return splineOf(readSplineData(length, dimension)) as Spline<D>;
  }

  /**
   * @param json what `toJSON` returned
   */
  static fromJSON(json: SplineJSON): Spline {
    return splineOf(splineDataOf(json));
  }

  /**
   * @internal
   */
  override _curveOf(flat: Float64Array): Curve<D> {
    return curveOf(new CheckedPoints(flat, this.dimension)) as Curve<D>;
  }

  /**
   * @internal
   */
  override _splineOf(data: SplineData): this {
    return splineOf(data) as this;
  }
}

function splineOf(data: SplineData): Spline {
  return new Spline(new CheckedSplineData(data) as any); // outside of the class, see ../curve/curve.js
}
