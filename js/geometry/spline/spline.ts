import { fromChecked } from "../checked.js";
import { curvesModule } from "../../wasm/curves-module.js";
import * as check from "../check.js";
import { CoreSpline, joinCurves, readSplineData, splineDataFromJSON } from "./core-spline.js";
import { splineExtrema, splineTimesAtCoordinate } from "./spline-coordinates.js";
import { frameTimes, frameArguments, readFrames } from "../frames.js";
import { fromBSpline, toBSpline } from "../bspline.js";
import { curveOf } from "../curve/curve.js";
import { interpolate } from "../interpolate.js";
import { intersectSplines, selfIntersectSpline } from "../intersections.js";
import { joinCode } from "../joins.js";
import { flatten } from "../points.js";
import { curveToThree } from "../../io/three.js";
import type { PointsLike } from "../check.js";
import type { Curve } from "../curve/curve.js";
import type { Extrema } from "../curve-queries.js";
import type { FrameOptions, Frames } from "../frames.js";
import type { SplineData } from "../brand.js";
import type { BSpline, BSplineOptions } from "../bspline.js";
import type { CoreCurve } from "../curve/core-curve.js";
import type { InterpolateOptions } from "../interpolate.js";
import type { Intersection, SelfIntersection } from "../intersections.js";
import type { StrokeJoin } from "../joins.js";
import type { PointArrays } from "../points.js";
import type { PathTime } from "../path/path-queries.js";
import type { ThreeCurves } from "../../io/three.js";
import type { CorePath } from "../path/core-path.js";
import type { NurbsCurve } from "../rational/nurbs-curve.js";
import type { RationalCurve } from "../rational/rational-curve.js";
import type { SplineJSON } from "./core-spline.js";

/** Options of `Spline.fit`. */
export interface FitOptions {
  /** The greatest distance of a point from the spline */
  tolerance: number;
  /** Whether to continue from the last point to the first */
  closed?: boolean;
  /** The smallest turn, in radians, that is a corner: π/5 by default, at most π */
  cornerAngle?: number;
  /**
   * "best" finds the smallest tolerance that needs no more segments, to 1/1000, and takes about 11 times as long: "fast"
   * by default
   */
  effort?: FitEffort;
}

/** How much is computed for a fit. */
export type FitEffort = "fast" | "best";

const EFFORTS: readonly FitEffort[] = ["fast", "best"];

/** Options of `simplify`. */
export interface SimplifyOptions {
  /** The smallest turn, in radians, that is a corner: π/5 by default, at most π */
  cornerAngle?: number;
  /** Whether the extrema of x, y and z become joints with handles parallel to the axis, as in fonts: false by default */
  extrema?: boolean;
  /** The number of decimals of all control points, 0 to 15; no rounding by default */
  precision?: number;
  /** As in `FitOptions` */
  effort?: FitEffort;
}

/**
 * Bézier curves joined end to end. Segment k covers t from k to k + 1 and has its own degree.
 *
 *     const spline = new Spline([[0, 0], [0, 2], [2, 2], [2, 0], [2, -2], [4, -2], [4, 0]]);
 *     spline.continuity(1).c1; // true
 *
 * What repeated queries need (segments, arc lengths, boxes) is computed once and kept. In TypeScript, `Spline<2>` and
 * `Spline<3>` have points `{x, y}` and `{x, y, z}`, see `Curve`.
 */
export class Spline<D extends 2 | 3 = 2 | 3> extends CoreSpline<D, Curve<D>> {
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
    return readFrames(curvesModule.count(curvesModule.functions.spline_frames(ts.length, args.length > ts.length)));
  }

  /**
   * The parameters inside of (0, number of segments) where a coordinate has a local extremum, sorted. Joints at which
   * the coordinate changes between rising and falling are included, also the start of a closed spline, as t = 0. Where
   * the coordinate is constant between a rise and a fall, the joints of that part are extrema.
   */
  extrema(): Extrema {
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
    return readSpline(length, dimension) as Spline<D>;
  }

  /**
   * The cubic spline through points, which are its joints.
   *
   * Natural: second derivatives are equal at all joints and zero at the ends of an open spline. Catmull-Rom: the
   * tangent at a point depends on it and its two neighbours; the handle of an open end is at a third of the chord, and
   * two equal consecutive points make a corner (unless alpha is 0).
   *
   * @param points 2 or more
   * @param options natural and open by default
   * @throws {RangeError} for fewer than 2 points, a NaN or an infinity, an alpha outside of 0 to 1
   */
  static interpolate<D extends 2 | 3 = 2 | 3>(
    points: PointArrays<D> | PointsLike,
    options?: InterpolateOptions & { dimension?: D },
  ): Spline<D> {
    const { length, dimension } = interpolate(points, options);
    return readSpline(length, dimension) as Spline<D>;
  }

  /**
   * The Bézier form of a B-spline: one segment of the same degree for each span between different knots.
   *
   * Without knots, the B-spline is uniform, and an open one does not reach its first and last point. It reaches them if
   * the first degree + 1 knots are equal, and the last ones too (clamped knots). The multiplicity of an inner knot is
   * at most the degree. Segment k covers t from k to k + 1.
   *
   * @param points at least degree + 1 if open
   * @param options degree 3, uniform and open by default
   * @throws {RangeError} for a wrong count, a knot below the previous one, or a multiplicity above the limit
   */
  static fromBSpline<D extends 2 | 3 = 2 | 3>(
    points: PointArrays<D> | PointsLike,
    options?: BSplineOptions & { dimension?: D },
  ): Spline<D> {
    const { length, dimension } = fromBSpline(points, options);
    return readSpline(length, dimension) as Spline<D>;
  }

  /**
   * The spline that `toJSON` described.
   *
   * @param json what `toJSON` returned
   */
  static fromJSON(json: SplineJSON): Spline {
    return splineOf(splineDataFromJSON(json));
  }

  /**
   * A spline with few cubic segments through a sequence of points (a stroke drawn by hand, a dense polyline): the
   * distance of every point from the spline is at most the tolerance. Turns by more than `cornerAngle` stay corners, the
   * other joints are smooth; consecutive equal points count once. Between two points at a distance L the spline lies within
   * the tolerance plus L/6 of their edge, or plus a quarter of the tolerance if that is more. The tolerance must be at
   * least the noise of the points (about 1 for positions of a mouse in pixels): otherwise the spline follows the noise with
   * many short segments. A closed spline starts at its first corner, or at the first point if it has none.
   *
   * @param points at least 2
   */
  static fit<D extends 2 | 3 = 2 | 3>(
    points: PointArrays<D> | PointsLike,
    options: FitOptions & { dimension?: D },
  ): Spline<D> {
    const checked = check.options(options, ["tolerance", "closed", "cornerAngle", "effort", "dimension"]);
    const { tolerance, cornerAngle, effort = "fast", dimension: requested } = checked;
    const closed = check.optionalBoolean(checked.closed, "closed");
    const { flat, dimension } = flatten(points, requested, 2);
    const count = flat.length / dimension;
    if (count < 2) throw new RangeError(`points: expected at least 2 points, got ${count}`);
    const distance = check.positive(tolerance, "tolerance");
    if (cornerAngle !== undefined) check.positive(cornerAngle, "cornerAngle");
    const best = check.oneOf(effort, "effort", EFFORTS) === "best";
    curvesModule.write(flat);
    const spline = readSpline(
      curvesModule.functions.spline_fit(dimension, count, distance, cornerAngle ?? 0, closed, best),
      dimension,
    );
    curvesModule.release();
    return spline as Spline<D>;
  }

  /**
   * All intersections with a curve of any kind, another spline or a path (then u is a location {subpath, t}), sorted by t, then by
   * u, which run from 0 to the numbers of segments; with a path by its subpaths first. An intersection at a joint is
   * reported once; a shared part that runs across joints is one overlap. 2D only.
   *
   * In the worst case each pair of segments is compared, with the limits of `Curve.intersections`.
   *
   * @param other a curve, a spline, a path, or a rational or NURBS curve of `casteljau/nurbs`
   */
  intersections<S extends CoreCurve | CoreSpline | CorePath | RationalCurve | NurbsCurve>(
    other: S,
  ): Intersection<number, S extends CorePath ? PathTime : number>[] {
    this._require2D("intersections");
    return intersectSplines(this.casteljauData(), other) as any;
  }

  /**
   * The points that the spline passes twice, sorted by t; t < u. Joints and the start of a closed spline do not count
   * as passed twice; the end point of an open spline that ends at its start does. 2D only.
   */
  selfIntersections(): SelfIntersection[] {
    this._require2D("selfIntersections");
    return selfIntersectSpline(this.casteljauData());
  }

  /**
   * A spline of fewer lines and cubics whose Hausdorff distance from this one is at most the tolerance. Turns by more
   * than `cornerAngle` over arms of 8, 16 or 32 tolerances stay corners, the other joints are smooth, or lie where the
   * turn cannot be removed within the tolerance. If the number of segments cannot be reduced and no degree is above 3,
   * the spline is returned unchanged; segments of higher degrees are replaced by as many cubics as the tolerance
   * requires. A closed spline that is replaced starts at its first corner, or where it started if it has none.
   *
   * With `extrema`, x, y and z increase or decrease along each segment (segments above degree 3 at tolerances below about
   * 1e-7 of their size: up to the tolerance), and a closed spline without corners starts at an extremum. With
   * `precision`, the tolerance holds for the rounded result; smooth joints may turn by as much as their handles are
   * rounded.
   *
   * If more than 4096 vertices per segment would be needed (tolerances below about 1e-7 of its size), segments of
   * degree up to 3 are returned unchanged, and higher degrees as cubics with the same tangents, at most 4096 for each
   * segment (else a RangeError).
   *
   * @param tolerance the largest distance, in the unit of the points
   * @throws {RangeError} for a precision p that can move points by more than 0.96 of the tolerance (√2/2 · 10⁻ᵖ in 2D)
   */
  simplify(tolerance: number, options?: SimplifyOptions): this {
    const checked = check.options(options, ["cornerAngle", "extrema", "precision", "effort"]);
    const { cornerAngle, precision, effort = "fast" } = checked;
    check.positive(tolerance, "tolerance");
    if (cornerAngle !== undefined) check.positive(cornerAngle, "cornerAngle");
    const extrema = check.optionalBoolean(checked.extrema, "extrema");
    const decimals = precision === undefined ? -1 : check.whole(precision, "precision", 0, 15);
    const best = check.oneOf(effort, "effort", EFFORTS) === "best";
    return this._read(
      curvesModule.functions.spline_simplify(this._write(), tolerance, cornerAngle ?? 0, extrema, decimals, best),
    );
  }

  /**
   * The offset curve at a distance along the normal: the offset curves of the segments (see `Curve.offset`), joined at
   * corners on both sides. 2D only. Nothing is trimmed; the offset of a closed spline is closed.
   *
   * @param distance the distance, in the unit of the points; negative on the other side
   * @param options `join`: by default "round"; the miter limit is 4 times the distance
   */
  offset(distance: number, options?: { tolerance?: number; join?: StrokeJoin }): this {
    this._require2D("offset");
    check.finite(distance, "distance");
    const { tolerance, join = "round" } = check.options(options, ["tolerance", "join"]);
    const code = joinCode(join);
    const maxError = check.optionalTolerance(tolerance);
    this._write();
    return this._read(curvesModule.functions.spline_offset(distance, maxError, code));
  }

  /**
   * The spline as a B-spline whose knots are the joints, with the degree as multiplicity; `fromBSpline` returns exactly
   * this spline.
   *
   * @throws {RangeError} if the degrees differ
   */
  toBSpline(): BSpline {
    return toBSpline(this.casteljauData());
  }

  /**
   * The spline as a `Curve` of three.js, for `TubeGeometry` and `ExtrudeGeometry`: its points are `Vector2` in the plane and
   * `Vector3` in space; arc lengths are those of this package, not a table's.
   *
   * @param THREE the namespace of three.js, or an object with `Curve`, `Vector2` and `Vector3`
   */
  toThree<CurveClass extends { prototype: any }>(THREE: ThreeCurves<CurveClass>): CurveClass["prototype"] {
    return curveToThree(this, this.segmentCount, THREE);
  }

  /**
   * A curve of the full class.
   *
   * @internal
   */
  override _curveOf(flat: Float64Array): Curve<D> {
    return curveOf({ flat, dimension: this.dimension }) as Curve<D>;
  }

  /**
   * A spline of the full class.
   *
   * @internal
   */
  override _splineOf(data: SplineData): this {
    return splineOf(data) as this;
  }
}

/**
 * A spline whose data is checked already.
 *
 * @internal
 */
export function splineOf(data: SplineData): Spline {
  return fromChecked(Spline, data); // outside of the class, see curve.js
}

/**
 * Reads a spline from the arena.
 *
 * @internal
 */
export function readSpline(length: number, dimension: 2 | 3): Spline {
  return splineOf(readSplineData(length, dimension));
}
