import { fromBSpline, toBSpline } from "../bspline.js";
import * as check from "../check.js";
import { joinCurves } from "./core-spline.js";
import { curveOf } from "../curve/curve.js";
import { interpolate } from "../interpolate.js";
import { intersectSplines, selfIntersectSpline } from "../intersections.js";
import { flatten } from "../points.js";
import { SplineMeasures } from "./spline-measures.js";
import { CheckedSplineData, readSplineData, splineDataOf } from "./spline-value.js";
import { curveToThree } from "../../io/three.js";
import { core } from "../../wasm/init.js";
import { CheckedPoints, writeArguments, releaseMemory } from "../../wasm/transfer.js";

/**
 * @import { SplineData } from "../brand.js"
 * @import { BSpline, BSplineOptions } from "../bspline.js"
 * @import { PointsLike } from "../check.js"
 * @import { CoreCurve } from "../curve/core-curve.js"
 * @import { Curve } from "../curve/curve.js"
 * @import { InterpolateOptions } from "../interpolate.js"
 * @import { Intersection, SelfIntersection } from "../intersections.js"
 * @import { PointArrays } from "../points.js"
 * @import { PathTime } from "../path/path-queries.js"
 * @import { ThreeCurves } from "../../io/three.js"
 * @import { PathValue } from "../path/path-value.js"
 * @import { CoreSpline } from "./core-spline.js"
 * @import { SplineJSON } from "./spline-value.js"
 */

/**
 * Options of `Spline.fit`.
 *
 * @typedef {object} FitOptions
 * @property {number} tolerance the greatest distance of a point from the spline
 * @property {boolean} [closed] whether to continue from the last point to the first
 * @property {number} [cornerAngle] the smallest turn, in radians, that is a corner: π/5 by default, at most π
 */

/**
 * Options of `simplify`.
 *
 * @typedef {object} SimplifyOptions
 * @property {number} [cornerAngle] the smallest turn, in radians, that is a corner: π/5 by default, at most π
 */

/** @type {readonly ("round" | "miter" | "bevel")[]} in the order of the core */
const JOINS = ["round", "miter", "bevel"];

/**
 * Bézier curves joined end to end. Segment k covers t from k to k + 1 and has its own degree.
 *
 *     const spline = new Spline([[0, 0], [0, 2], [2, 2], [2, 0], [2, -2], [4, -2], [4, 0]]);
 *     spline.continuity(1).c1; // true
 *
 * What repeated queries need (segments, arc lengths, boxes) is computed once and kept. In TypeScript, `Spline<2>` and
 * `Spline<3>` have points `{x, y}` and `{x, y, z}`, see `Curve`.
 *
 * @template {2 | 3} [D=2 | 3]
 * @extends {SplineMeasures<D, Curve<D>>}
 */
export class Spline extends SplineMeasures {
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
    return /** @type {Spline<D>} */ (readSpline(length, dimension));
  }

  /**
   * The cubic spline through points, which are its joints.
   *
   * Natural: second derivatives are equal at all joints and zero at the ends of an open spline. Catmull-Rom: the
   * tangent at a point depends on it and its two neighbours; the handle of an open end is at a third of the chord, and
   * two equal consecutive points make a corner (unless alpha is 0).
   *
   * @template {2 | 3} [D=2 | 3]
   * @param {PointArrays<D> | PointsLike} points 2 or more
   * @param {InterpolateOptions & { dimension?: D }} [options] natural and open by default
   * @returns {Spline<D>}
   * @throws {RangeError} for fewer than 2 points, a NaN or an infinity, an alpha outside of 0 to 1
   */
  static interpolate(points, options) {
    const { length, dimension } = interpolate(points, options);
    return /** @type {Spline<D>} */ (readSpline(length, dimension));
  }

  /**
   * The Bézier form of a B-spline: one segment of the same degree for each span between different knots.
   *
   * Without knots, the B-spline is uniform, and an open one does not reach its first and last point. It reaches them if
   * the first degree + 1 knots are equal, and the last ones too (clamped knots). The multiplicity of an inner knot is
   * at most the degree. Segment k covers t from k to k + 1.
   *
   * @template {2 | 3} [D=2 | 3]
   * @param {PointArrays<D> | PointsLike} points at least degree + 1 if open
   * @param {BSplineOptions & { dimension?: D }} [options] degree 3, uniform and open by default
   * @returns {Spline<D>}
   * @throws {RangeError} for a wrong count, a knot below the previous one, or a multiplicity above the limit
   */
  static fromBSpline(points, options) {
    const { length, dimension } = fromBSpline(points, options);
    return /** @type {Spline<D>} */ (readSpline(length, dimension));
  }

  /**
   * The spline that `toJSON` described.
   *
   * @param {SplineJSON} json what `toJSON` returned
   * @returns {Spline}
   */
  static fromJSON(json) {
    return splineOf(splineDataOf(json));
  }

  /**
   * A spline with few cubic segments through a sequence of points (a stroke drawn by hand, a dense polyline): the
   * distance of every point from the spline is at most the tolerance. Turns by more than `cornerAngle` stay corners, the
   * other joints are smooth; consecutive equal points count once. The tolerance must be at least the noise of the points
   * (about 1 for positions of a mouse in pixels): otherwise the spline follows the noise with many short segments.
   *
   * @template {2 | 3} [D=2 | 3]
   * @param {PointArrays<D> | PointsLike} points at least 2
   * @param {FitOptions & { dimension?: D }} options
   * @returns {Spline<D>}
   */
  static fit(points, options) {
    const checked = check.options(options, ["tolerance", "closed", "cornerAngle", "dimension"]);
    const { tolerance, cornerAngle, dimension: requested } = checked;
    const closed = check.optionalBoolean(checked.closed, "closed");
    const { flat, dimension } = flatten(points, requested, 2);
    const count = flat.length / dimension;
    if (count < 2) throw new RangeError(`points: expected at least 2 points, got ${count}`);
    const distance = check.positive(tolerance, "tolerance");
    if (cornerAngle !== undefined) check.positive(cornerAngle, "cornerAngle");
    writeArguments(flat);
    const spline = readSpline(core().spline_fit(dimension, count, distance, cornerAngle ?? 0, closed), dimension);
    releaseMemory();
    return /** @type {Spline<D>} */ (spline);
  }

  /**
   * All intersections with a curve, another spline or a path (then u is a location {subpath, t}), sorted by t, then by
   * u, which run from 0 to the numbers of segments; with a path by its subpaths first. An intersection at a joint is
   * reported once; a shared part that runs across joints is one overlap. 2D only.
   *
   * In the worst case each pair of segments is compared, with the limits of `Curve.intersections`.
   *
   * @template {CoreCurve | CoreSpline | PathValue} S
   * @param {S} other a curve, a spline or a path
   * @param {never[]} surplus
   * @returns {Intersection<number, S extends PathValue ? PathTime : number>[]}
   */
  intersections(other, ...surplus) {
    check.noSurplus(surplus, "intersections", 1);
    this._require2D("intersections");
    return /** @type {any} */ (intersectSplines(this.casteljauData(), other));
  }

  /**
   * The points that the spline passes twice, sorted by t; t < u. Joints and the start of a closed spline do not count
   * as passed twice; the end point of an open spline that ends at its start does. 2D only.
   *
   * @param {never[]} surplus
   * @returns {SelfIntersection[]}
   */
  selfIntersections(...surplus) {
    check.noSurplus(surplus, "selfIntersections", 0);
    this._require2D("selfIntersections");
    return selfIntersectSpline(this.casteljauData());
  }

  /**
   * A spline of fewer lines and cubics whose Hausdorff distance from this one is at most the tolerance. Turns by more
   * than `cornerAngle` over arms of 8, 16 or 32 tolerances stay corners, the other joints are smooth, or lie where the
   * turn cannot be removed within the tolerance. If the number of segments cannot be reduced and no degree is above 3,
   * the spline is returned unchanged; segments of higher degrees become cubics, as many as the tolerance requires.
   *
   * If more than 4096 vertices per segment would be needed (tolerances below about 1e-7 of its size), segments of
   * degree up to 3 are returned unchanged, and higher degrees as cubics with the same tangents, at most 4096 for each
   * segment (else a RangeError).
   *
   * @param {number} tolerance the largest distance, in the unit of the points
   * @param {SimplifyOptions} [options]
   * @returns {this}
   */
  simplify(tolerance, options) {
    const { cornerAngle } = check.options(options, ["cornerAngle"]);
    check.positive(tolerance, "tolerance");
    if (cornerAngle !== undefined) check.positive(cornerAngle, "cornerAngle");
    return this._read(core().spline_simplify(this._write(), tolerance, cornerAngle ?? 0));
  }

  /**
   * The offset curve at a distance along the normal: the offset curves of the segments (see `Curve.offset`), joined at
   * corners on both sides. 2D only. Nothing is trimmed; the offset of a closed spline is closed.
   *
   * @param {number} distance the distance, in the unit of the points; negative on the other side
   * @param {{ tolerance?: number, join?: "round" | "miter" | "bevel" }} [options] `join`: by default "round"; the
   *   miter limit is 4 times the distance
   * @returns {this}
   */
  offset(distance, options) {
    this._require2D("offset");
    check.finite(distance, "distance");
    const { tolerance, join = "round" } = check.options(options, ["tolerance", "join"]);
    const code = JOINS.indexOf(check.oneOf(join, "join", JOINS));
    const maxError = check.optionalTolerance(tolerance);
    this._write();
    return this._read(core().spline_offset(distance, maxError, code));
  }

  /**
   * The spline as a B-spline whose knots are the joints, with the degree as multiplicity; `fromBSpline` returns exactly
   * this spline.
   *
   * @returns {BSpline}
   * @throws {RangeError} if the degrees differ
   */
  toBSpline() {
    return toBSpline(this.casteljauData());
  }

  /**
   * The spline as a `Curve` of three.js, for `TubeGeometry` and `ExtrudeGeometry`: its points are `Vector2` in the plane and
   * `Vector3` in space; arc lengths are those of this package, not a table's.
   *
   * @template {{ prototype: any }} CurveClass
   * @param {ThreeCurves<CurveClass>} THREE the namespace of three.js, or an object with `Curve`, `Vector2` and `Vector3`
   * @returns {CurveClass["prototype"]}
   */
  toThree(THREE) {
    return curveToThree(this, this.segmentCount, THREE);
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
 * @internal
 * @param {SplineData} data
 * @returns {Spline}
 */
export function splineOf(data) {
  return new Spline(/** @type {any} */ (new CheckedSplineData(data))); // outside of the class, see curve.js
}

/**
 * Reads a spline from the arena.
 *
 * @internal
 * @param {number} length
 * @param {2 | 3} dimension
 * @returns {Spline}
 */
export function readSpline(length, dimension) {
  return splineOf(readSplineData(length, dimension));
}
