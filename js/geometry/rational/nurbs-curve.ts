import { checkedData, fromChecked } from "../checked.js";
import { curvesModule } from "../../wasm/curves-module.js";
import * as check from "../check.js";
import { packedSpline } from "../../wasm/packed-path.js";
import { directionOfDegrees } from "../../io/svg-arc.js";
import { svgOfRational } from "../../io/svg-conic.js";
import { checkTolerance, traceOn } from "../../io/svg-write.js";
import { affine } from "../affine.js";
import { pointAndDirections } from "../arc-length.js";
import { nurbsData, packedPath, requireJSON } from "../brand.js";
import { showInNode } from "../inspected.js";
import { subpathsOf } from "../path/packed-shape.js";
import { boxAt, dimensionOf, flatten, nested, pointList, requireList, samePoints, writePoint } from "../points.js";
import { coreSplineOf, readSplineData } from "../spline/core-spline.js";
import { intersectNurbs, intersectSplineWithNurbs, selfIntersectNurbs } from "./intersections.js";
import { alike, nurbsDataOf, nurbsOfSpline, readNurbsData, writeNurbs } from "./nurbs-data.js";
import { projective } from "./projective.js";
import { checkedWeights, defaultTolerance, rationalCurveOf } from "./rational-curve.js";
import type { PointAtLength } from "../arc-length.js";
import type { NurbsData, SplineData } from "../brand.js";
import type { PointLike, PointsLike, TransformLike } from "../check.js";
import type { CoreCurve } from "../curve/core-curve.js";
import type { Extrema, Nearest } from "../curve-queries.js";
import type { Intersection, SelfIntersection } from "../intersections.js";
import type { CorePath } from "../path/core-path.js";
import type { PathTime } from "../path/path-queries.js";
import type { Bounds, Point, PointArrays } from "../points.js";
import type { CoreSpline } from "../spline/core-spline.js";
import type { RationalCurve } from "./rational-curve.js";
import type { SvgOptions } from "../../io/svg-write.js";

/** Whether Node knows how to show the instances. */
let isShown = false;

/** What a NURBS curve is made of. */
export interface NurbsOptions<D extends 2 | 3 = 2 | 3> {
  /** The degree p, 1 to 64 */
  degree: number;
  /** The control points, at least p + 1 of them (closed: at least 1); a flat array is 2D unless `dimension` is 3 */
  points: PointArrays<D> | PointsLike;
  /** A weight for each point, from 2^-500 to 2^500; all 1 by default */
  weights?: ArrayLike<number>;
  /** The knots in ascending order: as many as points, and p + 1 more (closed: 1 more) */
  knots: ArrayLike<number>;
  /** Whether points and knots are periodic; false by default */
  closed?: boolean;
  /** How a flat array of coordinates is read, 2 by default */
  dimension?: D;
}

/** What `NurbsCurve.toJSON` returns; `NurbsCurve.fromJSON` also reads other forms of points. */
export type NurbsCurveJSON = {
  degree: number;
  points: PointsLike;
  weights: ArrayLike<number>;
  knots: ArrayLike<number>;
  closed: boolean;
  dimension?: 2 | 3;
};

/**
 * One NURBS curve of degree 1 to 64, in the plane or in space: a B-spline with weights.
 *
 * C(t) = Σ wᵢ Nᵢ(t) Pᵢ / Σ wᵢ Nᵢ(t), where the Nᵢ are the B-splines of degree p over the knots u₀ ≤ u₁ ≤ …, for t in the domain:
 * from uₚ to uₙ with n points, of a closed curve from u₀ to uₙ, one period. Other values extrapolate the first and the last
 * segment. An open curve passes through its first and last point if the knot at that end occurs p times (p + 1 times with the
 * outer knot, which does not affect the curve). Curves are immutable: every change returns a new one. They need not be freed.
 *
 *     const circle = NurbsCurve.circle([0, 0], 2);
 *     circle.length(); // 12.566370614359172
 *
 * The segments, rational curves over the nonempty knot spans, are computed once and kept. In TypeScript, `NurbsCurve<2>` and
 * `NurbsCurve<3>` have points `{x, y}` and `{x, y, z}`, see `Curve`.
 */
export class NurbsCurve<D extends 2 | 3 = 2 | 3> {
  #data: NurbsData;
  #segments: RationalCurve<D>[] | undefined;
  #joints = new Float64Array();

  /**
   * The curve of the given degree, control points, weights and knots.
   *
   *     const points = [[0, 0], [1, 2], [3, 2], [4, 0]];
   *     new NurbsCurve({ degree: 2, points, weights: [1, 2, 2, 1], knots: [0, 0, 0, 1, 2, 2, 2] });
   *
   * @param options `degree`, `points` and `knots`; `weights`: all 1 by default; `closed`: false by default; `dimension`: 2 or 3,
   *   how a flat array is read; 2 by default
   * @throws {RangeError} for a wrong count, a NaN or an infinity, a weight that is not above 0, and knots that decrease or
   *   occur more than p times inside or p + 1 times at the ends
   * @throws {TypeError} for a value that is not a point
   */
  constructor(options: NurbsOptions<D>) {
    if (!isShown) show();
    const checked = checkedData<NurbsData>(options);
    this.#data = checked ?? dataOf(options);
    if (!checked) this.#readSegments();
  }

  /** The degree p of every segment. */
  get degree() {
    return this.#data.degree;
  }

  /** 2 in the plane, 3 in space. */
  get dimension() {
    return this.#data.dimension as D;
  }

  /** Whether points and knots are periodic. */
  get closed() {
    return this.#data.closed;
  }

  /** The ends of the range of t. */
  get domain(): [number, number] {
    const { degree, closed, knots, weights } = this.#data;
    return [knots[closed ? 0 : degree], knots[weights.length]];
  }

  /**
   * @returns a copy of the coordinates of the control points
   */
  controlPoints(): Float64Array {
    return this.#data.flat.slice();
  }

  /** The control points as objects. */
  points(): Point<D>[] {
    return pointList(this.#data.flat, this.dimension);
  }

  /**
   * @returns a copy of the weights of the control points
   */
  weights(): Float64Array {
    return this.#data.weights.slice();
  }

  /**
   * @returns a copy of the knots, in ascending order
   */
  knots(): Float64Array {
    return this.#data.knots.slice();
  }

  /**
   * The Greville abscissae: for each control point the mean of the p knots that belong to it, where it pulls the curve most.
   */
  greville(): Float64Array {
    return curvesModule.read(0, curvesModule.functions.nurbs_greville(this._write()));
  }

  /** The segments: the rational curves over the nonempty knot spans. Each ends at the point with which the next one starts. */
  segments(): RationalCurve<D>[] {
    return [...this.#readSegments()];
  }

  /**
   * The values of t at the ends of the segments, one more than segments.
   *
   * @returns a copy
   */
  joints(): Float64Array {
    this.#readSegments();
    return this.#joints.slice();
  }

  #readSegments(): RationalCurve<D>[] {
    if (this.#segments) return this.#segments;
    const { degree, dimension } = this.#data;
    const numbers = curvesModule.read(0, curvesModule.functions.nurbs_segments(this._write()));
    const count = numbers[0];
    this.#joints = numbers.slice(1, count + 2);
    const n = degree + 1;
    const segment = (_: unknown, k: number) => {
      const at = count + 2 + k * n * (dimension + 1);
      const weights = at + n * dimension;
      const points = { flat: numbers.slice(at, weights), dimension };
      return rationalCurveOf(points, numbers.slice(weights, weights + n)) as RationalCurve<D>;
    };
    this.#segments = Array.from({ length: count }, segment);
    return this.#segments;
  }

  /**
   * Whether both have the same degree and structure, each control point lies within a distance of its counterpart, and weights
   * and knots are equal within `tolerance` times the largest one.
   *
   * @param other the value to compare with
   * @param tolerance by default 0: equal coordinates, weights and knots
   */
  equals(other: NurbsCurve, tolerance = 0): boolean {
    const [a, b] = [this.#data, nurbsData(other, "other")];
    const sameStructure = a.degree === b.degree && a.closed === b.closed && a.dimension === b.dimension;
    if (!sameStructure || !samePoints(a.flat, b.flat, a.dimension, tolerance)) return false;
    return alike(a.weights, b.weights, tolerance) && alike(a.knots, b.knots, tolerance);
  }

  /** The curve as an object for JSON, from which `NurbsCurve.fromJSON` makes an equal curve. */
  toJSON(): { degree: number; points: number[][]; weights: number[]; knots: number[]; closed: boolean } {
    const { degree, flat, dimension, weights, knots, closed } = this.#data;
    return { degree, points: nested(flat, dimension), weights: [...weights], knots: [...knots], closed };
  }

  /**
   * See `brand.js`.
   *
   * @internal
   */
  get casteljauType(): "nurbscurve" {
    return "nurbscurve";
  }

  /**
   * The data, see `Branded`.
   *
   * @internal
   */
  casteljauData(): NurbsData {
    return this.#data;
  }

  /**
   * See `isRational` in ../intersections.ts.
   *
   * @internal
   */
  casteljauIntersections(spline: SplineData): Intersection[] {
    return intersectSplineWithNurbs(spline, this.#data);
  }

  /**
   * @internal
   * Writes the curve, and then further numbers, to the arena.
   * @returns the dimension
   */
  _write(further: ArrayLike<number> = []): number {
    writeNurbs([this.#data], further);
    return this.dimension;
  }

  /**
   * @internal
   * Reads the curve at an index of the arena, of the same dimension.
   * @param end the index after it, negative if the core reported an error
   */
  _read(end: number, from = 0): NurbsCurve<D> {
    return readNurbs(end, this.dimension, from) as NurbsCurve<D>;
  }

  /**
   * Throws a TypeError in 3D.
   *
   * @internal
   */
  _require2D(method: string) {
    check.require2D(method, "curve", this.dimension);
  }

  /** The index of the segment that contains t; the end belongs to the last segment. */
  #segmentAt(t: number): number {
    if (typeof t !== "number" || t - t !== 0) check.finite(t, "t");
    let k = 0;
    let after = this.#readSegments().length;
    const joints = this.#joints;
    while (after - k > 1) {
      const middle = (k + after) >> 1;
      if (joints[middle] <= t) k = middle;
      else after = middle;
    }
    return k;
  }

  /** The parameter on segment k at t. */
  #parameterOn(k: number, t: number): number {
    const from = this.#joints[k];
    const to = this.#joints[k + 1];
    return t === to ? 1 : (t - from) / (to - from);
  }

  /** What a segment gives at t. */
  #at<R>(t: number, query: (segment: RationalCurve<D>, s: number) => R): R {
    const k = this.#segmentAt(t);
    const [segment, s] = [this.#readSegments()[k], this.#parameterOn(k, t)];
    if (!(s >= 0 && s <= 1) && !(segment._denominatorAt(s) > 0)) {
      throw new RangeError(`t: expected a parameter at which the denominator of the curve is above 0, got ${t}`);
    }
    return query(segment, s);
  }

  /**
   * The point at t.
   *
   * @param t the parameter, in the domain; others extrapolate
   * @throws {RangeError} outside of the domain where the denominator is not above 0
   */
  eval(t: number): Point<D> {
    const k = this.#segmentAt(t);
    const s = this.#parameterOn(k, t);
    if (s >= 0 && s <= 1) return this.#readSegments()[k].eval(s);
    return this.#at(t, (segment, outside) => segment.eval(outside));
  }

  /**
   * `segments` + 1 points at even steps of t over the domain.
   *
   * @param segments how many parts, at least 1
   * @param options `into`: at least (segments + 1) · dimension numbers long
   */
  sample(segments: number, options?: { into?: Float64Array }): Float64Array {
    check.segmentCount(segments);
    const [from, to] = this.domain;
    const at = (_: unknown, i: number) => from * (1 - i / segments) + to * (i / segments);
    return this.evalAt(Array.from({ length: segments + 1 }, at), options);
  }

  /**
   * The points at the given parameters.
   *
   * @param ts the parameters
   * @param options `into`: at least ts.length · dimension numbers long
   * @throws {RangeError} as `eval`
   */
  evalAt(ts: ArrayLike<number>, options?: { into?: Float64Array }): Float64Array {
    const parameters = check.numbers(ts, "ts");
    const d = this.dimension;
    const into = check.resultArray(check.options(options, ["into"]).into, parameters.length * d);
    parameters.forEach((t, i) => writePoint(into, i * d, this.eval(t), d, "point"));
    return into;
  }

  /**
   * The k-th derivative by t. At a joint it is that of the segment that starts there.
   *
   * @param t the parameter, in the domain; others extrapolate
   * @param k the order of the derivative, 0 to 64, by default 1
   * @throws {RangeError} as `eval`
   */
  derivativeAt(t: number, k = 1): Point<D> {
    const at = this.#segmentAt(t);
    check.whole(k, "k", 0, 64);
    const derivative = this.#at(t, (segment, s) => segment._derivativeAt(s, k)) as { x: number; y: number; z?: number };
    const length = this.#joints[at + 1] - this.#joints[at];
    for (let i = 0; i < k; i++) {
      derivative.x /= length;
      derivative.y /= length;
      if (derivative.z !== undefined) derivative.z /= length;
    }
    return derivative as Point<D>;
  }

  /**
   * The unit tangent at t; see `RationalCurve.tangent`.
   *
   * @param t the parameter, in the domain; others extrapolate
   * @throws {RangeError} as `eval`
   */
  tangent(t: number): Point<D> {
    return this.#at(t, (segment, s) => segment.tangent(s));
  }

  /**
   * The unit normal at t; see `RationalCurve.normal`.
   *
   * @param t the parameter, in the domain; others extrapolate
   * @throws {RangeError} as `eval`
   */
  normal(t: number): Point<D> {
    return this.#at(t, (segment, s) => segment.normal(s));
  }

  /**
   * The curvature at t; see `RationalCurve.curvature`.
   *
   * @param t the parameter, in the domain; others extrapolate
   * @throws {RangeError} as `eval`
   */
  curvature(t: number): number {
    return this.#at(t, (segment, s) => segment.curvature(s));
  }

  /**
   * The same curve with a knot inserted.
   *
   * @param t the knot, in the domain
   * @param times how often, by default once
   * @throws {RangeError} for a t outside of the domain, and for more than p times the same knot inside
   */
  insertKnot(t: number, times = 1): NurbsCurve<D> {
    check.finite(t, "t");
    check.whole(times, "times", 0, 64);
    return this._read(curvesModule.functions.nurbs_insert_knot(this._write(), t, times));
  }

  /**
   * The same curve with knots inserted, in any order.
   *
   * @param ts the knots, in the domain
   * @throws {RangeError} as `insertKnot`
   */
  refine(ts: ArrayLike<number>): NurbsCurve<D> {
    const knots = check.numbers(ts, "ts");
    return this._read(curvesModule.functions.nurbs_refine(this._write(knots), knots.length));
  }

  /**
   * The curve with one copy of a knot removed, and a bound on its distance from this curve at equal t: 0 up to rounding if the
   * curve is as smooth there as without the knot.
   *
   * With a tolerance the knot stays if the bound is above it: `curve` is then this curve, and `error` the bound that was too
   * large, Infinity if no curve without the knot is near. The bounds of several removals add up.
   *
   * @param t a knot inside of the domain
   * @param options `tolerance`: the largest bound that is accepted, above 0, in the unit of the points
   * @throws {RangeError} if t is no knot inside of the domain, and for a tolerance not above 0 or below 4 ulps of the largest
   *   coordinate; without a tolerance, also if no curve without it is near: a weight
   *   would not be above 0
   */
  removeKnot(t: number, options?: { tolerance?: number }): { curve: NurbsCurve<D>; error: number } {
    check.finite(t, "t");
    const tolerance = check.optionalTolerance(check.options(options, ["tolerance"]).tolerance);
    const end = curvesModule.count(curvesModule.functions.nurbs_remove_knot(this._write(), t, tolerance));
    const error = curvesModule.read(0, 1)[0];
    return { error, curve: tolerance > 0 && error > tolerance ? this : this._read(end, 1) };
  }

  /**
   * The same curve with a higher degree; every knot gets as many more copies, so the curve is as smooth as before.
   *
   * @param times by how much the degree is raised, by default 1
   * @throws {RangeError} for a degree above 64
   */
  elevate(times = 1): NurbsCurve<D> {
    check.whole(times, "times", 0, 64 - this.degree);
    let curve: NurbsCurve<D> = this;
    for (let k = 0; k < times; k++) curve = curve._read(curvesModule.functions.nurbs_elevate(curve._write()));
    return curve;
  }

  /**
   * Splits the curve at t into two open curves, whose domains together are that of this one.
   *
   * @param t the parameter, inside of the domain
   * @throws {RangeError} for any other t
   */
  split(t: number): [NurbsCurve<D>, NurbsCurve<D>] {
    check.finite(t, "t");
    const [from, to] = this.domain;
    if (!(t > from && t < to))
      throw new RangeError(`t: expected a number inside of the domain, ${from} to ${to}, got ${t}`);
    return [this.subsegment(from, t), this.subsegment(t, to)];
  }

  /**
   * The part from t0 to t1 as an open curve with that domain; reversed, with the same domain, if t0 > t1.
   *
   * @param t0 the parameter of the start, in the domain
   * @param t1 the parameter of the end, in the domain
   * @throws {RangeError} for parameters outside of the domain, and for equal ones
   */
  subsegment(t0: number, t1: number): NurbsCurve<D> {
    check.finite(t0, "t0");
    check.finite(t1, "t1");
    return this._read(curvesModule.functions.nurbs_subsegment(this._write(), t0, t1));
  }

  /** The same curve with the opposite direction and the same domain. */
  reverse(): NurbsCurve<D> {
    return this._read(curvesModule.functions.nurbs_reverse(this._write()));
  }

  /**
   * The curve transformed by an affine map, which keeps the weights, or by a projective map, which changes them; see
   * `RationalCurve.transform`.
   *
   * @param matrix 6, 9 or 16 numbers, a DOMMatrix or another object with a matrix, or a text such as "translate(50 50) rotate(30)"
   * @throws {RangeError} as there
   */
  transform(matrix: TransformLike): NurbsCurve<D> {
    const numbers = projective(matrix, this.dimension);
    if (numbers) return this._read(curvesModule.functions.nurbs_project(this._write(numbers)));
    const map = affine(matrix);
    const { flat, dimension } = this.#data;
    curvesModule.write(flat, map.length).set(map, flat.length);
    const length = curvesModule.functions.points_transform(dimension, flat.length / dimension);
    return nurbsOf({ ...this.#data, flat: curvesModule.read(0, length) }) as NurbsCurve<D>;
  }

  /** The smallest box that contains the curve. */
  bounds(): Bounds<D> {
    return boxAt(curvesModule.read(0, curvesModule.functions.nurbs_bounds(this._write())), this.dimension);
  }

  /** The box of the control points, which contains the curve. */
  controlBounds(): Bounds<D> {
    const { flat, dimension } = this.#data;
    curvesModule.write(flat);
    curvesModule.functions.curve_bounds(dimension, flat.length / dimension, false);
    return boxAt(curvesModule.read(0, 2 * dimension), this.dimension);
  }

  /** The parameters inside of the domain where a coordinate has a local extremum inside of a segment, sorted. */
  extrema(): Extrema {
    const [x, y, z] = Array.from({ length: this.dimension }, (_, axis) =>
      curvesModule.read(0, curvesModule.functions.nurbs_extrema(this._write(), axis)),
    );
    return this.dimension === 2 ? { x, y } : { x, y, z };
  }

  /**
   * The arc length, with a relative error below 10⁻¹² for weights whose ratios are at most 2²⁰ (up to degree 3, 2¹⁰⁰).
   *
   * At most 4096 intervals are integrated for each segment.
   *
   * @returns 0 if all control points are equal
   */
  length(): number {
    return this.#readSegments().reduce((sum, segment) => sum + segment.length(), 0);
  }

  /**
   * The t at which the arc length from the start is s. An s outside of [0, length] gives the nearer end of the domain.
   *
   * @param s the length, in the unit of the points
   */
  timeAtLength(s: number): number {
    check.finite(s, "s");
    return curvesModule.read(0, curvesModule.functions.nurbs_time_at_length(this._write(), s))[0];
  }

  /**
   * The point at the arc length s from the start, with its t, unit tangent and unit normal. An s outside of [0, length] gives
   * the nearer end.
   *
   * @param s in the unit of the points
   * @throws {RangeError} for a NaN or an infinity
   */
  pointAtLength(s: number): PointAtLength<D> {
    return pointAndDirections(this, this.timeAtLength(s));
  }

  /**
   * The signed area ½ ∫ (x dy − y dx) swept by the line from the origin to the point of the curve, positive while that
   * line turns counter-clockwise (x right, y up); for a closed curve the enclosed area. 2D only.
   */
  area(): number {
    this._require2D("area");
    return this.#readSegments().reduce((sum, segment) => sum + segment.area(), 0);
  }

  /**
   * The point of the curve that is nearest to p: the global minimum of the distance over the domain. Of several nearest points,
   * it is the one with the smallest t.
   *
   * @param p the point, in the unit of the points
   */
  nearest(p: PointLike): Nearest<D> {
    const coordinates = new Float64Array(this.dimension);
    writePoint(coordinates, 0, p, this.dimension, "p");
    const [segments, joints] = [this.#readSegments(), this.#joints];
    // The nearest start of a segment gives an upper bound; segments whose box is farther away are skipped.
    let max = Infinity;
    for (const segment of segments) max = Math.min(max, squareFromBox(segment.casteljauData().flat, coordinates, 1));
    let best: Nearest<D> | undefined;
    for (let k = 0; k < segments.length; k++) {
      const { flat, weights } = segments[k].casteljauData();
      if (squareFromBox(flat, coordinates, weights.length) * BOX_ROUNDING > max) continue;
      const found = segments[k]._nearest(coordinates);
      if (best && !(found.distance < best.distance)) continue;
      max = Math.min(max, found.distance * found.distance);
      const from = joints[k];
      const to = joints[k + 1];
      found.t = found.t === 1 ? to : from + found.t * (to - from);
      best = found;
    }
    return best as Nearest<D>; // the segment with the nearest start is not skipped
  }

  /**
   * All intersections with a curve, a rational curve, another NURBS curve or a spline (then u is its t), or a path (then u is a
   * location {subpath, t}), sorted by t, then by u, which are in the domains; with a path by its subpaths first.
   *
   * An intersection at a joint is reported once, and so is one at the start of a curve of several segments that ends there, as a
   * circle does; a shared part that runs across joints is one overlap. Kinds and limits are those of
   * `RationalCurve.intersections`, for each pair of segments. 2D only.
   *
   *     const circle = NurbsCurve.circle([0, 0], 5);
   *     circle.intersections(new Curve([[3, -9], [3, 9]])).map(({ point }) => point.y); // about [4, -4]
   *
   * @param other a curve, a rational curve, a NURBS curve, a spline or a path, of any entry point
   * @throws {TypeError} for a 3D curve
   */
  intersections<S extends CoreCurve | RationalCurve | NurbsCurve | CoreSpline | CorePath>(
    other: S,
  ): Intersection<number, S extends CorePath ? PathTime : number>[] {
    return intersectNurbs(this.#data, other) as any;
  }

  /**
   * The points that the curve passes twice, sorted by t; t < u. Joints and the start of a closed curve do not count as passed
   * twice; the end point of an open curve that ends at its start does. 2D only.
   */
  selfIntersections(): SelfIntersection[] {
    return selfIntersectNurbs(this.#data);
  }

  /**
   * A polyline whose distance from the curve is nowhere greater than `tolerance`; every joint is a vertex.
   *
   * @param tolerance in the unit of the points
   * @returns the vertices and their parameters
   * @throws {RangeError} for a tolerance not above 0 or below 4 ulps of the largest coordinate
   */
  flatten(tolerance: number): { points: Float64Array; ts: Float64Array } {
    check.positive(tolerance, "tolerance");
    const vertices = curvesModule.functions.nurbs_flatten(this._write(), tolerance);
    return curvesModule.readPolyline(curvesModule.count(vertices), this.dimension);
  }

  /**
   * The curve as a spline of cubics; segments whose weights are equal stay as they are. The spline is closed if the curve ends at
   * the point where it starts.
   *
   * @param options `tolerance`: the largest distance from the curve, in the unit of the points, by default 1e-4 of the diagonal of
   *   the control points' box, at least 1e-12 of the largest coordinate
   * @throws {RangeError} for a tolerance not above 0 or below 4 ulps of the largest coordinate
   */
  toSpline(options?: { tolerance?: number }): CoreSpline<D> {
    return coreSplineOf(this.#spline(check.options(options, ["tolerance"]).tolerance)) as CoreSpline<D>;
  }

  /** The data of `toSpline`. */
  #spline(tolerance: number | undefined): SplineData {
    const error = check.optionalTolerance(tolerance) || defaultTolerance(this.#data.flat, this.controlBounds());
    return readSplineData(curvesModule.functions.nurbs_to_spline(this._write(), error), this.dimension);
  }

  /**
   * Draws the curve on a canvas context or a Path2D: `moveTo` its start, then cubics. 2D only.
   *
   * @param target a canvas context or a Path2D
   * @param options `tolerance`: as in `toSpline`
   */
  trace(
    target: CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D | Path2D,
    options?: { tolerance?: number },
  ) {
    this._require2D("trace");
    const canvas = check.drawingTarget(target);
    const { flat, degrees, closed } = this.#spline(check.options(options, ["tolerance"]).tolerance);
    traceOn(packedSpline(flat, degrees, closed), canvas, options);
  }

  /**
   * The curve as SVG path data: segments of degree 2 that are arcs of ellipses as arcs (`A`), the others as cubics; closed if
   * the curve ends where it starts. 2D only.
   *
   * @param options `precision`: 0 to 100, the maximum number of digits after the decimal point; selects the shortest form;
   *   `tolerance`: of the cubics, as in `toSpline`
   */
  toSVG(options?: SvgOptions): string {
    this._require2D("toSVG");
    const { precision, tolerance } = check.options(options, ["precision", "tolerance"]);
    const segments = this.#readSegments();
    const maxError = check.optionalTolerance(tolerance);
    const [first, last] = [segments[0].casteljauData().flat, segments[segments.length - 1].casteljauData().flat];
    checkTolerance(packedSpline(this.#data.flat, [this.#data.weights.length - 1], false), maxError);
    const error = maxError || defaultTolerance(this.#data.flat, this.controlBounds());
    const closed = first[0] === last[last.length - 2] && first[1] === last[last.length - 1];
    const data = segments.map((segment) => segment.casteljauData());
    return svgOfRational(data, closed, precision, maxError, (k) => {
      const { flat, degrees } = segments[k].toSpline({ tolerance: error }).casteljauData();
      return packedSpline(flat, degrees, false);
    });
  }

  /** The curve as `toSVG` writes it, or in space as JSON: `String(curve)` and `${curve}` give this text. */
  toString(): string {
    return this.dimension === 2 ? this.toSVG() : JSON.stringify(this);
  }

  /**
   * An arc of a circle, counter-clockwise (x right, y up) if the end is above the start: degree 2, a span for each quarter turn
   * or less, over the domain [0, 1].
   *
   *     NurbsCurve.arc([0, 0], 1, 0, Math.PI / 2).eval(1); // { x: 0, y: 1 }
   *
   * In space the angles are measured in the plane perpendicular to the normal, from the projection of the x-axis, or of the y-axis if
   * the normal is parallel to the x-axis, counter-clockwise as seen from where the normal points.
   *
   * @param center in the plane or in space
   * @param radius at least 0
   * @param start the angle of the start, in radians
   * @param end the angle of the end, at most a full turn away
   * @param options `normal`: in space, by default [0, 0, 1]
   * @throws {RangeError} for a negative radius, more than a full turn, and a normal of length 0
   */
  static arc<D extends 2 | 3 = 2 | 3>(
    center: PointArrays<D>[number] | PointLike,
    radius: number,
    start: number,
    end: number,
    options?: { normal?: PointLike },
  ): NurbsCurve<D> {
    const dimension = dimensionOf(center, "center");
    const { normal } = check.options(options, ["normal"]);
    if (dimension === 2 && normal !== undefined) throw new TypeError("normal: expected none with a 2D center, got one");
    const [u, v] = dimension === 2 ? UNIT_VECTORS : directionsOf(normal ?? [0, 0, 1]);
    const r = check.nonNegative(radius, "radius");
    const scaled = (direction: readonly number[]) => direction.map((x) => x * r);
    return arcBetween(center, dimension, scaled(u), scaled(v), start, end) as NurbsCurve<D>;
  }

  /**
   * A circle, counter-clockwise (x right, y up) from (x + r, y), with nine control points over the domain [0, 1].
   *
   * @param center in the plane
   * @param radius at least 0; with 0 the curve is a point
   * @throws {RangeError} for a negative radius
   */
  static circle(center: PointLike, radius: number): NurbsCurve<2> {
    const r = check.nonNegative(radius, "radius");
    return arcBetween(center, 2, [r, 0], [0, r], 0, 2 * Math.PI) as NurbsCurve<2>;
  }

  /**
   * An ellipse with two radii, as `circle`.
   *
   * @param center in the plane
   * @param radiusX at least 0
   * @param radiusY at least 0
   * @param rotation the angle of the first radius, in radians, by default 0
   * @throws {RangeError} for a negative radius
   */
  static ellipse(center: PointLike, radiusX: number, radiusY: number, rotation = 0): NurbsCurve<2> {
    const [a, b] = [check.nonNegative(radiusX, "radiusX"), check.nonNegative(radiusY, "radiusY")];
    const [cos, sin] = directionOfDegrees((check.finite(rotation, "rotation") * 180) / Math.PI);
    return arcBetween(center, 2, [cos * a, sin * a], [-sin * b, cos * b], 0, 2 * Math.PI) as NurbsCurve<2>;
  }

  /**
   * The B-spline curve of a degree through points, over the domain [0, 1], with the weights 1.
   *
   * The parameters of the points grow with the square roots of the distances between them, and each inner knot is the mean of p
   * parameters. Equal neighbours count as one point. It takes p² steps for each point.
   *
   * @param points at least degree + 1 of them, of which neighbours differ
   * @param options `degree`: 1 to 64, by default 3; `dimension`: 2 or 3, how a flat array is read; 2 by default
   * @throws {RangeError} for too few points
   */
  static interpolate<D extends 2 | 3 = 2 | 3>(
    points: PointArrays<D> | PointsLike,
    options?: { degree?: number; dimension?: D },
  ): NurbsCurve<D> {
    requireList(points);
    const { degree = 3, dimension: requested } = check.options(options, ["degree", "dimension"]);
    check.whole(degree, "degree", 1, 64);
    const { flat, dimension } = flatten(points, requested, 2);
    curvesModule.write(flat);
    const end = curvesModule.functions.nurbs_interpolate(dimension, flat.length / dimension, degree);
    return readNurbs(end, dimension) as NurbsCurve<D>;
  }

  /**
   * A curve, a rational curve, a spline or a path of one subpath as a NURBS curve; the weights of all but rational curves are 1.
   *
   * Segment k has t from k to k + 1; segments of lower degrees are elevated to the highest one. The curve is open, also if the
   * spline is closed.
   *
   * @param shape of any entry point
   * @throws {RangeError} for a path that has not exactly one subpath
   */
  static from<D extends 2 | 3 = 2 | 3>(
    shape: CoreCurve<D> | RationalCurve<D> | NurbsCurve<D> | CoreSpline<D> | CorePath,
  ): NurbsCurve<D> {
    return nurbsOf(pathData(shape) ?? nurbsDataOf(shape, "shape", EXPECTED)) as NurbsCurve<D>;
  }

  /**
   * The curve that `toJSON` described.
   *
   * @param json what `toJSON` returned
   */
  static fromJSON(json: NurbsCurveJSON): NurbsCurve {
    requireJSON(json, "degree, points, weights, knots and closed", ({ points }) => points !== undefined);
    return nurbsFrom({ ...json });
  }
}

/** Squared distances are compared after two roundings each; a box may therefore seem this much too far away. */
const BOX_ROUNDING = 1 - 16 * Number.EPSILON;

/** The squared distance of a point from the box of the first `count` points of a list. */
function squareFromBox(flat: Float64Array, point: Float64Array, count: number): number {
  const d = point.length;
  let square = 0;
  for (let axis = 0; axis < d; axis++) {
    let min = flat[axis];
    let max = min;
    for (let at = axis + d; at < count * d; at += d) {
      min = Math.min(min, flat[at]);
      max = Math.max(max, flat[at]);
    }
    const beyond = Math.max(min - point[axis], point[axis] - max, 0);
    square += beyond * beyond;
  }
  return square;
}

const EXPECTED = "a Curve, a RationalCurve, a NurbsCurve, a Spline or a Path";

/** The directions of the axes of the plane. */
const UNIT_VECTORS = [
  [1, 0],
  [0, 1],
] as const;

/** Outside of the class, so that it does not refer to itself; see `markClassNames` in xtask/bundle.js. */
function show() {
  isShown = showInNode(NurbsCurve.prototype, "NurbsCurve", (value) => value.toJSON());
}

// Outside of the class, see ../curve/core-curve.js.
const nurbsFrom = (options: NurbsOptions): NurbsCurve => new NurbsCurve(options);

/**
 * A curve from checked data.
 *
 * @internal
 */
export const nurbsOf = (data: NurbsData): NurbsCurve => fromChecked(NurbsCurve, data);

/** Reads a curve from the arena. */
function readNurbs(end: number, dimension: 2 | 3, from = 0): NurbsCurve {
  return nurbsOf(readNurbsData(end, dimension, from));
}

function dataOf(options: NurbsOptions): NurbsData {
  const names = ["degree", "points", "weights", "knots", "closed", "dimension"] as const;
  const { degree, points, weights, knots, closed, dimension: requested } = check.options(options, names);
  check.whole(degree, "degree", 1, 64);
  const { flat, dimension } = flatten(points as PointsLike, requested, 2);
  const count = flat.length / dimension;
  return {
    degree: degree as number,
    flat,
    dimension,
    weights: weights === undefined ? new Float64Array(count).fill(1) : checkedWeights(weights, count),
    knots: check.numbers(knots, "knots"),
    closed: check.optionalBoolean(closed, "closed"),
  };
}

/** Two unit vectors that are perpendicular to a normal and to each other. */
function directionsOf(normal: PointLike): number[][] {
  const n = new Float64Array(3);
  writePoint(n, 0, normal, 3, "normal");
  const largest = Math.max(...n.map(Math.abs));
  if (largest === 0) throw new RangeError("normal: expected a vector of a length above 0, got 0, 0, 0");
  const [x, y, z] = unit([...n].map((k) => k / largest));
  // The part of an axis that is perpendicular to the normal.
  const u = y === 0 && z === 0 ? [0, 1, 0] : unit([y * y + z * z, -x * y, -x * z]);
  return [u, [y * u[2] - z * u[1], z * u[0] - x * u[2], x * u[1] - y * u[0]]];
}

function unit(vector: number[]): number[] {
  const length = Math.hypot(...vector);
  return vector.map((x) => x / length);
}

/** The arc center + cos(θ) u + sin(θ) v. */
function arcBetween(
  center: PointLike,
  dimension: 2 | 3,
  u: number[],
  v: number[],
  start: number,
  end: number,
): NurbsCurve {
  const args = new Float64Array(3 * dimension);
  writePoint(args, 0, center, dimension, "center");
  args.set(u, dimension);
  args.set(v, 2 * dimension);
  check.finite(start, "start");
  check.finite(end, "end");
  curvesModule.write(args);
  return readNurbs(curvesModule.functions.nurbs_arc(dimension, start, end), dimension);
}

/** The curve of a path of one subpath; undefined for any other value. */
function pathData(shape: unknown): NurbsData | undefined {
  const packed = packedPath(shape);
  if (!packed) return undefined;
  if (packed[0] !== 1) throw new RangeError(`shape: expected a path of one subpath, got one of ${packed[0]}`);
  return nurbsOfSpline(subpathsOf(packed)[0]);
}
