import { fromBSpline, toBSpline } from "./bspline.js";
import * as check from "./check.js";
import { Curve, takePolyline } from "./curve.js";
import { frameTimes, frameWishes, takeFrames } from "./frames.js";
import { core } from "./init.js";
import { modeCode, modeCodes } from "./joints.js";
import { CHAIN, chainOf, inPlane, meetChains, meetSelf } from "./meetings.js";
import { nearestLeft } from "./places.js";
import { boxAt, flatten, nested, pointAt, samePoints, writePoint } from "./points.js";
import { packedSpline } from "./path-packed.js";
import { done } from "./refusal.js";
import { interpolate } from "./interpolate.js";
import { svgOf, traceOn } from "./svg-write.js";
import { Checked, load, take, takeInto, trim } from "./transfer.js";

/**
 * @import { BSpline, BSplineOptions } from "./bspline.js"
 * @import { MatrixLike, PointLike, PointsLike } from "./check.js"
 * @import { Chain, Intersection, SelfIntersection } from "./meetings.js"
 * @import { Nearest } from "./places.js"
 * @import { FrameOptions, Frames } from "./frames.js"
 * @import { Continuity, JointMode } from "./joints.js"
 * @import { Point } from "./points.js"
 * @import { InterpolateOptions } from "./interpolate.js"
 * @import { SvgOptions } from "./svg-write.js"
 */

/**
 * The structure of a spline: its points, the degree of each segment, whether it is closed.
 *
 * @typedef {{ flat: Float64Array, dimension: 2 | 3, degrees: number[], closed: boolean }} Parts
 */

/** @type {readonly ("round" | "miter" | "bevel")[]} in the order of the core */
const JOINS = ["round", "miter", "bevel"];

/**
 * Bézier curves joined end to end: segment k covers t from k to k + 1 and keeps its own degree.
 *
 *     const spline = new Spline([[0, 0], [0, 2], [2, 2], [2, 0], [2, -2], [4, -2], [4, 0]]);
 *     spline.continuity(1).c1; // true
 */
export class Spline {
  /** @type {Parts} */
  #parts;

  /**
   * @param {PointsLike} points n · degree + 1 control points, closed n · degree
   * @param {{ degree?: number, closed?: boolean, dimension?: 2 | 3 }} [options] degree 3 and open by default
   * @throws {RangeError} for a count that does not fit, a NaN or an infinity
   */
  constructor(points, options) {
    const inside = /** @type {unknown} */ (points);
    if (inside instanceof CheckedParts) {
      this.#parts = inside.parts;
      return;
    }
    const { degree = 3, closed = false, dimension: wanted } = check.options(options);
    check.whole(degree, "degree", 1, 64);
    const { flat, dimension } = flatten(points, wanted, 2);
    const count = flat.length / dimension;
    const segments = (count - (closed ? 0 : 1)) / degree;
    if (segments < 1 || !Number.isInteger(segments)) {
      const rule = closed ? `a multiple of ${degree}` : `a multiple of ${degree}, and one more,`;
      throw new RangeError(`points: expected ${rule} control points (degree ${degree}), got ${count}`);
    }
    this.#parts = { flat, dimension, degrees: new Array(segments).fill(degree), closed: Boolean(closed) };
  }

  /**
   * A spline from curves that follow each other; the degrees may differ.
   *
   * @param {Curve[]} curves
   * @param {{ closed?: boolean }} [options]
   * @returns {Spline}
   * @throws {RangeError} where a curve does not start at the end of the one before it
   */
  static fromCurves(curves, options) {
    if (!Array.isArray(curves)) throw new TypeError(`curves: expected an array of curves, got ${check.shown(curves)}`);
    if (curves.length === 0) throw new RangeError("curves: expected at least 1 curve, got 0");
    for (let k = 0; k < curves.length; k++) check.instanceOf(curves[k], `curves[${k}]`, Curve); // holes too
    const dimension = curves[0].dimension;
    const other = curves.findIndex((curve) => curve.dimension !== dimension);
    if (other > 0) throw new TypeError(`curves[${other}]: expected a ${dimension}D curve, got a ${5 - dimension}D one`);
    const closed = Boolean(check.options(options).closed);
    const numbers = curves.flatMap((curve) => [...curve.controlPoints()]);
    load(Float64Array.from([curves.length, closed ? 1 : 0, ...curves.map((curve) => curve.degree), ...numbers]));
    return takeSpline(core().spline_from_curves(dimension), dimension);
  }

  /**
   * A cubic spline through points, which are its joints.
   *
   * Natural: equal second derivatives at all joints, none at free ends. Catmull-Rom: the tangent at a point comes from it
   * and its neighbours; free ends start straight, and a point that comes twice is a corner (unless alpha is 0).
   *
   * @param {PointsLike} points 2 or more
   * @param {InterpolateOptions} [options] natural and open by default
   * @returns {Spline}
   * @throws {RangeError} for fewer than 2 points, a NaN or an infinity, an alpha outside of 0 to 1
   */
  static interpolate(points, options) {
    const { length, dimension } = interpolate(points, options);
    return takeSpline(length, dimension);
  }

  /**
   * The Bézier form of a B-spline: one segment of its degree for each span between different knots.
   *
   * Without knots it is uniform, and an open one does not reach its first and last point; one does whose first and whose
   * last degree + 1 knots are equal. Inside, a knot may come as often as the degree. Each segment runs from t = k to k + 1.
   *
   * @param {PointsLike} points open degree + 1 or more
   * @param {BSplineOptions} [options] degree 3, uniform and open by default
   * @returns {Spline}
   * @throws {RangeError} for a wrong count, a knot below the one before it, or one that comes too often
   */
  static fromBSpline(points, options) {
    const { length, dimension } = fromBSpline(points, options);
    return takeSpline(length, dimension);
  }

  /**
   * @param {{ points: PointsLike, degrees: number[], closed: boolean, dimension?: 2 | 3 }} json what `toJSON` gave
   * @returns {Spline}
   */
  static fromJSON(json) {
    if (typeof json !== "object" || json === null) {
      throw new TypeError(`json: expected an object with points, degrees and closed, got ${check.shown(json)}`);
    }
    const { flat, dimension } = flatten(json.points, json.dimension, 2);
    const degrees = [...check.numbers(json.degrees, "degrees")];
    degrees.forEach((degree, k) => check.whole(degree, `degrees[${k}]`, 1, 64));
    const closed = Boolean(json.closed);
    const needed = degrees.reduce((sum, degree) => sum + degree, closed ? 0 : 1);
    if (degrees.length === 0 || needed !== flat.length / dimension) {
      throw new RangeError(`points: expected ${needed} (the sum of the degrees), got ${flat.length / dimension}`);
    }
    return splineOf({ flat, dimension, degrees, closed });
  }

  /** 2 in the plane, 3 in space. */
  get dimension() {
    return this.#parts.dimension;
  }

  /** Whether the end joins the start. */
  get closed() {
    return this.#parts.closed;
  }

  /** The number of segments, which is the t of the end. */
  get segmentCount() {
    return this.#parts.degrees.length;
  }

  /** The degree of each segment. */
  get degrees() {
    return [...this.#parts.degrees];
  }

  /**
   * @returns {Float64Array} the coordinates of all control points, joints once each; a copy
   */
  controlPoints() {
    return this.#parts.flat.slice();
  }

  /**
   * @returns {Curve[]}
   */
  segments() {
    const { flat, dimension, degrees, closed } = this.#parts;
    const ring = closed ? Float64Array.of(...flat.subarray(0, dimension)) : flat.subarray(0, 0);
    let from = 0;
    return degrees.map((degree) => {
      const to = from + degree * dimension;
      const points = new Float64Array((degree + 1) * dimension);
      points.set(flat.subarray(from, to + dimension));
      if (to === flat.length) points.set(ring, degree * dimension);
      from = to;
      return new Curve(/** @type {any} */ (new Checked(points, dimension)));
    });
  }

  /**
   * Whether both have the same structure and each control point lies within a distance of its counterpart.
   *
   * @param {Spline} other
   * @param {number} [tolerance]
   * @returns {boolean}
   */
  equals(other, tolerance = 0) {
    const [a, b] = [this.#parts, asSpline(other).#parts];
    const alike = a.closed === b.closed && a.dimension === b.dimension && `${a.degrees}` === `${b.degrees}`;
    return alike && samePoints(a.flat, b.flat, a.dimension, tolerance);
  }

  /**
   * The point at t, from 0 to the number of segments.
   *
   * @param {number} t
   * @returns {Point}
   */
  eval(t) {
    check.finite(t, "t");
    core().spline_eval(this.#load(), t);
    return pointAt(take(0, 3), 0, this.dimension);
  }

  /**
   * Points at even steps of t, both ends included.
   *
   * @param {number} segmentsPerCurve
   * @param {{ into?: Float64Array }} [options]
   * @returns {Float64Array}
   */
  sample(segmentsPerCurve, options) {
    check.segmentCount(segmentsPerCurve, "segmentsPerCurve");
    const into = check.options(options).into;
    const length = (segmentsPerCurve * this.segmentCount + 1) * this.dimension;
    if (into !== undefined) check.resultArray(into, length);
    const used = core().spline_sample(this.#load(), segmentsPerCurve);
    const result = into ? takeInto(into, used) : take(0, used);
    trim();
    return result;
  }

  /**
   * The points at some parameters.
   *
   * @param {ArrayLike<number>} ts
   * @param {{ into?: Float64Array }} [options]
   * @returns {Float64Array}
   */
  evalAt(ts, options) {
    const parameters = check.numbers(ts, "ts");
    const length = parameters.length * this.dimension;
    const into = check.resultArray(check.options(options).into, length);
    core().spline_eval_at(this.#load(parameters), parameters.length);
    return takeInto(into, length);
  }

  /**
   * A polyline from which the spline is nowhere farther than `tolerance`; joints are vertices.
   *
   * @param {number} tolerance
   * @returns {{ points: Float64Array, ts: Float64Array }}
   */
  flatten(tolerance) {
    check.positive(tolerance, "tolerance");
    return takePolyline(core().spline_flatten(this.#load(), tolerance), this.dimension);
  }

  /**
   * Rotation-minimising frames, as of a curve; round corners they turn with the tangent, the short way. Frames of a
   * closed spline rotate evenly about the tangent, so that the last one equals the first. 3D only.
   *
   * @param {number | ArrayLike<number>} where a number of segments per curve, as for `sample`, or values of t
   * @param {FrameOptions} [options]
   * @returns {Frames}
   */
  frames(where, options) {
    if (this.dimension === 2) throw new TypeError("frames: expected a 3D spline, got a 2D one");
    const ts = frameTimes(where, this.segmentCount);
    const wishes = frameWishes(ts, options);
    this.#load(wishes);
    return takeFrames(done(core().spline_frames(ts.length, wishes.length > ts.length)));
  }

  /**
   * The length, right to 10⁻¹² of itself.
   *
   * @param {number} [tolerance] the greatest error, in the unit of the points, where it asks for more than that
   * @returns {number}
   */
  length(tolerance) {
    const most = check.optionalTolerance(tolerance);
    return take(0, core().spline_length(this.#load(), most))[0];
  }

  /**
   * The t, from 0 to the number of segments, at which the spline has the length s behind it; for an s outside of 0 to
   * the whole length the nearer end.
   *
   * @param {number} s
   * @param {number} [tolerance] the greatest error, as a length; by default 10⁻¹² of the whole
   * @returns {number}
   */
  timeAtLength(s, tolerance) {
    check.finite(s, "s");
    const most = check.optionalTolerance(tolerance);
    return take(0, core().spline_time_at_length(this.#load(), s, most))[0];
  }

  /**
   * The values of t that divide the whole spline into arcs of one length; joints do not matter.
   *
   * @param {number} segments
   * @returns {Float64Array} `segments` + 1 values, the first 0, the last the number of the spline's segments
   */
  equidistantTimes(segments) {
    check.segmentCount(segments);
    const ts = take(0, core().spline_equidistant_times(this.#load(), segments));
    trim();
    return ts;
  }

  /**
   * The signed area that the segment from the origin to the spline's point sweeps, positive while it turns
   * counter-clockwise (x right, y up); of a closed spline the area that it encloses. 2D only.
   *
   * @returns {number}
   */
  area() {
    if (this.dimension === 3) throw new TypeError("area: expected a 2D spline, got a 3D one");
    this.#load();
    return core().spline_area();
  }

  /**
   * The smallest box that contains the spline.
   *
   * @returns {{ min: Point, max: Point }}
   */
  bounds() {
    core().spline_bounds(this.#load(), true);
    return boxAt(take(0, 6), this.dimension);
  }

  /**
   * The box of the control points.
   *
   * @returns {{ min: Point, max: Point }}
   */
  controlBounds() {
    core().spline_bounds(this.#load(), false);
    return boxAt(take(0, 6), this.dimension);
  }

  /**
   * What is true at the joint t = `joint` (closed splines have a joint 0 too).
   *
   * @param {number} joint
   * @param {number} [tolerance] a distance, by default 1e-9 of the extent of the two segments
   * @returns {Continuity}
   */
  continuity(joint, tolerance) {
    this.#checkJoint(joint);
    const used = core().spline_continuity(this.#load(), joint, check.optionalTolerance(tolerance));
    const [c0, g1, c1, g2, c2, gap, angle] = take(0, used);
    return { c0: c0 === 1, g1: g1 === 1, c1: c1 === 1, g2: g2 === 1, c2: c2 === 1, gap, angle };
  }

  /**
   * The spline with one more segment that ends at `point`, its handles automatic.
   *
   * @param {PointLike} point
   * @returns {Spline}
   */
  append(point) {
    if (this.closed) throw new RangeError("append: expected an open spline, which has an end, got a closed one");
    return this.#made(core().spline_append(this.#load(this.#coordinates(point, "point"))));
  }

  /**
   * The spline with a control point moved and the joints repaired outwards from it: the nearest first, each once, and only
   * points that were not placed before. What cannot be held is not held; `continuity` tells.
   *
   * A joint that is dragged takes its handles along. "c2" and "g2" need segments of degree 3 or more, else they keep what
   * "c1" and "g1" keep; "auto" sets handles on such segments only, at the open end beside it too.
   *
   * @param {number} index
   * @param {PointLike} to
   * @param {{ joints?: ArrayLike<JointMode | undefined> | Record<number, JointMode> }} [options] `joints[k]`: the mode of
   *   the joint at t = k, "free" where not given
   * @returns {Spline}
   * @throws {RangeError} for an index past the last point, a mode that there is not, "g2" in 3D
   */
  movePoint(index, to, options) {
    const last = this.#parts.flat.length / this.dimension - 1;
    check.whole(index, "index", 0, last);
    const modes = modeCodes(check.options(options).joints, this.segmentCount, this.dimension);
    const place = this.#coordinates(to, "to");
    const behind = new Float64Array(place.length + modes.length);
    behind.set(place);
    behind.set(modes, place.length);
    return this.#made(core().spline_move_point(this.#load(behind), index));
  }

  /**
   * The spline with a joint made what the mode says; the handle before it is kept ("auto" sets both).
   *
   * @param {number} joint
   * @param {JointMode} mode
   * @returns {Spline}
   * @throws {RangeError} where there is no such joint, and for "g2" in 3D
   */
  setJoint(joint, mode) {
    this.#checkJoint(joint);
    return this.#made(core().spline_set_joint(this.#load(), joint, modeCode(mode, "mode", this.dimension)));
  }

  /**
   * The same curve with a joint at t.
   *
   * @param {number} t 0 to the number of segments
   * @returns {Spline}
   */
  insert(t) {
    check.finite(t, "t");
    return this.#made(core().spline_insert(this.#load(), t));
  }

  /**
   * The spline without a joint; undoes an insert exactly.
   *
   * @param {number} joint
   * @returns {Spline}
   */
  remove(joint) {
    this.#checkJoint(joint);
    return this.#made(core().spline_remove(this.#load(), joint));
  }

  /**
   * The same spline run through backwards.
   *
   * @returns {Spline}
   */
  reverse() {
    return this.#made(core().spline_reverse(this.#load()));
  }

  /**
   * The image under an affine map.
   *
   * @param {MatrixLike} matrix
   * @returns {Spline}
   */
  transform(matrix) {
    const { flat, dimension } = this.#parts;
    load(flat, 12).set(check.affine(matrix), flat.length);
    core().points_transform(dimension, flat.length / dimension);
    return splineOf({ ...this.#parts, flat: take(0, flat.length) });
  }

  /**
   * The point of the spline that is nearest to p, of all segments; t runs from 0 to the number of segments. Of equally near
   * points the one with the smallest t.
   *
   * @param {PointLike} p
   * @returns {Nearest}
   */
  nearest(p) {
    core().spline_nearest(this.#load(this.#coordinates(p, "p")));
    return nearestLeft(this.dimension);
  }

  /**
   * All places that this spline shares with a curve or another spline, sorted by t, then by u, which run from 0 to the
   * numbers of segments. A joint is one place, a shared piece that runs across joints is one. 2D only.
   *
   * At worst each curve is compared with each, with the limit of Curve.intersections.
   *
   * @param {Curve | Spline} other
   * @returns {Intersection[]}
   */
  intersections(other) {
    return meetChains(this[CHAIN](), chainOf(other));
  }

  /**
   * The points that the spline passes twice, sorted by t; t < u. Joints, and the start of a closed spline, are no such
   * points; an open spline that ends where it starts passes that point twice. 2D only.
   *
   * @returns {SelfIntersection[]}
   */
  selfIntersections() {
    inPlane("selfIntersections", "spline", this.dimension);
    return meetSelf(this[CHAIN]());
  }

  /**
   * @internal
   * @returns {Chain}
   */
  [CHAIN]() {
    inPlane("intersections", "spline", this.dimension);
    return this.#parts;
  }

  /**
   * A spline of few cubics along points in order (a stroke drawn by hand, a dense polyline): every point lies within the
   * tolerance of it. Turns by more than `cornerAngle` stay corners; the other joints are smooth. Points that repeat count
   * once.
   *
   * @param {PointsLike} points at least 2
   * @param {number} tolerance
   * @param {{ closed?: boolean, cornerAngle?: number, dimension?: 2 | 3 }} [options] `closed`: lead back from the last
   *   point to the first; `cornerAngle`: the smallest turn, in radians, that is a corner (π/5 by default, at most π)
   * @returns {Spline}
   */
  static fit(points, tolerance, options) {
    const { closed = false, cornerAngle, dimension: wanted } = check.options(options);
    const { flat, dimension } = flatten(points, wanted, 2);
    const count = flat.length / dimension;
    if (count < 2) throw new RangeError(`points: expected at least 2 points, got ${count}`);
    check.positive(tolerance, "tolerance");
    if (cornerAngle !== undefined) check.positive(cornerAngle, "cornerAngle");
    load(flat);
    const spline = takeSpline(core().spline_fit(dimension, count, tolerance, cornerAngle ?? 0, Boolean(closed)), dimension);
    trim();
    return spline;
  }

  /**
   * A spline of fewer cubics: no point of it is farther than the tolerance from this one, nor the other way round.
   * Corners stay. Where there are no fewer segments, and none is above degree 3, the spline comes back as it is; higher
   * degrees become cubics, more of them where that is what the tolerance takes.
   *
   * Where more than 4096 vertices for each segment would be needed (tolerances below about 1e-7 of its size), degrees up
   * to 3 come back as they are and higher ones as cubics with the same tangents: a RangeError above 4096 of them for each
   * segment.
   *
   * @param {number} tolerance
   * @returns {Spline}
   */
  simplify(tolerance) {
    check.positive(tolerance, "tolerance");
    return this.#made(core().spline_simplify(this.#load(), tolerance));
  }

  /**
   * The parallel at a distance along the normal: that of each segment (see `Curve.offset`), joined at corners on both
   * sides. 2D only. Nothing is trimmed; a closed spline stays closed.
   *
   * @param {number} distance
   * @param {{ tolerance?: number, join?: "round" | "miter" | "bevel" }} [options] `join`: arcs about the corners by
   *   default; a mitre reaches at most 4 distances
   * @returns {Spline}
   */
  offset(distance, options) {
    if (this.dimension === 3) throw new TypeError("offset: expected a 2D spline, got a 3D one");
    check.finite(distance, "distance");
    const { tolerance, join = "round" } = check.options(options);
    const code = JOINS.indexOf(check.oneOf(join, "join", JOINS));
    const given = check.optionalTolerance(tolerance);
    this.#load();
    return takeSpline(core().spline_offset(distance, given, code), 2);
  }

  /**
   * Draws the spline on a canvas context or a Path2D; 2D only.
   *
   * @param {CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D | Path2D} target
   * @param {{ tolerance?: number }} [options] for degrees above 3, which are drawn as cubics
   */
  trace(target, options) {
    const { flat, dimension, degrees, closed } = this.#parts;
    if (dimension === 3) throw new TypeError("trace: expected a 2D spline, got a 3D one");
    traceOn(packedSpline(flat, degrees, closed), target, options);
  }

  /**
   * The same chain as a B-spline whose knots are the joints, each as often as the degree; `fromBSpline` gives back exactly
   * this spline.
   *
   * @returns {BSpline}
   * @throws {RangeError} where degrees differ
   */
  toBSpline() {
    return toBSpline(this.#parts);
  }

  /**
   * The spline as SVG path data, see `Path.toSVG`; 2D only.
   *
   * @param {SvgOptions} [options]
   * @returns {string}
   */
  toSVG(options) {
    const { flat, dimension, degrees, closed } = this.#parts;
    if (dimension === 3) throw new TypeError("toSVG: expected a 2D spline, got a 3D one");
    return svgOf(packedSpline(flat, degrees, closed), options);
  }

  /**
   * @returns {{ points: number[][], degrees: number[], closed: boolean }}
   */
  toJSON() {
    const { flat, dimension, degrees, closed } = this.#parts;
    return { points: nested(flat, dimension), degrees: [...degrees], closed };
  }

  /**
   * Writes the spline, and numbers behind it, to the arena.
   *
   * @param {ArrayLike<number>} [behind]
   * @returns {2 | 3} the dimension
   */
  #load(behind) {
    const { flat, dimension, degrees, closed } = this.#parts;
    const head = 2 + degrees.length;
    const view = load(Float64Array.of(degrees.length, closed ? 1 : 0), head + flat.length + (behind?.length ?? 0));
    view.set(degrees, 2);
    view.set(flat, head);
    if (behind) view.set(behind, head + flat.length);
    return dimension;
  }

  /** @param {number} length */
  #made(length) {
    return takeSpline(length, this.dimension);
  }

  /**
   * @param {PointLike} point
   * @param {string} name
   */
  #coordinates(point, name) {
    const place = new Float64Array(this.dimension);
    writePoint(place, 0, point, this.dimension, name);
    return place;
  }

  /** @param {unknown} joint */
  #checkJoint(joint) {
    check.whole(joint, "joint", this.closed ? 0 : 1, this.segmentCount - 1);
  }
}

/** Parts that were checked: what the constructor takes from inside. */
class CheckedParts {
  /** @param {Parts} parts */
  constructor(parts) {
    this.parts = parts;
  }
}

/** @param {unknown} other */
function asSpline(other) {
  return check.instanceOf(other, "other", Spline); // outside of the class, see curve.js
}

/**
 * @internal
 * @param {Parts} parts
 */
export function splineOf(parts) {
  return new Spline(/** @type {any} */ (new CheckedParts(parts)));
}

/**
 * The spline that the core left.
 *
 * @internal
 * @param {number} length
 * @param {2 | 3} dimension
 */
export function takeSpline(length, dimension) {
  const numbers = take(0, length);
  const head = 2 + numbers[0];
  return splineOf({ flat: numbers.slice(head), dimension, degrees: [...numbers.subarray(2, head)], closed: numbers[1] === 1 });
}
