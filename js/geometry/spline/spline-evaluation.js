import * as check from "../check.js";
import { boxAt } from "../points.js";
import { SplineValue } from "./spline-value.js";
import { core } from "../../wasm/init.js";
import { readPolyline, readResult, readResultInto, releaseMemory } from "../../wasm/transfer.js";

/**
 * @import { CoreCurve } from "../curve/core-curve.js"
 * @import { Point } from "../points.js"
 */

/**
 * Points of a spline at given parameters, its polylines and boxes.
 *
 * @template {CoreCurve} [C=CoreCurve]
 * @extends {SplineValue<C>}
 */
export class SplineEvaluation extends SplineValue {
  /**
   * The point at t, from 0 to the number of segments.
   *
   * @param {number} t
   * @returns {Point}
   */
  eval(t) {
    check.finite(t, "t");
    core().spline_eval(this._write(), t);
    return this._readPoint();
  }

  /**
   * Points at equally spaced t, both ends included.
   *
   * @param {number} segmentsPerCurve
   * @param {{ into?: Float64Array }} [options]
   * @returns {Float64Array}
   */
  sample(segmentsPerCurve, options) {
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
   * @param {ArrayLike<number>} ts
   * @param {{ into?: Float64Array }} [options]
   * @returns {Float64Array}
   */
  evalAt(ts, options) {
    const parameters = check.numbers(ts, "ts");
    const length = parameters.length * this.dimension;
    const into = check.resultArray(check.options(options, ["into"]).into, length);
    core().spline_eval_at(this._write(parameters), parameters.length);
    return readResultInto(into, length);
  }

  /**
   * A polyline whose distance from the spline is nowhere greater than `tolerance`; joints are vertices.
   *
   * @param {number} tolerance
   * @param {never[]} surplus
   * @returns {{ points: Float64Array, ts: Float64Array }}
   */
  flatten(tolerance, ...surplus) {
    check.noSurplus(surplus, "flatten", 1);
    check.positive(tolerance, "tolerance");
    return readPolyline(core().spline_flatten(this._write(), tolerance), this.dimension);
  }

  /**
   * The smallest box that contains the spline.
   *
   * @returns {{ min: Point, max: Point }}
   */
  bounds() {
    core().spline_bounds(this._write(), true);
    return boxAt(readResult(0, 6), this.dimension);
  }

  /**
   * The box of the control points.
   *
   * @returns {{ min: Point, max: Point }}
   */
  controlBounds() {
    core().spline_bounds(this._write(), false);
    return boxAt(readResult(0, 6), this.dimension);
  }
}
