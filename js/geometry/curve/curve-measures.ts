import { curveLength, curveTimeAtLength, pointAndDirections } from "../arc-length.js";
import * as check from "../check.js";
import { CoreCurve } from "./core-curve.js";
import * as queries from "../curve-queries.js";
import { frameTimes, frameArguments, readFrames } from "../frames.js";
import { unwrapCount } from "../../wasm/errors.js";
import { core } from "../../wasm/init.js";
import { readLargeResult, readResult } from "../../wasm/transfer.js";
import type { PointAtLength } from "../arc-length.js";
import type { PointLike } from "../check.js";
import type { CurveKind, Extrema } from "../curve-queries.js";
import type { FrameOptions, Frames } from "../frames.js";

/** Lengths, areas, frames and special parameters of one curve. */
export class CurveMeasures<D extends 2 | 3 = 2 | 3> extends CoreCurve<D> {
  /**
   * The torsion (B′ × B″)·B‴ / |B′ × B″|² at t: the angle per length by which the osculating plane turns about the
   * tangent, positive for a right-handed helix. It is 0 in 2D and for planar curves. Where B′ × B″ vanishes, it is the
   * limit, which may be infinite.
   *
   * @param t the parameter, from 0 to 1; others extrapolate
   */
  torsion(t: number): number {
    check.finite(t, "t");
    return this.dimension === 2 ? 0 : core().curve_torsion(this._write(), t);
  }

  /**
   * Rotation-minimising frames: the normals do not rotate about the tangents (error below 10⁻⁹), also at inflections,
   * straight pieces and cusps. 3D only.
   *
   *     const { points, tangents, normals } = path.frames(path.equidistantTimes(100), { normal: [0, 0, 1] }); // a camera path
   *
   * Frames are continued from t = 0; the frame at a t does not depend on the other ones. Steps are halved at most 4096
   * times, and 63 times more for each frame (512 times outside 0 to 1).
   *
   * @param where the number of segments n for frames at t = i/n, or values of t
   */
  frames(where: number | ArrayLike<number>, options?: FrameOptions): Frames {
    if (this.dimension === 2) throw new TypeError("frames: expected a 3D curve, got a 2D one");
    const ts = frameTimes(where, 1);
    const args = frameArguments(ts, options);
    const count = this._write(args);
    return readFrames(unwrapCount(core().curve_frames(count, ts.length, args.length > ts.length)));
  }

  /**
   * The arc length ∫ |B′(t)| dt with a relative error below 10⁻¹², also for cusps and curves that turn back.
   *
   * At most 4096 intervals are integrated, more than ten times as many as coordinates of moderate size need.
   *
   * @param tolerance the largest error, in the unit of the points, if it is to be smaller
   * @returns 0 if all control points are equal
   * @throws {RangeError} for a tolerance not above 0 or below 4 ulps of the largest coordinate
   */
  length(tolerance?: number, ...surplus: never[]): number {
    check.noSurplus(surplus, "length", 1, "subsegment(t0, t1).length()");
    return curveLength(this._flat, this.dimension, tolerance);
  }

  /**
   * The t at which the arc length from the start is s. An s outside of [0, length] gives the nearer end.
   *
   * @param s the length, in the unit of the points
   * @param tolerance the largest error, as a length; by default 10⁻¹² of the curve's length
   * @returns 0 to 1
   */
  timeAtLength(s: number, tolerance?: number): number {
    return curveTimeAtLength(this._flat, this.dimension, s, tolerance);
  }

  /**
   * The point at the arc length s from the start, with its t, unit tangent and unit normal: what text along a curve or
   * an object that moves at constant speed needs. An s outside of [0, length] gives the nearer end. If all control
   * points are equal, t is 0 and both directions are zero.
   *
   * It costs as much as `timeAtLength`, `eval`, `tangent` and `normal` together.
   *
   * @param s in the unit of the points
   * @throws {RangeError} for a NaN or an infinity
   */
  pointAtLength(s: number, ...surplus: never[]): PointAtLength<D> {
    check.noSurplus(surplus, "pointAtLength", 1);
    return pointAndDirections(this, this.timeAtLength(s));
  }

  /**
   * The values of t that divide the curve into arcs of equal length.
   *
   *     curve.evalAt(curve.equidistantTimes(100)); // 101 points, evenly spaced along the curve
   *
   * @param segments how many parts, at least 1
   * @returns `segments` + 1 values, the first 0, the last 1
   */
  equidistantTimes(segments: number): Float64Array {
    check.segmentCount(segments);
    return readLargeResult(core().curve_equidistant_times(this.dimension, this._write(), segments));
  }

  /**
   * The signed area ½ ∫ (x dy − y dx) swept by the line from the origin to the point of the curve, positive while that
   * line turns counter-clockwise (x right, y up). The areas of the segments of an outline add up to its area. 2D only.
   */
  area(...surplus: never[]): number {
    check.noSurplus(surplus, "area", 0);
    this._require2D("area");
    return core().curve_area(this._write());
  }

  /** The parameters inside (0, 1) where a coordinate has a local extremum (its derivative changes sign), sorted. */
  extrema(...surplus: never[]): Extrema {
    check.noSurplus(surplus, "extrema", 0);
    return queries.extrema(this._flat, this.dimension);
  }

  /**
   * All parameters in [0, 1] at which a coordinate has the given value, end points and tangencies included, sorted. If
   * the coordinate has that value everywhere: 0 and 1, the ends of the range.
   *
   * @param where one coordinate and its value
   */
  timesAtCoordinate(where: { x: number } | { y: number } | { z: number }): Float64Array {
    return queries.timesAtCoordinate(this._flat, this.dimension, where);
  }

  /** The parameters inside (0, 1) where the curvature changes sign, sorted; 2D only. */
  inflections(): Float64Array {
    this._require2D("inflections");
    return readResult(0, core().curve_inflections(this._write()));
  }

  /** The parameters inside (0, 1) of cusps, where the tangent reverses its direction, sorted. */
  cusps(): Float64Array {
    return readResult(0, core().curve_cusps(this.dimension, this._write()));
  }

  /**
   * The kind of curve for t from 0 to 1, independent of its size. A planar 3D curve is classified in its plane; a 3D
   * curve that is not planar is "twisted".
   */
  classify(): CurveKind {
    return queries.CURVE_KINDS[core().curve_classify(this.dimension, this._write())];
  }

  /**
   * All parameters in [0, 1] at which the tangent line passes through p, sorted; 2D only. If all tangents do, because
   * the curve is straight: 0 and 1, the ends of the range. Where the derivative almost vanishes (below 1e-7 of the
   * largest control vector of the derivative), the limit of the tangent must pass through p within 1e-7 of the curve's
   * size.
   *
   * @param p the point, in the unit of the points
   */
  tangentsFrom(p: PointLike): Float64Array {
    this._require2D("tangentsFrom");
    return queries.tangentsFrom(this._flat, p);
  }
}
