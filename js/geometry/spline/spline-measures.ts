import { pointAndDirections } from "../arc-length.js";
import * as check from "../check.js";
import { arcLengthsOf, segmentAtLength } from "./arc-length-table.js";
import { CoreSpline } from "./core-spline.js";
import { SegmentTree } from "../segment-tree.js";
import { splineExtrema, splineTimesAtCoordinate } from "./spline-coordinates.js";
import { frameTimes, frameArguments, readFrames } from "../frames.js";
import { unwrapCount } from "../../wasm/errors.js";
import { core } from "../../wasm/init.js";
import { readResult, releaseMemory } from "../../wasm/transfer.js";
import type { PointAtLength } from "../arc-length.js";
import type { PointLike } from "../check.js";
import type { CurveMeasures } from "../curve/curve-measures.js";
import type { Extrema, Nearest } from "../curve-queries.js";
import type { FrameOptions, Frames } from "../frames.js";

/** Lengths, areas, frames and nearest points of a spline. */
export class SplineMeasures<D extends 2 | 3 = 2 | 3, C extends CurveMeasures<D> = CurveMeasures<D>> extends CoreSpline<
  D,
  C
> {
  #arcLengths: Float64Array | undefined;
  #tree: SegmentTree | undefined;
  /** The smallest tolerance that the core has accepted. */
  #acceptedTolerance = Infinity;

  /**
   * The torsion at t, see `Curve.torsion`. At a joint the segment that starts there counts, at the end the last
   * segment. It is 0 in 2D and on planar segments.
   *
   * @param t 0 to the number of segments; values outside extrapolate the first and the last segment
   * @returns in 1 / unit of the points
   * @throws {RangeError} for a t that is not finite
   */
  torsion(t: number): number {
    const { segment, rest } = this._locate(t);
    return segment.torsion(rest);
  }

  /**
   * Rotation-minimising frames, see `Curve.frames`. At a corner they turn with the tangent, by the smaller angle. On a
   * closed spline the last frame equals the first: the difference is spread over the length. 3D only.
   *
   * @param where the number of segments per curve, as for `sample`, or values of t
   */
  frames(where: number | ArrayLike<number>, options?: FrameOptions): Frames {
    if (this.dimension === 2) throw new TypeError("frames: expected a 3D spline, got a 2D one");
    const ts = frameTimes(where, this.segmentCount);
    const args = frameArguments(ts, options);
    this._write(args);
    return readFrames(unwrapCount(core().spline_frames(ts.length, args.length > ts.length)));
  }

  /**
   * The arc length with a relative error below 10⁻¹². Without a tolerance, further calls return the same number at once.
   *
   * @param tolerance the largest error, in the unit of the points, if it is to be smaller
   */
  length(tolerance?: number, ...surplus: never[]): number {
    check.noSurplus(surplus, "length", 1);
    if (tolerance === undefined) return this._arcLengths[this.segmentCount];
    const maxError = check.optionalTolerance(tolerance);
    return readResult(0, core().spline_length(this._write(), maxError))[0];
  }

  /**
   * The t, from 0 to the number of segments, at which the arc length from the start is s. An s outside of [0, length]
   * gives the nearer end. If all control points are equal, it is 0.
   *
   * The first call measures all segments. Further ones, unless they have a smaller tolerance than all before, search for
   * the segment and then examine only this one.
   *
   * @param s in the unit of the points
   * @param tolerance the largest error, as a length; by default 10⁻¹² of the spline's length
   */
  timeAtLength(s: number, tolerance?: number): number {
    check.finite(s, "s");
    const maxError = check.optionalTolerance(tolerance);
    if (tolerance !== undefined && tolerance < this.#acceptedTolerance) {
      const [t] = readResult(0, core().spline_time_at_length(this._write(), s, maxError));
      this.#acceptedTolerance = tolerance;
      return t;
    }
    if (s <= 0) return 0;
    const k = segmentAtLength(this._arcLengths, s);
    return k === this.segmentCount ? k : k + this._segment(k).timeAtLength(s - this._arcLengths[k], tolerance);
  }

  /**
   * The point at the arc length s from the start, with its t (0 to the number of segments), unit tangent and unit
   * normal. An s outside of [0, length] gives the nearer end. At a joint the segment that starts there counts.
   *
   * The first call measures all segments; further ones cost as much as those of `Curve.pointAtLength`.
   *
   * @param s in the unit of the points
   * @throws {RangeError} for a NaN or an infinity
   */
  pointAtLength(s: number, ...surplus: never[]): PointAtLength<D> {
    check.noSurplus(surplus, "pointAtLength", 1);
    return pointAndDirections(this, this.timeAtLength(s));
  }

  /**
   * The values of t that divide the whole spline into arcs of equal length, independent of the joints.
   *
   * @param segments how many parts, at least 1
   * @returns `segments` + 1 values, the first 0, the last the number of the spline's segments
   */
  equidistantTimes(segments: number): Float64Array {
    check.segmentCount(segments);
    if (segments < this.segmentCount && this._arcLengths[this.segmentCount] > 0) return this.#fewTimes(segments);
    const ts = readResult(0, core().spline_equidistant_times(this._write(), segments));
    releaseMemory();
    return ts;
  }

  /**
   * The signed area swept by the line from the origin to the point of the spline, positive while that line turns
   * counter-clockwise (x right, y up). For a closed spline it is the enclosed area. 2D only.
   */
  area(...surplus: never[]): number {
    check.noSurplus(surplus, "area", 0);
    this._require2D("area");
    this._write();
    return core().spline_area();
  }

  /**
   * The point of the spline that is nearest to p; t runs from 0 to the number of segments. Of several nearest points,
   * it is the one with the smallest t.
   *
   * The first call computes the boxes of all segments. Only segments whose box is not farther from p than the nearest
   * point so far are examined.
   *
   * @param p the point, in the unit of the points
   */
  nearest(p: PointLike): Nearest<D> {
    this.#tree ??= new SegmentTree(this._index);
    const { k, found } = this.#tree.nearest(this._coordinates(p, "p")) as { k: number; found: Nearest<D> };
    return { ...found, t: k + found.t };
  }

  /**
   * The parameters inside of (0, number of segments) where a coordinate has a local extremum, sorted. Joints at which
   * the coordinate changes between rising and falling are included, also the start of a closed spline, as t = 0. Where
   * the coordinate is constant between a rise and a fall, the joints of that part are extrema.
   */
  extrema(...surplus: never[]): Extrema {
    check.noSurplus(surplus, "extrema", 0);
    return splineExtrema(this._index, this.segments());
  }

  /**
   * All parameters in [0, number of segments] at which a coordinate has the given value, end points and tangencies
   * included, sorted. Joints are reported once, the start of a closed spline as 0. If the coordinate has that value on a
   * whole segment: both ends of the segment.
   *
   * @param where one coordinate and its value
   * @throws {TypeError} unless `where` has exactly one coordinate of the spline's dimension
   */
  timesAtCoordinate(where: { x: number } | { y: number } | { z: number }): Float64Array {
    return splineTimesAtCoordinate(this.segments(), where, this.closed);
  }

  /**
   * The arc length from the start to the start of each segment and to the end.
   *
   * @internal
   */
  get _arcLengths() {
    this.#arcLengths ??= arcLengthsOf(this._index);
    return this.#arcLengths;
  }

  /** `equidistantTimes` for fewer arcs than segments: it examines only the segments in which one of the times is. */
  #fewTimes(segments: number): Float64Array {
    const length = this._arcLengths[this.segmentCount];
    const ts = new Float64Array(segments + 1);
    for (let i = 1; i < segments; i++) ts[i] = Math.max(ts[i - 1], this.timeAtLength((i / segments) * length));
    ts[segments] = this.segmentCount;
    return ts;
  }
}
