import { checkedData, fromChecked } from "../checked.js";
import { curvesModule } from "../../wasm/curves-module.js";
import * as check from "../check.js";
import { pointAndDirections } from "../arc-length.js";
import { arcLengthsOf, segmentAtLength } from "./arc-length-table.js";
import { coreCurveOf } from "../curve/core-curve.js";
import { SegmentTree } from "../segment-tree.js";
import { onlySplineData, curveData, requireJSON } from "../brand.js";
import { showInNode } from "../inspected.js";
import { partsAt } from "../parts.js";
import { flatten, nested, pointAt, pointList, samePoints, writePoint, requireList, boxAt } from "../points.js";
import { SegmentIndex } from "./segment-index.js";
import { affine } from "../affine.js";
import { modeCode, modeCodes } from "../joints.js";
import { svgOf, traceOn } from "../../io/svg-write.js";
import { packedSpline } from "../../wasm/packed-path.js";
import type { PointAtLength } from "../arc-length.js";
import type { SplineData } from "../brand.js";
import type { PointLike, PointsLike, TransformLike, Complete } from "../check.js";
import type { CoreCurve } from "../curve/core-curve.js";
import type { Nearest } from "../curve-queries.js";
import type { Point, PointArrays, Bounds } from "../points.js";
import type { Continuity, JointMode } from "../joints.js";
import type { SvgOptions } from "../../io/svg-write.js";

/** Whether Node knows how to show the instances. */
let isShown = false;

/** Options of the constructor of `Spline`. */
export interface SplineOptions {
  /** Of all segments, 3 by default */
  degree?: number;
  /** Whether the spline is closed, so that its end is its start; false by default */
  closed?: boolean;
  /** How a flat array of coordinates is read, 2 by default */
  dimension?: 2 | 3;
}

/** What `Spline.toJSON` returns; `Spline.fromJSON` also reads other forms of points. */
export type SplineJSON = { points: PointsLike; degrees: number[]; closed: boolean; dimension?: 2 | 3 };

/**
 * Bézier curves joined end to end. Segment k covers t from k to k + 1 and has its own degree.
 *
 *     const spline = new Spline([[0, 0], [0, 2], [2, 2], [2, 0], [2, -2], [4, -2], [4, 0]]);
 *     spline.continuity(1).c1; // true
 *
 * What repeated queries need (segments, arc lengths, boxes) is computed once and kept. In TypeScript, `Spline<2>` and
 * `Spline<3>` have points `{x, y}` and `{x, y, z}`, see `Curve`.
 *
 * This is `Spline` of casteljau/core. That of `casteljau` extends it; where a function takes a spline, it takes the splines
 * of every entry point.
 */
export class CoreSpline<D extends 2 | 3 = 2 | 3, C extends CoreCurve<D> = CoreCurve<D>> {
  #data: SplineData;
  /** The segments that were asked for so far. */
  #segments: C[] = [];
  #index: SegmentIndex | undefined;
  #arcLengths: Float64Array | undefined;
  #tree: SegmentTree | undefined;
  /** The smallest tolerance that the core has accepted. */
  #acceptedTolerance = Infinity;

  /**
   * The spline of the given control points, with segments of one degree that share their end points.
   *
   * @param points n · degree + 1 control points, closed n · degree
   * @param options `degree`: of all segments, 3 by default; `closed`: whether the last segment ends at the first
   *   point, false by default; `dimension`: 2 or 3, how a flat array is read
   * @throws {RangeError} for a wrong number of points, a NaN or an infinity
   */
  constructor(points: PointArrays<D> | PointsLike, options?: { degree?: number; closed?: boolean; dimension?: D }) {
    if (!isShown) show();
    this.#data = checkedData<SplineData>(points) ?? dataOf(points, options);
  }

  /** 2 in the plane, 3 in space. */
  get dimension() {
    return this.#data.dimension as D;
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
   * @returns a copy of the coordinates of all control points; joints are listed once
   */
  controlPoints(): Float64Array {
    return this.#data.flat.slice();
  }

  /** All control points as objects; joints are listed once. */
  points(): Point<D>[] {
    return pointList(this.#data.flat, this.dimension);
  }

  /** The segments as curves. */
  segments(): C[] {
    return this.#data.degrees.map((_, k) => this._segment(k));
  }

  /**
   * Whether both have the same structure and each control point lies within a distance of its counterpart.
   *
   * @param other the value to compare with
   * @param tolerance the largest distance of two control points, by default 0
   */
  equals(other: CoreSpline, tolerance = 0): boolean {
    const [a, b] = [this.#data, onlySplineData(other, "other")];
    const sameStructure = a.closed === b.closed && a.dimension === b.dimension && `${a.degrees}` === `${b.degrees}`;
    return sameStructure && samePoints(a.flat, b.flat, a.dimension, tolerance);
  }

  /** The spline as an object for JSON, from which `Spline.fromJSON` makes an equal spline. */
  toJSON(): { points: number[][]; degrees: number[]; closed: boolean } {
    const { flat, dimension, degrees, closed } = this.#data;
    return { points: nested(flat, dimension), degrees: [...degrees], closed };
  }

  /**
   * See `brand.js`.
   *
   * @internal
   */
  get casteljauType(): "spline" {
    return "spline";
  }

  /**
   * The data, see `Branded`.
   *
   * @internal
   */
  casteljauData(): SplineData {
    return this.#data;
  }

  /**
   * Where the segments are in the list of points.
   *
   * @internal
   */
  get _index() {
    this.#index ??= new SegmentIndex(this.#data);
    return this.#index;
  }

  /**
   * Segment k as a curve, which is created by the first call.
   *
   * @internal
   */
  _segment(k: number): C {
    this.#segments[k] ??= this._curveOf(this._index.pointsOf(k).slice());
    return this.#segments[k];
  }

  /**
   * The segment that contains t, its index k, and the parameter on it. A joint belongs to the segment that starts
   * there, the end to the last segment; values outside belong to the first and the last segment.
   *
   * @internal
   */
  _locate(t: number): { k: number; segment: C; rest: number } {
    check.finite(t, "t");
    const k = Math.min(Math.max(Math.floor(t), 0), this.#data.degrees.length - 1);
    return { k, segment: this._segment(k), rest: t - k };
  }

  /**
   * A segment.
   *
   * @internal
   */
  _curveOf(flat: Float64Array): C {
    return coreCurveOf({ flat, dimension: this.dimension }) as unknown as C;
  }

  /**
   * A spline of the same class.
   *
   * @internal
   */
  _splineOf(data: SplineData): this {
    return coreSplineOf(data) as this;
  }

  /**
   * @internal
   * Writes the spline, and then further numbers, to the arena.
   * @returns the dimension
   */
  _write(further?: ArrayLike<number>): D {
    const { flat, dimension, degrees, closed } = this.#data;
    const head = 2 + degrees.length;
    const view = curvesModule.write(
      Float64Array.of(degrees.length, closed ? 1 : 0),
      head + flat.length + (further?.length ?? 0),
    );
    view.set(degrees, 2);
    view.set(flat, head);
    if (further) view.set(further, head + flat.length);
    return dimension as D;
  }

  /**
   * @internal
   * Reads a spline of the same dimension from the arena.
   */
  _read(length: number): this {
    return this._splineOf(readSplineData(length, this.dimension));
  }

  /**
   * Reads a point from the arena.
   *
   * @internal
   */
  _readPoint(): Point<D> {
    return pointAt(curvesModule.read(0, 3), 0, this.dimension);
  }

  /**
   * The coordinates of a point of the dimension of the spline.
   *
   * @internal
   */
  _coordinates(point: PointLike, name: string): Float64Array {
    const coordinates = new Float64Array(this.dimension);
    writePoint(coordinates, 0, point, this.dimension, name);
    return coordinates;
  }

  /**
   * Throws a TypeError in 3D.
   *
   * @internal
   */
  _require2D(method: string) {
    check.require2D(method, "spline", this.dimension);
  }

  /** The smallest and the largest coordinates, once asked for */
  #bounds: Float64Array | undefined;

  /**
   * The point at t, from 0 to the number of segments.
   *
   * @param t the parameter, from 0 to the number of segments; others extrapolate
   */
  eval(t: number): Point<D> {
    const { segment, rest } = this._locate(t);
    return segment.eval(rest);
  }

  /**
   * The k-th derivative with respect to t; k = 0 is the point itself. At a joint the segment that starts there counts,
   * at the end the last segment. It is zero if k is greater than the degree of the segment.
   *
   * @param t 0 to the number of segments
   * @param k 1 by default
   * @returns in the unit of the points
   * @throws {RangeError} for a t that is not finite, and a k that is negative or no integer
   */
  derivativeAt(t: number, k = 1): Point<D> {
    const { segment, rest } = this._locate(t);
    return segment.derivativeAt(rest, k);
  }

  /**
   * The unit tangent at t, see `Curve.tangent`. At a joint the segment that starts there counts, at the end the last
   * segment. It is zero if all control points of that segment are equal.
   *
   * @param t 0 to the number of segments
   * @throws {RangeError} for a t that is not finite
   */
  tangent(t: number): Point<D> {
    const { segment, rest } = this._locate(t);
    return segment.tangent(rest);
  }

  /**
   * The unit normal at t: in 2D the tangent turned by +90°, (x, y) → (−y, x); in 3D the principal normal, which is zero
   * where the spline is straight. At a joint the segment that starts there counts, at the end the last segment.
   *
   * @param t 0 to the number of segments
   * @throws {RangeError} for a t that is not finite
   */
  normal(t: number): Point<D> {
    const { segment, rest } = this._locate(t);
    return segment.normal(rest);
  }

  /**
   * The curvature at t: in 2D positive when turning counter-clockwise (x right, y up), in 3D never negative. At a joint
   * the segment that starts there counts, at the end the last segment. Infinite at a cusp.
   *
   * @param t 0 to the number of segments
   * @returns in 1 / unit of the points
   * @throws {RangeError} for a t that is not finite
   */
  curvature(t: number): number {
    const { segment, rest } = this._locate(t);
    return segment.curvature(rest);
  }

  /**
   * Points at equally spaced t, both ends included.
   *
   * @param segmentsPerCurve how many parts for each segment, at least 1
   * @param options `into`: an array for the result, long enough
   */
  sample(segmentsPerCurve: number, options?: { into?: Float64Array }): Float64Array {
    check.segmentCount(segmentsPerCurve, "segmentsPerCurve");
    const into = check.options(options, ["into"]).into;
    const length = (segmentsPerCurve * this.segmentCount + 1) * this.dimension;
    if (into !== undefined) check.resultArray(into, length);
    const count = curvesModule.functions.spline_sample(this._write(), segmentsPerCurve);
    const result = into ? curvesModule.readInto(into, count) : curvesModule.read(0, count);
    curvesModule.release();
    return result;
  }

  /**
   * The points at the given parameters.
   *
   * @param ts the parameters
   * @param options `into`: an array for the result, long enough
   */
  evalAt(ts: ArrayLike<number>, options?: { into?: Float64Array }): Float64Array {
    const parameters = check.numbers(ts, "ts");
    const length = parameters.length * this.dimension;
    const into = check.resultArray(check.options(options, ["into"]).into, length);
    curvesModule.functions.spline_eval_at(this._write(parameters), parameters.length);
    return curvesModule.readInto(into, length);
  }

  /**
   * A polyline whose distance from the spline is nowhere greater than `tolerance`; joints are vertices.
   *
   * @param tolerance the largest distance, in the unit of the points
   */
  flatten(tolerance: number): { points: Float64Array; ts: Float64Array } {
    check.positive(tolerance, "tolerance");
    return curvesModule.readPolyline(curvesModule.functions.spline_flatten(this._write(), tolerance), this.dimension);
  }

  /** The smallest box that contains the spline. */
  bounds(): Bounds<D> {
    if (!this.#bounds) {
      curvesModule.functions.spline_bounds(this._write(), true);
      this.#bounds = curvesModule.read(0, 6);
    }
    return boxAt(this.#bounds, this.dimension);
  }

  /** The box of the control points. */
  controlBounds(): Bounds<D> {
    curvesModule.functions.spline_bounds(this._write(), false);
    return boxAt(curvesModule.read(0, 6), this.dimension);
  }

  /**
   * The continuity at the joint t = `joint` (closed splines have a joint 0, too).
   *
   * @param joint the number of the joint: its t
   * @param tolerance a distance, by default 1e-9 of the extent of the two segments
   */
  continuity(joint: number, tolerance?: number): Continuity {
    this._checkJoint(joint);
    const count = curvesModule.functions.spline_continuity(this._write(), joint, check.optionalTolerance(tolerance));
    const [c0, g1, c1, g2, c2, gap, angle] = curvesModule.read(0, count);
    return { c0: c0 === 1, g1: g1 === 1, c1: c1 === 1, g2: g2 === 1, c2: c2 === 1, gap, angle };
  }

  /**
   * The spline with one more segment that ends at `point`, with automatic handles.
   *
   * @param point the point, in the unit of the points
   */
  append(point: PointLike): this {
    if (this.closed) throw new RangeError("append: expected an open spline, which has an end, got a closed one");
    return this._read(curvesModule.functions.spline_append(this._write(this._coordinates(point, "point"))));
  }

  /**
   * Moves a control point and then repairs the joints outwards from it: the nearest joint first, each joint once, and
   * each point is moved at most once. A joint mode that cannot be satisfied leaves the points where they are;
   * `continuity` reports what holds.
   *
   * The handles of a joint move with it. "c2" and "g2" need segments of degree 3 or more, otherwise they act as "c1"
   * and "g1"; "auto" sets handles only on such segments, also the handle of a neighbouring open end.
   *
   * @param index the number of the control point, from 0
   * @param to the new position
   * @param options `joints[k]`: the mode of the joint at t = k, by default "free"; the ends of an open spline have none
   * @throws {RangeError} for an index past the last point, a joint that does not exist, an unknown mode, and "g2" in 3D
   */
  movePoint(
    index: number,
    to: PointLike,
    options?: { joints?: ArrayLike<JointMode | undefined> | Record<number, JointMode> },
  ): this {
    const last = this.casteljauData().flat.length / this.dimension - 1;
    check.whole(index, "index", 0, last);
    const { joints } = check.options(options, ["joints"]);
    const modes = modeCodes(joints, this.segmentCount, this.closed, this.dimension);
    const position = this._coordinates(to, "to");
    const args = new Float64Array(position.length + modes.length);
    args.set(position);
    args.set(modes, position.length);
    return this._read(curvesModule.functions.spline_move_point(this._write(args), index));
  }

  /**
   * The spline with the joint changed to satisfy the mode; the handle before the joint is kept ("auto" sets both
   * handles).
   *
   * @param joint the number of the joint: its t
   * @param mode the mode of the joint
   * @throws {RangeError} if there is no such joint, and for "g2" in 3D
   */
  setJoint(joint: number, mode: JointMode): this {
    this._checkJoint(joint);
    return this._read(
      curvesModule.functions.spline_set_joint(this._write(), joint, modeCode(mode, "mode", this.dimension)),
    );
  }

  /**
   * The parts before and after t, as open splines whose parameters start at 0.
   *
   * The segment that contains t is split by `Curve.split`; the other control points are unchanged. At a joint no
   * segment is split. At the start and at the end one part is a single segment whose points are equal. A closed spline
   * is also divided at its start: the first part begins there, the second part ends there.
   *
   * With a list of parameters, in any order: the parts from 0 to the smallest one, between neighbours, and from the
   * largest one to the end, see `subsegment`. Equal parameters, and those at the ends, give parts that are points.
   *
   * @param t 0 to the number of segments; values outside extrapolate the first and the last segment
   * @throws {RangeError} for a t that is not finite
   */
  split(t: number): [this, this];
  /** @param ts any number of parameters */
  split(ts: ArrayLike<number>): this[];
  split(t: number | ArrayLike<number>): this[] {
    if (check.isList(t)) return partsAt(this, t, this.segmentCount);
    const { k, segment, rest } = this._locate(t);
    const count = this.segmentCount;
    if (rest === 0 && k > 0) return [this._part([], 0, k, []), this._part([], k, count, [])];
    const [left, right] = segment.split(rest);
    return [this._part([], 0, k, [left]), this._part([right], k + 1, count, [])];
  }

  /**
   * The part from t0 to t1 as an open spline whose parameters start at 0, reversed if t0 > t1.
   *
   * Whole segments in between keep their control points. With t0 = t1 it is a single segment whose points are equal. It
   * does not cross the start of a closed spline.
   *
   * @param t0 0 to the number of segments; values outside extrapolate the first and the last segment
   * @param t1 the parameter of the end
   * @throws {RangeError} for a value that is not finite
   */
  subsegment(t0: number, t1: number): this {
    check.finite(t0, "t0");
    check.finite(t1, "t1");
    if (t0 > t1) return this.subsegment(t1, t0).reverse();
    const [start, end] = [this._locate(t0), this._locate(t1)];
    const [last, to] = end.rest === 0 && end.k > start.k ? [end.k - 1, 1] : [end.k, end.rest];
    if (start.k === last) return this._part([start.segment.subsegment(start.rest, to)], 0, 0, []);
    const first = start.rest === 0 ? start.segment : start.segment.subsegment(start.rest, 1);
    return this._part([first], start.k + 1, last, [
      to === 1 ? this._segment(last) : this._segment(last).subsegment(0, to),
    ]);
  }

  /**
   * The corners of the convex hull of all control points, counter-clockwise (x right, y up); it contains the spline. If
   * all points are on a line, its two ends; if all are equal, that point. 2D only.
   *
   * @throws {TypeError} in 3D
   */
  hull(): Float64Array {
    this._require2D("hull");
    const { flat } = this.casteljauData();
    curvesModule.write(flat);
    return curvesModule.read(0, curvesModule.functions.curve_hull(flat.length / 2));
  }

  /**
   * The same spline with an additional joint at t.
   *
   * @param t 0 to the number of segments
   */
  insert(t: number): this {
    check.finite(t, "t");
    return this._read(curvesModule.functions.spline_insert(this._write(), t));
  }

  /**
   * The spline without a joint: its two segments become one. This is the exact inverse of `insert`.
   *
   * @param joint the number of the joint: its t
   */
  remove(joint: number): this {
    this._checkJoint(joint);
    return this._read(curvesModule.functions.spline_remove(this._write(), joint));
  }

  /** The same spline with the opposite direction. */
  reverse(): this {
    return this._read(curvesModule.functions.spline_reverse(this._write()));
  }

  /**
   * The spline transformed by an affine map.
   *
   * @param matrix a matrix, or a text such as "translate(50 50) rotate(30)"
   * @throws {RangeError} for an image with a coordinate beyond 2^500
   */
  transform<const M extends TransformLike>(matrix: M & Complete<M>): this {
    const { flat, dimension } = this.casteljauData();
    curvesModule.write(flat, 12).set(affine(matrix), flat.length);
    const length = curvesModule.functions.points_transform(dimension, flat.length / dimension);
    return this._splineOf({ ...this.casteljauData(), flat: curvesModule.read(0, length) });
  }

  /**
   * Draws the spline on a canvas context or a Path2D; 2D only.
   *
   * @param target a canvas context or a Path2D
   * @param options `tolerance`: for degrees above 3, which are drawn as cubics
   */
  trace(
    target: CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D | Path2D,
    options?: { tolerance?: number },
  ) {
    const { flat, dimension, degrees, closed } = this.casteljauData();
    check.require2D("trace", "spline", dimension);
    traceOn(packedSpline(flat, degrees, closed), target, options);
  }

  /**
   * The arc length with a relative error below 10⁻¹². Without a tolerance, further calls return the same number at once.
   *
   * @param tolerance the largest error, in the unit of the points, if it is to be smaller
   */
  length(tolerance?: number): number {
    if (tolerance === undefined) return this._arcLengths[this.segmentCount];
    const maxError = check.optionalTolerance(tolerance);
    return curvesModule.read(0, curvesModule.functions.spline_length(this._write(), maxError))[0];
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
      const [t] = curvesModule.read(0, curvesModule.functions.spline_time_at_length(this._write(), s, maxError));
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
  pointAtLength(s: number): PointAtLength<D> {
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
    const ts = curvesModule.read(0, curvesModule.functions.spline_equidistant_times(this._write(), segments));
    curvesModule.release();
    return ts;
  }

  /**
   * The signed area swept by the line from the origin to the point of the spline, positive while that line turns
   * counter-clockwise (x right, y up). For a closed spline it is the enclosed area. 2D only.
   */
  area(): number {
    this._require2D("area");
    this._write();
    return curvesModule.functions.spline_area();
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
    const point = this._coordinates(p, "p");
    this.#tree ??= new SegmentTree(this._index);
    const { k, found } = this.#tree.nearest(point) as { k: number; found: Nearest<D> };
    return { ...found, t: k + found.t };
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

  /** The spline as SVG path data without arcs, see `Path.toSVG`; 2D only. */
  toSVG(options?: SvgOptions): string {
    const { flat, dimension, degrees, closed } = this.casteljauData();
    check.require2D("toSVG", "spline", dimension);
    return svgOf(packedSpline(flat, degrees, closed), options);
  }

  /** The spline as `toSVG` writes it, or in space as JSON: `String(spline)` and `${spline}` give this text. */
  toString(): string {
    return this.dimension === 2 ? this.toSVG() : JSON.stringify(this);
  }

  /**
   * The open spline of some curves, the segments from one index to the one before another, and some more curves, each
   * of which starts at the end of the one before.
   *
   * @internal
   */
  _part(before: CoreCurve<D>[], from: number, to: number, after: CoreCurve<D>[]): this {
    const d: number = this.dimension;
    const whole = this._index.pointsFrom(from, to);
    const pieces = [
      ...before.map(({ _flat }) => _flat),
      ...(to > from ? [whole] : []),
      ...after.map(({ _flat }) => _flat),
    ];
    const flat = new Float64Array(pieces.reduce((sum, { length }) => sum + length - d, d));
    let at = 0;
    for (const piece of pieces) {
      flat.set(piece, at); // the first point of a piece replaces the last point of the one before
      at += piece.length - d;
    }
    const degreesOf = (curves: CoreCurve<D>[]) => curves.map(({ degree }) => degree);
    const degrees = [...degreesOf(before), ...this.degrees.slice(from, to), ...degreesOf(after)];
    return this._splineOf({ flat, dimension: this.dimension, degrees, closed: false });
  }

  /**
   * Throws a RangeError for what is no joint of the spline.
   *
   * @internal
   */
  _checkJoint(joint: unknown) {
    check.whole(joint, "joint", this.closed ? 0 : 1, this.segmentCount - 1);
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
  ): CoreSpline<D> {
    const { length, dimension } = joinCurves(curves, options);
    return coreSplineOf(readSplineData(length, dimension)) as CoreSpline<D>;
  }

  /**
   * The spline that `toJSON` described.
   *
   * @param json what `toJSON` returned
   */
  static fromJSON(json: SplineJSON): CoreSpline {
    return coreSplineOf(splineDataFromJSON(json));
  }
}

/** Outside of the class, so that it does not refer to itself; see `markClassNames` in xtask/bundle.js. */
function show() {
  isShown = showInNode(CoreSpline.prototype, "Spline", (value) => value.toJSON());
}

/**
 * A spline whose data is checked already.
 *
 * @internal
 */
export function coreSplineOf(data: SplineData): CoreSpline {
  return fromChecked(CoreSpline, data); // outside of the class, see ../curve/core-curve.js
}

function dataOf(points: PointsLike, options: SplineOptions | undefined): SplineData {
  requireList(points);
  const { degree = 3, closed, dimension: requested } = check.options(options, ["degree", "closed", "dimension"]);
  const isClosed = check.optionalBoolean(closed, "closed");
  check.whole(degree, "degree", 1, 64);
  const { flat, dimension } = flatten(points, requested, 2);
  const count = flat.length / dimension;
  const rest = isClosed ? 0 : 1;
  const segments = (count - rest) / degree;
  if (segments < 1 || !Number.isInteger(segments)) {
    const rule = isClosed ? `a multiple of ${degree}` : `a multiple of ${degree}, and one more,`;
    const others = [1, 2, 3].filter((other) => other !== degree && Number.isInteger((count - rest) / other));
    const hint = count > rest + 1 && others.length ? `; ${count} points fit degree ${others.join(" or ")}` : "";
    throw new RangeError(`points: expected ${rule} control points (degree ${degree}), got ${count}${hint}`);
  }
  return { flat, dimension, degrees: new Array(segments).fill(degree), closed: isClosed };
}

/**
 * The data of a spline in JSON.
 *
 * @internal
 */
export function splineDataFromJSON(json: SplineJSON): SplineData {
  requireJSON(json, "points, degrees and closed", ({ points }) => points !== undefined);
  const { flat, dimension } = flatten(json.points, json.dimension, 2);
  const degrees = [...check.numbers(json.degrees, "degrees")];
  degrees.forEach((degree, k) => check.whole(degree, `degrees[${k}]`, 1, 64));
  const closed = check.optionalBoolean(json.closed, "closed");
  const needed = degrees.reduce((sum, degree) => sum + degree, closed ? 0 : 1);
  if (degrees.length === 0 || needed !== flat.length / dimension) {
    throw new RangeError(`points: expected ${needed} (the sum of the degrees), got ${flat.length / dimension}`);
  }
  return { flat, dimension, degrees, closed };
}

/**
 * Reads a spline from the arena.
 *
 * @internal
 */
export function readSplineData(length: number, dimension: 2 | 3): SplineData {
  const numbers = curvesModule.read(0, length);
  const head = 2 + numbers[0];
  return {
    flat: numbers.slice(head),
    dimension,
    degrees: [...numbers.subarray(2, head)],
    closed: numbers[1] === 1,
  };
}

/**
 * Joins consecutive curves and leaves the spline in the arena.
 *
 * @internal
 * @param options `closed`: whether the last curve ends where the first starts, false by default
 */
export function joinCurves(
  curves: readonly CoreCurve[],
  options?: { closed?: boolean },
): { length: number; dimension: 2 | 3 } {
  if (!Array.isArray(curves)) throw new TypeError(`curves: expected an array of curves, got ${check.describe(curves)}`);
  if (curves.length === 0) throw new RangeError("curves: expected at least 1 curve, got 0");
  const data = Array.from(curves, (curve, k) => curveData(curve, `curves[${k}]`)); // also finds holes
  const dimension = data[0].dimension;
  const other = data.findIndex((curve) => curve.dimension !== dimension);
  if (other > 0) throw new TypeError(`curves[${other}]: expected a ${dimension}D curve, got a ${5 - dimension}D one`);
  const closed = check.optionalBoolean(check.options(options, ["closed"]).closed, "closed") ? 1 : 0;
  const degrees = data.map((curve) => curve.degrees[0]);
  curvesModule.write(Float64Array.from([data.length, closed, ...degrees, ...data.flatMap(({ flat }) => [...flat])]));
  return { length: curvesModule.functions.spline_from_curves(dimension), dimension };
}
