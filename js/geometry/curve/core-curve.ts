import { checkedData, fromChecked } from "../checked.js";
import { curvesModule } from "../../wasm/curves-module.js";
import * as check from "../check.js";
import * as queries from "../curve-queries.js";
import { curveLength, curveTimeAtLength, pointAndDirections } from "../arc-length.js";
import { curveData, requireJSON } from "../brand.js";
import { showInNode } from "../inspected.js";
import { partsAt } from "../parts.js";
import { flatten, nested, pointAt, pointList, samePoints, requireList, boxAt } from "../points.js";
import { affine } from "../affine.js";
import { readTree } from "../subdivision.js";
import { svgOf, traceOn } from "../../io/svg-write.js";
import { packedSpline } from "../../wasm/packed-path.js";
import type { ControlPoints } from "../brand.js";
import type { SplineData } from "../brand.js";
import type { PointAtLength } from "../arc-length.js";
import type { PointLike, PointsLike, TransformLike, Complete } from "../check.js";
import type { Nearest } from "../curve-queries.js";
import type { Point, PointArrays, Bounds } from "../points.js";
import type { Subdivision } from "../subdivision.js";
import type { SvgOptions } from "../../io/svg-write.js";

/** Whether Node knows how to show the instances. */
let isShown = false;

/** What `Curve.toJSON` returns; `Curve.fromJSON` also reads other forms of points. */
export type CurveJSON = { points: PointsLike; dimension?: 2 | 3 };

/**
 * One Bézier curve of degree 1 to 64, in the plane or in space.
 *
 * B(t) = Σ C(n, i) (1 − t)ⁿ⁻ⁱ tⁱ Pᵢ for t from 0 to 1; other values extrapolate. The end points are returned exactly.
 * Curves are immutable: every change returns a new one. They need not be freed.
 *
 *     const curve = new Curve([[0, 0], [1, 2], [2, 0]]);
 *     curve.eval(0.5); // { x: 1, y: 1 }
 *
 * In TypeScript, `Curve<2>` and `Curve<3>` have points `{x, y}` and `{x, y, z}`. The dimension is inferred from points
 * that are arrays, and from the option `dimension`.

 * This is `Curve` of casteljau/core. That of `casteljau` extends it; where a function takes a curve, it takes the curves of
 * every entry point.
 */
export class CoreCurve<D extends 2 | 3 = 2 | 3> {
  #flat: Float64Array;
  #dimension: D;

  /**
   * The curve of the given control points.
   *
   * @param points the control points P₀ … Pₙ, 2 to 65 of them; a flat array is 2D unless `dimension` is 3
   * @param options `dimension`: 2 or 3, how a flat array is read; 2 by default
   * @throws {RangeError} for a wrong count, a NaN or an infinity
   * @throws {TypeError} for a value that is not a point
   */
  constructor(points: PointArrays<D> | PointsLike, options?: { dimension?: D }) {
    if (!isShown) show();
    const { flat, dimension } = checkedData<ControlPoints>(points) ?? checkedPoints(points, options);
    this.#flat = flat;
    this.#dimension = dimension as D;
  }

  /** The degree n: one less than the number of control points. */
  get degree() {
    return this.#flat.length / this.#dimension - 1;
  }

  /** 2 in the plane, 3 in space. */
  get dimension() {
    return this.#dimension;
  }

  /**
   * @returns a copy of the coordinates of P₀ … Pₙ
   */
  controlPoints(): Float64Array {
    return this.#flat.slice();
  }

  /** The control points P₀ … Pₙ as objects. */
  points(): Point<D>[] {
    return pointList(this.#flat, this.#dimension);
  }

  /**
   * Whether both have the same degree and each control point lies within a distance of its counterpart.
   *
   * @param other the value to compare with
   * @param tolerance by default 0: equal coordinates
   */
  equals(other: CoreCurve, tolerance = 0): boolean {
    const { flat, dimension } = curveData(other, "other");
    return this.#dimension === dimension && samePoints(this.#flat, flat, dimension, tolerance);
  }

  /**
   * The curve as an object for JSON, from which `Curve.fromJSON` makes an equal curve; it has `dimension: 3` for a curve in space.
   */
  toJSON(): { points: number[][] } {
    return { points: nested(this.#flat, this.#dimension) };
  }

  /**
   * See `brand.js`.
   *
   * @internal
   */
  get casteljauType(): "curve" {
    return "curve";
  }

  /**
   * The curve as a spline of one segment.
   *
   * @internal
   */
  casteljauData(): SplineData {
    return { flat: this.#flat, dimension: this.#dimension, degrees: [this.degree], closed: false };
  }

  /**
   * The coordinates of the control points, not copied.
   *
   * @internal
   */
  get _flat() {
    return this.#flat;
  }

  /**
   * A curve of the same class and dimension.
   *
   * @internal
   */
  _curveOf(flat: Float64Array): this {
    return coreCurveOf({ flat, dimension: this.dimension }) as this;
  }

  /**
   * @internal
   * Writes the control points, and then further numbers, to the arena.
   * @returns the number of points
   */
  _write(further?: ArrayLike<number>): number {
    const view = curvesModule.write(this.#flat, further?.length);
    if (further) view.set(further, this.#flat.length);
    return this.#flat.length / this.#dimension;
  }

  /**
   * @internal
   * Reads the control points of a curve from the arena.
   */
  _read(length: number): this {
    return this._curveOf(curvesModule.read(0, length));
  }

  /**
   * Reads a point from the arena.
   *
   * @internal
   */
  _readPoint(): Point<D> {
    return pointAt(curvesModule.read(0, 3), 0, this.#dimension);
  }

  /**
   * Throws a TypeError in 3D.
   *
   * @internal
   */
  _require2D(method: string) {
    check.require2D(method, "curve", this.#dimension);
  }

  /**
   * The point at t.
   *
   * @param t the parameter, from 0 to 1; others extrapolate
   */
  eval(t: number): Point<D> {
    if (typeof t !== "number" || t - t !== 0) check.finite(t, "t");
    const flat = this._flat;
    if (flat.length === 4 * this.dimension) return cubicAt(flat, t) as Point<D>;
    curvesModule.functions.curve_eval(this.dimension, this._write(), t);
    return this._readPoint();
  }

  /**
   * `segments` + 1 points at t = i / segments.
   *
   * @param segments how many parts, at least 1
   * @param options `into`: at least (segments + 1) · dimension numbers long
   */
  sample(segments: number, options?: { into?: Float64Array }): Float64Array {
    check.segmentCount(segments);
    const { into } = check.options(options, ["into"]);
    const length = (segments + 1) * this.dimension;
    if (into !== undefined) check.resultArray(into, length);
    const count = curvesModule.functions.curve_sample(this.dimension, this._write(), segments);
    if (into !== undefined) return curvesModule.readInto(into, count);
    return curvesModule.readLarge(count);
  }

  /**
   * The points at the given parameters.
   *
   * @param ts the parameters
   * @param options `into`: at least ts.length · dimension numbers long
   */
  evalAt(ts: ArrayLike<number>, options?: { into?: Float64Array }): Float64Array {
    const parameters = check.numbers(ts, "ts");
    const length = parameters.length * this.dimension;
    const into = check.resultArray(check.options(options, ["into"]).into, length);
    const count = this._write(parameters);
    curvesModule.functions.curve_eval_at(this.dimension, count, parameters.length);
    return curvesModule.readInto(into, length);
  }

  /** The derivative as a curve of degree n − 1; the derivative of a line is a line whose two points are equal. */
  derivative(): this {
    return this._read(curvesModule.functions.curve_derivative(this.dimension, this._write()));
  }

  /**
   * The k-th derivative at t; zero if k is greater than the degree.
   *
   * @param t the parameter, from 0 to 1; others extrapolate
   * @param k the order of the derivative, by default 1
   */
  derivativeAt(t: number, k = 1): Point<D> {
    check.finite(t, "t");
    check.whole(k, "k", 0, 0xffffffff);
    curvesModule.functions.curve_derivative_at(this.dimension, this._write(), t, k);
    return this._readPoint();
  }

  /**
   * The unit tangent at t. Where the derivative vanishes (handles of length 0, cusps) it is the limit; if all control
   * points are equal, it is zero.
   *
   * @param t the parameter, from 0 to 1; others extrapolate
   */
  tangent(t: number): Point<D> {
    check.finite(t, "t");
    curvesModule.functions.curve_tangent(this.dimension, this._write(), t);
    return this._readPoint();
  }

  /**
   * The unit normal at t: in 2D the tangent turned by +90°, (x, y) → (−y, x); in 3D the principal normal, which is zero
   * where the curve is straight.
   *
   * @param t the parameter, from 0 to 1; others extrapolate
   */
  normal(t: number): Point<D> {
    check.finite(t, "t");
    curvesModule.functions.curve_normal(this.dimension, this._write(), t);
    return this._readPoint();
  }

  /**
   * The curvature at t: in 2D positive when turning counter-clockwise (x right, y up), in 3D never negative. Infinite
   * at a cusp.
   *
   * @param t the parameter, from 0 to 1; others extrapolate
   */
  curvature(t: number): number {
    check.finite(t, "t");
    return curvesModule.functions.curve_curvature(this.dimension, this._write(), t);
  }

  /**
   * All levels of de Casteljau's algorithm at t: the first level is the control points, the last is the point of the
   * curve.
   *
   * @param t the parameter, from 0 to 1; others extrapolate
   */
  deCasteljau(t: number): Float64Array[] {
    check.finite(t, "t");
    curvesModule.functions.curve_de_casteljau(this.dimension, this._write(), t);
    const levels: Float64Array[] = [];
    for (let length = this._flat.length, from = 0; length > 0; length -= this.dimension) {
      levels.push(curvesModule.read(from, from + length));
      from += length;
    }
    return levels;
  }

  /**
   * The values of the n + 1 Bernstein polynomials of a degree at t; for t in [0, 1] their sum is 1 within one ulp.
   *
   * @param degree 0 to 64
   * @param t the parameter, mostly from 0 to 1
   */
  static bernstein(degree: number, t: number): Float64Array {
    check.whole(degree, "degree", 0, 64);
    return curvesModule.read(0, curvesModule.functions.bernstein_weights(degree, check.finite(t, "t")));
  }

  /**
   * Splits the curve at t into two, or at several parameters into one part more.
   *
   * With a list, in any order: the parts from 0 to the smallest parameter, between neighbours, and from the largest to 1,
   * see `subsegment`. Equal parameters, 0 and 1 give parts that are points.
   *
   *     new Curve([0, 0, 4, 0]).split([0.75, 0.25]).length; // 3: to 1, from 1 to 3, and from 3 on the x-axis
   *
   * @param t the parameter, from 0 to 1; others extrapolate
   */
  split(t: number): [this, this];
  /** @param ts any number of parameters */
  split(ts: ArrayLike<number>): this[];
  split(t: number | ArrayLike<number>): this[] {
    if (check.isList(t)) return partsAt(this, t, 1);
    if (typeof t !== "number" || t - t !== 0) check.finite(t, "t");
    curvesModule.functions.curve_split(this.dimension, this._write(), t);
    const n = this._flat.length;
    return [this._curveOf(curvesModule.read(0, n)), this._curveOf(curvesModule.read(n, 2 * n))];
  }

  /** Splits the curve at t = ½ into two. */
  halve(): [this, this] {
    return this.split(0.5);
  }

  /**
   * The part from t0 to t1, reversed if t0 > t1.
   *
   * @param t0 the parameter of the start
   * @param t1 the parameter of the end
   */
  subsegment(t0: number, t1: number): this {
    check.finite(t0, "t0");
    check.finite(t1, "t1");
    curvesModule.functions.curve_subsegment(this.dimension, this._write(), t0, t1);
    return this._read(this._flat.length);
  }

  /** The same curve with the opposite direction. */
  reverse(): this {
    const d = this.dimension;
    const flat = new Float64Array(this._flat.length);
    for (let i = 0; i < flat.length; i += d) flat.set(this._flat.subarray(i, i + d), flat.length - d - i);
    return this._curveOf(flat);
  }

  /**
   * The same curve with a higher degree.
   *
   * @param times by how much the degree is raised, by default 1
   * @throws {RangeError} for a degree above 64
   */
  elevate(times = 1): this {
    check.whole(times, "times", 0, 64);
    let curve: this = this;
    for (let k = 0; k < times; k++)
      curve = curve._read(curvesModule.functions.curve_elevate(this.dimension, curve._write()));
    return curve;
  }

  /**
   * The curve transformed by an affine map.
   *
   * @param matrix a matrix, or a text such as "translate(50 50) rotate(30)"
   * @throws {RangeError} for an image with a coordinate beyond 2^500
   */
  transform<const M extends TransformLike>(matrix: M & Complete<M>): this {
    return this._read(curvesModule.functions.points_transform(this.dimension, this._write(affine(matrix))));
  }

  /**
   * A polyline whose distance from the curve is nowhere greater than `tolerance`.
   *
   * @param tolerance in the unit of the points
   * @returns the vertices and their parameters
   * @throws {RangeError} for a tolerance not above 0 or below 4 ulps of the largest coordinate
   */
  flatten(tolerance: number): { points: Float64Array; ts: Float64Array } {
    check.positive(tolerance, "tolerance");
    const vertices = curvesModule.functions.curve_flatten(this.dimension, this._write(), tolerance);
    return curvesModule.readPolyline(vertices, this.dimension);
  }

  /**
   * The tree of recursive halving until D1 − D2 < tolerance, where D1 is the length of the control polygon and D2 the
   * length of the chord. For teaching: D1 − D2 is not a bound on the distance, but `deviationBound` is.
   *
   * @param tolerance the largest distance, in the unit of the points
   */
  subdivide(tolerance: number): Subdivision<this> {
    check.positive(tolerance, "tolerance");
    const used = curvesModule.functions.curve_subdivide(this.dimension, this._write(), tolerance);
    return readTree(curvesModule.read(0, used), this._flat.length, (flat) => this._curveOf(flat));
  }

  /** The smallest box that contains the curve. */
  bounds(): Bounds<D> {
    return this._box(true);
  }

  /** The box of the control points, which contains the curve. */
  controlBounds(): Bounds<D> {
    return this._box(false);
  }

  /** The corners of the convex hull of the control points, counter-clockwise (x right, y up); 2D only. */
  hull(): Float64Array {
    this._require2D("hull");
    return curvesModule.read(0, curvesModule.functions.curve_hull(this._write()));
  }

  /**
   * Draws the curve on a canvas context or a Path2D: `moveTo` its start, then the curve. 2D only.
   *
   * @param target a canvas context or a Path2D
   * @param options `tolerance`: for degrees above 3, which are drawn as cubics
   */
  trace(
    target: CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D | Path2D,
    options?: { tolerance?: number },
  ) {
    this._require2D("trace");
    traceOn(packedSpline(this._flat, [this.degree], false), target, options);
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
  length(tolerance?: number): number {
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
  pointAtLength(s: number): PointAtLength<D> {
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
    return curvesModule.readLarge(
      curvesModule.functions.curve_equidistant_times(this.dimension, this._write(), segments),
    );
  }

  /**
   * The signed area ½ ∫ (x dy − y dx) swept by the line from the origin to the point of the curve, positive while that
   * line turns counter-clockwise (x right, y up). The areas of the segments of an outline add up to its area. 2D only.
   */
  area(): number {
    this._require2D("area");
    return curvesModule.functions.curve_area(this._write());
  }

  /**
   * The point of the curve that is nearest to p: the global minimum of the distance for t in [0, 1], found by isolating
   * the roots of (B(t) − p)·B′(t). Of several nearest points, it is the one with the smallest t.
   *
   * At most 256 pieces are examined up to degree 3, and 64 + 16 n at a higher degree n. Only distances that are
   * constant but for rounding need more.
   *
   * @param p the point, in the unit of the points
   */
  nearest(p: PointLike): Nearest<D> {
    const found = queries.nearest(this._flat, this.dimension, p);
    return found;
  }

  /** The curve as SVG path data without arcs, see `Path.toSVG`; 2D only. */
  toSVG(options?: SvgOptions): string {
    this._require2D("toSVG");
    return svgOf(packedSpline(this._flat, [this.degree], false), options);
  }

  /** The curve as `toSVG` writes it, or in space as JSON: `String(curve)` and `${curve}` give this text. */
  toString(): string {
    return this.dimension === 2 ? this.toSVG() : JSON.stringify(this);
  }

  /**
   * The box of the curve, or of its control points.
   *
   * @internal
   */
  _box(exact: boolean): Bounds<D> {
    curvesModule.functions.curve_bounds(this.dimension, this._write(), exact);
    return boxAt(curvesModule.read(0, 6), this.dimension);
  }

  /**
   * The curve that `toJSON` described.
   *
   * @param json what `toJSON` returned
   */
  static fromJSON(json: CurveJSON): CoreCurve {
    return coreCurveOf(curvePointsOf(json));
  }
}

/** Outside of the class, so that it does not refer to itself; see `markClassNames` in xtask/bundle.js. */
function show() {
  isShown = showInNode(CoreCurve.prototype, "Curve", (value) => value.toJSON());
}

// Code that uses the class by its name is outside of the class: bundlers rename a class that refers to itself (to
// _Curve).

/**
 * A curve whose points are checked already.
 *
 * @internal
 */
export function coreCurveOf(points: ControlPoints): CoreCurve {
  return fromChecked(CoreCurve, points);
}

function checkedPoints(points: PointsLike, options?: { dimension?: 2 | 3 }): ControlPoints {
  requireList(points);
  const { flat, dimension } = flatten(points, check.options(options, ["dimension"]).dimension, 2);
  const count = flat.length / dimension;
  if (count >= 2 && count <= 65) return { flat, dimension };
  throw new RangeError(`points: expected 2 to 65 control points (degree 1 to 64), got ${count}`);
}

/**
 * The control points of a curve in JSON.
 *
 * @internal
 */
export function curvePointsOf(json: CurveJSON): ControlPoints {
  requireJSON(json, "points", ({ points }) => points !== undefined);
  return checkedPoints(json.points, { dimension: json.dimension });
}

/**
 * The point of a cubic, the most common kind of curve. Passing its coordinates as arguments takes a quarter of the time
 * of passing them through the arena.
 */
function cubicAt(p: Float64Array, t: number): Point {
  const at = curvesModule.cubicEval;
  if (p.length === 8) return { x: at(p[0], p[2], p[4], p[6], t), y: at(p[1], p[3], p[5], p[7], t) };
  return { x: at(p[0], p[3], p[6], p[9], t), y: at(p[1], p[4], p[7], p[10], t), z: at(p[2], p[5], p[8], p[11], t) };
}
