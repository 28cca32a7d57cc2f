import { CoreSpline } from "./core-spline.js";
import * as check from "../check.js";
import { readNearest } from "../curve-queries.js";
import { frameTimes, frameArguments, readFrames } from "../frames.js";
import { unwrapCount } from "../../wasm/errors.js";
import { core } from "../../wasm/init.js";
import { readResult, releaseMemory } from "../../wasm/transfer.js";

/**
 * @import { PointLike } from "../check.js"
 * @import { CoreCurve } from "../curve/core-curve.js"
 * @import { Nearest } from "../curve-queries.js"
 * @import { FrameOptions, Frames } from "../frames.js"
 */

/**
 * Lengths, areas, frames and nearest points of a spline.
 *
 * @template {CoreCurve} [C=CoreCurve]
 * @extends {CoreSpline<C>}
 */
export class SplineMeasures extends CoreSpline {
  /**
   * Rotation-minimising frames, see `Curve.frames`. At a corner they turn with the tangent, by the smaller angle. On a
   * closed spline, the last frame may differ from the first. 3D only.
   *
   * @param {number | ArrayLike<number>} where the number of segments per curve, as for `sample`, or values of t
   * @param {FrameOptions} [options]
   * @returns {Frames}
   */
  frames(where, options) {
    if (this.dimension === 2) throw new TypeError("frames: expected a 3D spline, got a 2D one");
    const ts = frameTimes(where, this.segmentCount);
    const args = frameArguments(ts, options);
    this._write(args);
    return readFrames(unwrapCount(core().spline_frames(ts.length, args.length > ts.length)));
  }

  /**
   * The arc length with a relative error below 10⁻¹².
   *
   * @param {number} [tolerance] the largest error, in the unit of the points, if it is to be smaller
   * @param {never[]} surplus
   * @returns {number}
   */
  length(tolerance, ...surplus) {
    check.noSurplus(surplus, "length", 1);
    const maxError = check.optionalTolerance(tolerance);
    return readResult(0, core().spline_length(this._write(), maxError))[0];
  }

  /**
   * The t, from 0 to the number of segments, at which the arc length from the start is s. An s outside of [0, length]
   * gives the nearer end.
   *
   * @param {number} s
   * @param {number} [tolerance] the largest error, as a length; by default 10⁻¹² of the spline's length
   * @returns {number}
   */
  timeAtLength(s, tolerance) {
    check.finite(s, "s");
    const maxError = check.optionalTolerance(tolerance);
    return readResult(0, core().spline_time_at_length(this._write(), s, maxError))[0];
  }

  /**
   * The values of t that divide the whole spline into arcs of equal length, independent of the joints.
   *
   * @param {number} segments
   * @returns {Float64Array} `segments` + 1 values, the first 0, the last the number of the spline's segments
   */
  equidistantTimes(segments) {
    check.segmentCount(segments);
    const ts = readResult(0, core().spline_equidistant_times(this._write(), segments));
    releaseMemory();
    return ts;
  }

  /**
   * The signed area swept by the line from the origin to the point of the spline, positive while that line turns
   * counter-clockwise (x right, y up). For a closed spline it is the enclosed area. 2D only.
   *
   * @returns {number}
   */
  area() {
    this._require2D("area");
    this._write();
    return core().spline_area();
  }

  /**
   * The point of the spline that is nearest to p; t runs from 0 to the number of segments. Of several nearest points,
   * it is the one with the smallest t.
   *
   * @param {PointLike} p
   * @returns {Nearest}
   */
  nearest(p) {
    core().spline_nearest(this._write(this._coordinates(p, "p")));
    return readNearest(this.dimension);
  }
}
