import { fromBSpline, toBSpline } from "./bspline.js";
import * as check from "./check.js";
import { Curve, readPolyline } from "./curve.js";
import { frameTimes, frameArguments, readFrames } from "./frames.js";
import { core } from "../wasm/init.js";
import { modeCode, modeCodes } from "./joints.js";
import { SPLINE_DATA, splineDataOf, require2D, intersectSplines, selfIntersectSpline } from "./intersections.js";
import { readNearest } from "./curve-queries.js";
import { boxAt, flatten, nested, pointAt, samePoints, writePoint } from "./points.js";
import { packedSpline } from "../wasm/packed-path.js";
import { unwrapCount } from "../wasm/errors.js";
import { interpolate } from "./interpolate.js";
import { svgOf, traceOn } from "../io/svg-write.js";
import { CheckedPoints, writeArguments, readResult, readResultInto, releaseMemory } from "../wasm/transfer.js";

/**
 * @import { BSpline, BSplineOptions } from "./bspline.js"
 * @import { MatrixLike, PointLike, PointsLike } from "./check.js"
 * @import { SplineData, Intersection, SelfIntersection } from "./intersections.js"
 * @import { Nearest } from "./curve-queries.js"
 * @import { FrameOptions, Frames } from "./frames.js"
 * @import { Continuity, JointMode } from "./joints.js"
 * @import { Point } from "./points.js"
 * @import { InterpolateOptions } from "./interpolate.js"
 * @import { SvgOptions } from "../io/svg-write.js"
 */

/** @type {readonly ("round" | "miter" | "bevel")[]} in the order of the core */
const JOINS = ["round", "miter", "bevel"];

/**
 * Bézier curves joined end to end. Segment k covers t from k to k + 1 and has its own degree.
 *
 *     const spline = new Spline([[0, 0], [0, 2], [2, 2], [2, 0], [2, -2], [4, -2], [4, 0]]);
 *     spline.continuity(1).c1; // true
 */
export class Spline {
  /** @type {SplineData} */
  #data;

  /**
   * @param {PointsLike} points n · degree + 1 control points, closed n · degree
   * @param {{ degree?: number, closed?: boolean, dimension?: 2 | 3 }} [options] degree 3 and open by default
   * @throws {RangeError} for a wrong number of points, a NaN or an infinity
   */
  constructor(points, options) {
    const checked = /** @type {unknown} */ (points);
    if (checked instanceof CheckedSplineData) {
      this.#data = checked.data;
      return;
    }
    const { degree = 3, closed = false, dimension: requested } = check.options(options);
    check.whole(degree, "degree", 1, 64);
    const { flat, dimension } = flatten(points, requested, 2);
    const count = flat.length / dimension;
    const segments = (count - (closed ? 0 : 1)) / degree;
    if (segments < 1 || !Number.isInteger(segments)) {
      const rule = closed ? `a multiple of ${degree}` : `a multiple of ${degree}, and one more,`;
      throw new RangeError(`points: expected ${rule} control points (degree ${degree}), got ${count}`);
    }
    this.#data = { flat, dimension, degrees: new Array(segments).fill(degree), closed: Boolean(closed) };
  }

  /**
   * The spline of consecutive curves, whose degrees may differ.
   *
   * @param {Curve[]} curves
   * @param {{ closed?: boolean }} [options]
   * @returns {Spline}
   * @throws {RangeError} if a curve does not start at the end of the previous one
   */
  static fromCurves(curves, options) {
    if (!Array.isArray(curves))
      throw new TypeError(`curves: expected an array of curves, got ${check.describe(curves)}`);
    if (curves.length === 0) throw new RangeError("curves: expected at least 1 curve, got 0");
    for (let k = 0; k < curves.length; k++) check.instanceOf(curves[k], `curves[${k}]`, Curve); // also finds holes
    const dimension = curves[0].dimension;
    const other = curves.findIndex((curve) => curve.dimension !== dimension);
    if (other > 0) throw new TypeError(`curves[${other}]: expected a ${dimension}D curve, got a ${5 - dimension}D one`);
    const closed = Boolean(check.options(options).closed);
    const numbers = curves.flatMap((curve) => [...curve.controlPoints()]);
    writeArguments(
      Float64Array.from([curves.length, closed ? 1 : 0, ...curves.map((curve) => curve.degree), ...numbers]),
    );
    return readSpline(core().spline_from_curves(dimension), dimension);
  }

  /**
   * The cubic spline through points, which are its joints.
   *
   * Natural: second derivatives are equal at all joints and zero at the ends of an open spline. Catmull-Rom: the
   * tangent at a point depends on it and its two neighbours; the handle of an open end is at a third of the chord, and
   * two equal consecutive points make a corner (unless alpha is 0).
   *
   * @param {PointsLike} points 2 or more
   * @param {InterpolateOptions} [options] natural and open by default
   * @returns {Spline}
   * @throws {RangeError} for fewer than 2 points, a NaN or an infinity, an alpha outside of 0 to 1
   */
  static interpolate(points, options) {
    const { length, dimension } = interpolate(points, options);
    return readSpline(length, dimension);
  }

  /**
   * The Bézier form of a B-spline: one segment of the same degree for each span between different knots.
   *
   * Without knots, the B-spline is uniform, and an open one does not reach its first and last point. It reaches them if
   * the first degree + 1 knots are equal, and the last ones too (clamped knots). The multiplicity of an inner knot is
   * at most the degree. Segment k covers t from k to k + 1.
   *
   * @param {PointsLike} points at least degree + 1 if open
   * @param {BSplineOptions} [options] degree 3, uniform and open by default
   * @returns {Spline}
   * @throws {RangeError} for a wrong count, a knot below the previous one, or a multiplicity above the limit
   */
  static fromBSpline(points, options) {
    const { length, dimension } = fromBSpline(points, options);
    return readSpline(length, dimension);
  }

  /**
   * @param {{ points: PointsLike, degrees: number[], closed: boolean, dimension?: 2 | 3 }} json what `toJSON` returned
   * @returns {Spline}
   */
  static fromJSON(json) {
    if (typeof json !== "object" || json === null) {
      throw new TypeError(`json: expected an object with points, degrees and closed, got ${check.describe(json)}`);
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
    return this.#data.dimension;
  }

  /** Whether the last segment ends at the start of the first. */
  get closed() {
    return this.#data.closed;
  }

  /** The number of segments, which is also the t of the end. */
  get segmentCount() {
    return this.#data.degrees.length;
  }

  /** The degree of each segment. */
  get degrees() {
    return [...this.#data.degrees];
  }

  /**
   * @returns {Float64Array} a copy of the coordinates of all control points; joints are listed once
   */
  controlPoints() {
    return this.#data.flat.slice();
  }

  /**
   * @returns {Curve[]}
   */
  segments() {
    const { flat, dimension, degrees, closed } = this.#data;
    const closingPoint = closed ? flat.subarray(0, dimension) : flat.subarray(0, 0);
    let from = 0;
    return degrees.map((degree) => {
      const to = from + degree * dimension;
      const points = new Float64Array((degree + 1) * dimension);
      points.set(flat.subarray(from, to + dimension));
      if (to === flat.length) points.set(closingPoint, degree * dimension);
      from = to;
      return new Curve(/** @type {any} */ (new CheckedPoints(points, dimension)));
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
    const [a, b] = [this.#data, asSpline(other).#data];
    const sameStructure = a.closed === b.closed && a.dimension === b.dimension && `${a.degrees}` === `${b.degrees}`;
    return sameStructure && samePoints(a.flat, b.flat, a.dimension, tolerance);
  }

  /**
   * The point at t, from 0 to the number of segments.
   *
   * @param {number} t
   * @returns {Point}
   */
  eval(t) {
    check.finite(t, "t");
    core().spline_eval(this.#write(), t);
    return pointAt(readResult(0, 3), 0, this.dimension);
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
    const into = check.options(options).into;
    const length = (segmentsPerCurve * this.segmentCount + 1) * this.dimension;
    if (into !== undefined) check.resultArray(into, length);
    const count = core().spline_sample(this.#write(), segmentsPerCurve);
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
    const into = check.resultArray(check.options(options).into, length);
    core().spline_eval_at(this.#write(parameters), parameters.length);
    return readResultInto(into, length);
  }

  /**
   * A polyline whose distance from the spline is nowhere greater than `tolerance`; joints are vertices.
   *
   * @param {number} tolerance
   * @returns {{ points: Float64Array, ts: Float64Array }}
   */
  flatten(tolerance) {
    check.positive(tolerance, "tolerance");
    return readPolyline(core().spline_flatten(this.#write(), tolerance), this.dimension);
  }

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
    this.#write(args);
    return readFrames(unwrapCount(core().spline_frames(ts.length, args.length > ts.length)));
  }

  /**
   * The arc length with a relative error below 10⁻¹².
   *
   * @param {number} [tolerance] the largest error, in the unit of the points, if it is to be smaller
   * @returns {number}
   */
  length(tolerance) {
    const maxError = check.optionalTolerance(tolerance);
    return readResult(0, core().spline_length(this.#write(), maxError))[0];
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
    return readResult(0, core().spline_time_at_length(this.#write(), s, maxError))[0];
  }

  /**
   * The values of t that divide the whole spline into arcs of equal length, independent of the joints.
   *
   * @param {number} segments
   * @returns {Float64Array} `segments` + 1 values, the first 0, the last the number of the spline's segments
   */
  equidistantTimes(segments) {
    check.segmentCount(segments);
    const ts = readResult(0, core().spline_equidistant_times(this.#write(), segments));
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
    if (this.dimension === 3) throw new TypeError("area: expected a 2D spline, got a 3D one");
    this.#write();
    return core().spline_area();
  }

  /**
   * The smallest box that contains the spline.
   *
   * @returns {{ min: Point, max: Point }}
   */
  bounds() {
    core().spline_bounds(this.#write(), true);
    return boxAt(readResult(0, 6), this.dimension);
  }

  /**
   * The box of the control points.
   *
   * @returns {{ min: Point, max: Point }}
   */
  controlBounds() {
    core().spline_bounds(this.#write(), false);
    return boxAt(readResult(0, 6), this.dimension);
  }

  /**
   * The continuity at the joint t = `joint` (closed splines have a joint 0, too).
   *
   * @param {number} joint
   * @param {number} [tolerance] a distance, by default 1e-9 of the extent of the two segments
   * @returns {Continuity}
   */
  continuity(joint, tolerance) {
    this.#checkJoint(joint);
    const count = core().spline_continuity(this.#write(), joint, check.optionalTolerance(tolerance));
    const [c0, g1, c1, g2, c2, gap, angle] = readResult(0, count);
    return { c0: c0 === 1, g1: g1 === 1, c1: c1 === 1, g2: g2 === 1, c2: c2 === 1, gap, angle };
  }

  /**
   * The spline with one more segment that ends at `point`, with automatic handles.
   *
   * @param {PointLike} point
   * @returns {Spline}
   */
  append(point) {
    if (this.closed) throw new RangeError("append: expected an open spline, which has an end, got a closed one");
    return this.#read(core().spline_append(this.#write(this.#coordinates(point, "point"))));
  }

  /**
   * Moves a control point and then repairs the joints outwards from it: the nearest joint first, each joint once, and
   * each point is moved at most once. A joint mode that cannot be satisfied leaves the points where they are;
   * `continuity` reports what holds.
   *
   * The handles of a joint move with it. "c2" and "g2" need segments of degree 3 or more, otherwise they act as "c1"
   * and "g1"; "auto" sets handles only on such segments, also the handle of a neighbouring open end.
   *
   * @param {number} index
   * @param {PointLike} to
   * @param {{ joints?: ArrayLike<JointMode | undefined> | Record<number, JointMode> }} [options] `joints[k]`: the mode
   *   of the joint at t = k, by default "free"
   * @returns {Spline}
   * @throws {RangeError} for an index past the last point, an unknown mode, and "g2" in 3D
   */
  movePoint(index, to, options) {
    const last = this.#data.flat.length / this.dimension - 1;
    check.whole(index, "index", 0, last);
    const modes = modeCodes(check.options(options).joints, this.segmentCount, this.dimension);
    const position = this.#coordinates(to, "to");
    const args = new Float64Array(position.length + modes.length);
    args.set(position);
    args.set(modes, position.length);
    return this.#read(core().spline_move_point(this.#write(args), index));
  }

  /**
   * The spline with the joint changed to satisfy the mode; the handle before the joint is kept ("auto" sets both
   * handles).
   *
   * @param {number} joint
   * @param {JointMode} mode
   * @returns {Spline}
   * @throws {RangeError} if there is no such joint, and for "g2" in 3D
   */
  setJoint(joint, mode) {
    this.#checkJoint(joint);
    return this.#read(core().spline_set_joint(this.#write(), joint, modeCode(mode, "mode", this.dimension)));
  }

  /**
   * The same spline with an additional joint at t.
   *
   * @param {number} t 0 to the number of segments
   * @returns {Spline}
   */
  insert(t) {
    check.finite(t, "t");
    return this.#read(core().spline_insert(this.#write(), t));
  }

  /**
   * The spline without a joint: its two segments become one. This is the exact inverse of `insert`.
   *
   * @param {number} joint
   * @returns {Spline}
   */
  remove(joint) {
    this.#checkJoint(joint);
    return this.#read(core().spline_remove(this.#write(), joint));
  }

  /**
   * The same spline with the opposite direction.
   *
   * @returns {Spline}
   */
  reverse() {
    return this.#read(core().spline_reverse(this.#write()));
  }

  /**
   * The spline transformed by an affine map.
   *
   * @param {MatrixLike} matrix
   * @returns {Spline}
   */
  transform(matrix) {
    const { flat, dimension } = this.#data;
    writeArguments(flat, 12).set(check.affine(matrix), flat.length);
    core().points_transform(dimension, flat.length / dimension);
    return splineOf({ ...this.#data, flat: readResult(0, flat.length) });
  }

  /**
   * The point of the spline that is nearest to p; t runs from 0 to the number of segments. Of several nearest points,
   * it is the one with the smallest t.
   *
   * @param {PointLike} p
   * @returns {Nearest}
   */
  nearest(p) {
    core().spline_nearest(this.#write(this.#coordinates(p, "p")));
    return readNearest(this.dimension);
  }

  /**
   * All intersections with a curve or another spline, sorted by t, then by u, which run from 0 to the numbers of
   * segments. An intersection at a joint is reported once; a shared part that runs across joints is one overlap. 2D
   * only.
   *
   * In the worst case each pair of segments is compared, with the limits of `Curve.intersections`.
   *
   * @param {Curve | Spline} other
   * @returns {Intersection[]}
   */
  intersections(other) {
    return intersectSplines(this[SPLINE_DATA](), splineDataOf(other));
  }

  /**
   * The points that the spline passes twice, sorted by t; t < u. Joints and the start of a closed spline do not count
   * as passed twice; the end point of an open spline that ends at its start does. 2D only.
   *
   * @returns {SelfIntersection[]}
   */
  selfIntersections() {
    require2D("selfIntersections", "spline", this.dimension);
    return selfIntersectSpline(this[SPLINE_DATA]());
  }

  /**
   * @internal
   * @returns {SplineData}
   */
  [SPLINE_DATA]() {
    require2D("intersections", "spline", this.dimension);
    return this.#data;
  }

  /**
   * A spline with few cubic segments through a sequence of points (a stroke drawn by hand, a dense polyline): the
   * distance of every point from the spline is at most the tolerance. Corners are kept, the other joints are smooth;
   * consecutive equal points count once.
   *
   * @param {PointsLike} points at least 2
   * @param {number} tolerance
   * @param {{ closed?: boolean, dimension?: 2 | 3 }} [options] `closed`: whether to continue from the last point to the
   *   first
   * @returns {Spline}
   */
  static fit(points, tolerance, options) {
    const { closed = false, dimension: requested } = check.options(options);
    const { flat, dimension } = flatten(points, requested, 2);
    const count = flat.length / dimension;
    if (count < 2) throw new RangeError(`points: expected at least 2 points, got ${count}`);
    check.positive(tolerance, "tolerance");
    writeArguments(flat);
    const spline = readSpline(core().spline_fit(dimension, count, tolerance, Boolean(closed)), dimension);
    releaseMemory();
    return spline;
  }

  /**
   * A spline with fewer cubic segments whose Hausdorff distance from this one is at most the tolerance. Corners are
   * kept. If the number of segments cannot be reduced and no degree is above 3, the spline is returned unchanged;
   * segments of higher degrees become cubics, as many as the tolerance requires.
   *
   * If more than 4096 vertices per segment would be needed (tolerances below about 1e-7 of its size), segments of
   * degree up to 3 are returned unchanged, and higher degrees as cubics with the same tangents, at most 4096 for each
   * segment (else a RangeError).
   *
   * @param {number} tolerance
   * @returns {Spline}
   */
  simplify(tolerance) {
    check.positive(tolerance, "tolerance");
    return this.#read(core().spline_simplify(this.#write(), tolerance));
  }

  /**
   * The offset curve at a distance along the normal: the offset curves of the segments (see `Curve.offset`), joined at
   * corners on both sides. 2D only. Nothing is trimmed; the offset of a closed spline is closed.
   *
   * @param {number} distance
   * @param {{ tolerance?: number, join?: "round" | "miter" | "bevel" }} [options] `join`: by default "round"; the
   *   miter limit is 4 times the distance
   * @returns {Spline}
   */
  offset(distance, options) {
    if (this.dimension === 3) throw new TypeError("offset: expected a 2D spline, got a 3D one");
    check.finite(distance, "distance");
    const { tolerance, join = "round" } = check.options(options);
    const code = JOINS.indexOf(check.oneOf(join, "join", JOINS));
    const maxError = check.optionalTolerance(tolerance);
    this.#write();
    return readSpline(core().spline_offset(distance, maxError, code), 2);
  }

  /**
   * Draws the spline on a canvas context or a Path2D; 2D only.
   *
   * @param {CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D | Path2D} target
   * @param {{ tolerance?: number }} [options] `tolerance`: for degrees above 3, which are drawn as cubics
   */
  trace(target, options) {
    const { flat, dimension, degrees, closed } = this.#data;
    if (dimension === 3) throw new TypeError("trace: expected a 2D spline, got a 3D one");
    traceOn(packedSpline(flat, degrees, closed), target, options);
  }

  /**
   * The spline as a B-spline whose knots are the joints, with the degree as multiplicity; `fromBSpline` returns exactly
   * this spline.
   *
   * @returns {BSpline}
   * @throws {RangeError} if the degrees differ
   */
  toBSpline() {
    return toBSpline(this.#data);
  }

  /**
   * The spline as SVG path data, see `Path.toSVG`; 2D only.
   *
   * @param {SvgOptions} [options]
   * @returns {string}
   */
  toSVG(options) {
    const { flat, dimension, degrees, closed } = this.#data;
    if (dimension === 3) throw new TypeError("toSVG: expected a 2D spline, got a 3D one");
    return svgOf(packedSpline(flat, degrees, closed), options);
  }

  /**
   * @returns {{ points: number[][], degrees: number[], closed: boolean }}
   */
  toJSON() {
    const { flat, dimension, degrees, closed } = this.#data;
    return { points: nested(flat, dimension), degrees: [...degrees], closed };
  }

  /**
   * Writes the spline, and then further numbers, to the arena.
   *
   * @param {ArrayLike<number>} [further]
   * @returns {2 | 3} the dimension
   */
  #write(further) {
    const { flat, dimension, degrees, closed } = this.#data;
    const head = 2 + degrees.length;
    const view = writeArguments(
      Float64Array.of(degrees.length, closed ? 1 : 0),
      head + flat.length + (further?.length ?? 0),
    );
    view.set(degrees, 2);
    view.set(flat, head);
    if (further) view.set(further, head + flat.length);
    return dimension;
  }

  /** @param {number} length */
  #read(length) {
    return readSpline(length, this.dimension);
  }

  /**
   * @param {PointLike} point
   * @param {string} name
   */
  #coordinates(point, name) {
    const coordinates = new Float64Array(this.dimension);
    writePoint(coordinates, 0, point, this.dimension, name);
    return coordinates;
  }

  /** @param {unknown} joint */
  #checkJoint(joint) {
    check.whole(joint, "joint", this.closed ? 0 : 1, this.segmentCount - 1);
  }
}

/** Data that is already checked: the constructor accepts it from inside the package. */
class CheckedSplineData {
  /** @param {SplineData} data */
  constructor(data) {
    this.data = data;
  }
}

/** @param {unknown} other */
function asSpline(other) {
  return check.instanceOf(other, "other", Spline); // outside of the class, see curve.js
}

/**
 * @internal
 * @param {SplineData} data
 */
export function splineOf(data) {
  return new Spline(/** @type {any} */ (new CheckedSplineData(data)));
}

/**
 * Reads a spline from the arena.
 *
 * @internal
 * @param {number} length
 * @param {2 | 3} dimension
 */
export function readSpline(length, dimension) {
  const numbers = readResult(0, length);
  const head = 2 + numbers[0];
  return splineOf({
    flat: numbers.slice(head),
    dimension,
    degrees: [...numbers.subarray(2, head)],
    closed: numbers[1] === 1,
  });
}
