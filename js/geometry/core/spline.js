import { curveOf } from "./curve.js";
import { CoreSpline, joinCurves } from "../spline/core-spline.js";
import { CheckedSplineData, readSplineData, splineDataOf } from "../spline/spline-value.js";
import { CheckedPoints } from "../../wasm/transfer.js";

/**
 * @import { SplineData } from "../brand.js"
 * @import { Curve } from "./curve.js"
 * @import { CoreCurve } from "../curve/core-curve.js"
 * @import { SplineJSON } from "../spline/spline-value.js"
 */

/**
 * Bézier curves joined end to end. Segment k covers t from k to k + 1 and has its own degree.
 *
 *     const spline = new Spline([[0, 0], [0, 2], [2, 2], [2, 0], [2, -2], [4, -2], [4, 0]]);
 *     spline.continuity(1).c1; // true
 *
 * In TypeScript, `Spline<2>` and `Spline<3>` have points `{x, y}` and `{x, y, z}`, see `Curve`.
 *
 * @template {2 | 3} [D=2 | 3]
 * @extends {CoreSpline<D, Curve<D>>}
 */
export class Spline extends CoreSpline {
  /**
   * The spline of consecutive curves, whose degrees may differ.
   *
   * @template {2 | 3} [D=2 | 3]
   * @param {readonly CoreCurve<D>[]} curves curves that each start where the one before ends
   * @param {{ closed?: boolean }} [options] `closed`: whether the last curve ends where the first starts, false by default
   * @returns {Spline<D>}
   * @throws {RangeError} if a curve does not start at the end of the previous one
   */
  static fromCurves(curves, options) {
    const { length, dimension } = joinCurves(curves, options);
    return /** @type {Spline<D>} */ (splineOf(readSplineData(length, dimension)));
  }

  /**
   * @param {SplineJSON} json what `toJSON` returned
   * @returns {Spline}
   */
  static fromJSON(json) {
    return splineOf(splineDataOf(json));
  }

  /**
   * @internal
   * @override
   * @param {Float64Array} flat
   * @returns {Curve<D>}
   */
  _curveOf(flat) {
    return /** @type {Curve<D>} */ (curveOf(new CheckedPoints(flat, this.dimension)));
  }

  /**
   * @internal
   * @override
   * @param {SplineData} data
   * @returns {this}
   */
  _splineOf(data) {
    return /** @type {this} */ (splineOf(data));
  }
}

/**
 * @param {SplineData} data
 * @returns {Spline}
 */
function splineOf(data) {
  return new Spline(/** @type {any} */ (new CheckedSplineData(data))); // outside of the class, see ../curve/curve.js
}
