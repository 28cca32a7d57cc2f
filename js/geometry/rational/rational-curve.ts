import { checkedData, fromChecked } from "../checked.js";
import { curvesModule } from "../../wasm/curves-module.js";
import * as check from "../check.js";
import { packedSpline } from "../../wasm/packed-path.js";
import { svgOfRational } from "../../io/svg-conic.js";
import { checkTolerance, traceOn } from "../../io/svg-write.js";
import { affine } from "../affine.js";
import { pointAndDirections } from "../arc-length.js";
import { curveData, rationalData, requireJSON, typeOf } from "../brand.js";
import { coreCurveOf } from "../curve/core-curve.js";
import { readNearest } from "../curve-queries.js";
import { showInNode } from "../inspected.js";
import { partsAt } from "../parts.js";
import {
  boxAt,
  dimensionOf,
  flatten,
  nested,
  pointAt,
  pointList,
  requireList,
  samePoints,
  writePoint,
} from "../points.js";
import { coreSplineOf, readSplineData } from "../spline/core-spline.js";
import { intersectNurbs, intersectSplineWithNurbs, selfIntersectNurbs } from "./intersections.js";
import { nurbsOfRational } from "./nurbs-data.js";
import { projective } from "./projective.js";
import type { ControlPoints } from "../brand.js";
import type { PointAtLength } from "../arc-length.js";
import type { RationalData, SplineData } from "../brand.js";
import type { PointLike, PointsLike, TransformLike } from "../check.js";
import type { CoreCurve } from "../curve/core-curve.js";
import type { Extrema, Nearest } from "../curve-queries.js";
import type { Intersection, SelfIntersection } from "../intersections.js";
import type { CorePath } from "../path/core-path.js";
import type { PathTime } from "../path/path-queries.js";
import type { Bounds, Point, PointArrays } from "../points.js";
import type { CoreSpline } from "../spline/core-spline.js";
import type { SvgOptions } from "../../io/svg-write.js";
import type { NurbsCurve } from "./nurbs-curve.js";

/** Whether Node knows how to show the instances. */
let isShown = false;

/** The largest weight, and the inverse of the smallest. */
const MAX_WEIGHT = check.MAX_COORDINATE;

/** What `RationalCurve.toJSON` returns; `RationalCurve.fromJSON` also reads other forms of points. */
export type RationalCurveJSON = { points: PointsLike; weights: ArrayLike<number>; dimension?: 2 | 3 };

/**
 * One rational Bézier curve of degree 1 to 64, in the plane or in space: control points with weights.
 *
 * B(t) = Σ wᵢ C(n, i) (1 − t)ⁿ⁻ⁱ tⁱ Pᵢ / Σ wᵢ C(n, i) (1 − t)ⁿ⁻ⁱ tⁱ for t from 0 to 1. A larger weight pulls the curve towards its
 * point; equal weights give the curve without weights, and a common factor of all weights changes nothing. The end points are
 * returned exactly. Curves are immutable: every change returns a new one. They need not be freed.
 *
 * Arcs of circles and ellipses are rational curves of degree 2; a `Curve` can only approximate them.
 *
 *     const quarter = new RationalCurve([[1, 0], [1, 1], [0, 1]], [1, Math.SQRT1_2, 1]);
 *     quarter.length(); // 1.5707963267948966
 *
 * Other values of t extrapolate as long as the denominator is above 0. In TypeScript, `RationalCurve<2>` and
 * `RationalCurve<3>` have points `{x, y}` and `{x, y, z}`, see `Curve`.
 */
export class RationalCurve<D extends 2 | 3 = 2 | 3> {
  #flat: Float64Array;
  #weights: Float64Array;
  #dimension: D;
  /** See `homogeneous`. */
  #polynomials: Homogeneous | undefined;
  /** See `homogeneousPoints`. */
  #cubic: Float64Array | undefined;

  /**
   * The curve of the given control points and weights.
   *
   * @param points the control points P₀ … Pₙ, 2 to 65 of them; a flat array is 2D unless `dimension` is 3
   * @param weights the weights w₀ … wₙ, one for each point, from 2^-500 to 2^500
   * @param options `dimension`: 2 or 3, how a flat array is read; 2 by default
   * @throws {RangeError} for a wrong count, a NaN or an infinity, and for a weight that is not above 0
   * @throws {TypeError} for a value that is not a point
   */
  constructor(points: PointArrays<D> | PointsLike, weights: ArrayLike<number>, options?: { dimension?: D }) {
    if (!isShown) show();
    const checked = checkedData<RationalData>(points);
    const { flat, dimension } = checked ?? checkedPoints(points as PointsLike, options);
    this.#flat = flat;
    this.#dimension = dimension as D;
    this.#weights = checked?.weights ?? checkedWeights(weights, flat.length / dimension);
  }

  /** The degree n: one less than the number of control points. */
  get degree() {
    return this.#weights.length - 1;
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
   * @returns a copy of the weights w₀ … wₙ
   */
  weights(): Float64Array {
    return this.#weights.slice();
  }

  /**
   * Whether both have the same degree, each control point lies within a distance of its counterpart, and the weights are
   * equal up to a common factor, each within `tolerance` times the largest weight.
   *
   * @param other the value to compare with
   * @param tolerance by default 0: equal coordinates and weights
   */
  equals(other: RationalCurve, tolerance = 0): boolean {
    const { flat, dimension, weights } = rationalData(other, "other");
    if (this.#dimension !== dimension || !samePoints(this.#flat, flat, dimension, tolerance)) return false;
    const factor = this.#weights[0] / weights[0];
    const max = tolerance * Math.max(...this.#weights);
    return this.#weights.every((w, i) => Math.abs(w - weights[i] * factor) <= max);
  }

  /**
   * The curve as an object for JSON, from which `RationalCurve.fromJSON` makes an equal curve; it has `dimension: 3` for a curve
   * in space.
   */
  toJSON(): { points: number[][]; weights: number[] } {
    return { points: nested(this.#flat, this.#dimension), weights: [...this.#weights] };
  }

  /**
   * See `brand.js`.
   *
   * @internal
   */
  get casteljauType(): "rationalcurve" {
    return "rationalcurve";
  }

  /**
   * The data, see `Branded`.
   *
   * @internal
   */
  casteljauData(): RationalData {
    return { flat: this.#flat, dimension: this.#dimension, weights: this.#weights };
  }

  /**
   * See `isRational` in ../intersections.ts.
   *
   * @internal
   */
  casteljauIntersections(spline: SplineData): Intersection[] {
    return intersectSplineWithNurbs(spline, nurbsOfRational(this.casteljauData()));
  }

  /**
   * @internal
   * Writes the control points, the weights, and then further numbers, to the arena.
   * @returns the number of points
   */
  _write(further: ArrayLike<number> = []): number {
    const [flat, weights] = [this.#flat, this.#weights];
    const view = curvesModule.write(flat, weights.length + further.length);
    for (let i = 0; i < weights.length; i++) view[flat.length + i] = weights[i];
    const end = flat.length + weights.length;
    for (let i = 0; i < further.length; i++) view[end + i] = further[i];
    return weights.length;
  }

  /**
   * @internal
   * Reads the curve at an index of the arena, of the same dimension.
   * @param end the index after it, negative if the core reported an error
   */
  _read(end: number, from = 0): RationalCurve<D> {
    const numbers = curvesModule.read(from, end);
    const count = numbers.length / (this.#dimension + 1);
    const points = { flat: numbers.slice(0, -count), dimension: this.#dimension };
    return rationalCurveOf(points, numbers.slice(-count)) as RationalCurve<D>;
  }

  /**
   * Reads a point from the arena.
   *
   * @internal
   */
  _readPoint(): Point<D> {
    return pointAt(curvesModule.arena(3), 0, this.#dimension);
  }

  /**
   * Throws a TypeError in 3D.
   *
   * @internal
   */
  _require2D(method: string) {
    check.require2D(method, "curve", this.#dimension);
  }

  get #homogeneous() {
    this.#polynomials ??= homogeneous(this.#flat, this.#weights, this.#dimension);
    return this.#polynomials;
  }

  /**
   * The denominator at t, divided by a positive number.
   *
   * @internal
   */
  _denominatorAt(t: number): number {
    const { numerator, denominator } = this.#homogeneous;
    return denominator ? denominator.eval(t).x : numerator.eval(t).z;
  }

  #requireParameter(t: number, name = "t") {
    if (typeof t !== "number" || t - t !== 0) check.finite(t, name);
    if (!(t >= 0 && t <= 1) && !(this._denominatorAt(t) > 0)) throw notDefinedAt(t, name);
  }

  /**
   * The point at t.
   *
   * @param t the parameter, from 0 to 1; others extrapolate
   * @throws {RangeError} outside of [0, 1] where the denominator Σ wᵢ C(n, i) (1 − t)ⁿ⁻ⁱ tⁱ is not above 0
   */
  eval(t: number): Point<D> {
    if (typeof t !== "number" || t - t !== 0) check.finite(t, "t");
    if (t === 0) return pointAt(this.#flat, 0, this.#dimension);
    if (t === 1) return pointAt(this.#flat, this.#flat.length - this.#dimension, this.#dimension);
    if (this.#weights.length <= 4) return this.#cubicAt(t);
    const { numerator, denominator } = this.#homogeneous;
    const { x, y, z } = numerator.eval(t);
    const w = denominator ? denominator.eval(t).x : z;
    if (!(w > 0)) throw notDefinedAt(t, "t");
    return (denominator ? { x: x / w, y: y / w, z: z / w } : { x: x / w, y: y / w }) as Point<D>;
  }

  /** The point at t of a curve of degree 1 to 3: `RationalCurve::eval` in JavaScript, which takes less time than calls of the core. */
  #cubicAt(t: number): Point<D> {
    this.#cubic ??= homogeneousPoints(this.#flat, this.#weights, this.#dimension);
    const h = this.#cubic;
    const n = this.#weights.length - 1;
    const s = 1 - t;
    const tt = t * t;
    const ss = s * s;
    const a = n === 3 ? ss * s : n === 2 ? ss : s;
    const b = n === 3 ? 3 * ss * t : n === 2 ? 2 * s * t : t;
    const c = n === 3 ? 3 * s * tt : n === 2 ? tt : 0;
    const d = n === 3 ? tt * t : 0;
    const w = h[0] * a + h[1] * b + h[2] * c + h[3] * d;
    if (!(w > 0)) throw notDefinedAt(t, "t");
    const x = (h[4] * a + h[5] * b + h[6] * c + h[7] * d) / w;
    const y = (h[8] * a + h[9] * b + h[10] * c + h[11] * d) / w;
    if (this.#dimension === 2) return { x, y } as Point<D>;
    return { x, y, z: (h[12] * a + h[13] * b + h[14] * c + h[15] * d) / w } as Point<D>;
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
    if (into !== undefined) check.resultArray(into, (segments + 1) * this.#dimension);
    const { numerator, denominator } = this.#homogeneous;
    const points = this.#divided(numerator.sample(segments), denominator?.sample(segments), into);
    points.set(this.#flat.subarray(0, this.#dimension));
    points.set(this.#flat.subarray(-this.#dimension), segments * this.#dimension);
    return points;
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
    const d = this.#dimension;
    const into = check.resultArray(check.options(options, ["into"]).into, parameters.length * d);
    parameters.forEach((t, i) => this.#requireParameter(t, `ts[${i}]`));
    const { numerator, denominator } = this.#homogeneous;
    const points = this.#divided(numerator.evalAt(parameters), denominator?.evalAt(parameters), into);
    parameters.forEach((t, i) => {
      if (t === 0) points.set(this.#flat.subarray(0, d), i * d);
      if (t === 1) points.set(this.#flat.subarray(-d), i * d);
    });
    return points;
  }

  /** The quotients of the values of both polynomials. */
  #divided(numerators: Float64Array, denominators: Float64Array | undefined, into?: Float64Array): Float64Array {
    const [d, count] = [this.#dimension, numerators.length / 3];
    const points = into ?? new Float64Array(count * d);
    for (let i = 0; i < count; i++) {
      const w = denominators ? denominators[2 * i] : numerators[3 * i + 2];
      for (let k = 0; k < d; k++) points[i * d + k] = numerators[3 * i + k] / w;
    }
    return points;
  }

  /**
   * The k-th derivative at t.
   *
   * @param t the parameter, from 0 to 1; others extrapolate
   * @param k the order of the derivative, 0 to 64, by default 1
   * @throws {RangeError} as `eval`
   */
  derivativeAt(t: number, k = 1): Point<D> {
    this.#requireParameter(t);
    check.whole(k, "k", 0, 64);
    return this._derivativeAt(t, k);
  }

  /**
   * The derivative of order k at t, which is checked.
   *
   * @internal
   */
  _derivativeAt(t: number, k: number): Point<D> {
    const derivative = k === 1 && this.#weights.length === 4 ? this.#derivativeOfCubic(t) : undefined;
    if (derivative) return derivative;
    curvesModule.count(curvesModule.functions.rational_derivative_at(this.#dimension, this._write(), t, k));
    return this._readPoint();
  }

  /**
   * The derivative of a cubic; undefined if it is not small enough for the core to return it unchanged.
   *
   * With the origin at B(t), it is the derivative of wB divided by w.
   */
  #derivativeOfCubic(t: number): Point<D> | undefined {
    const [d, p, weights] = [this.#dimension as number, this.#flat, this.#weights];
    const origin: { x: number; y: number; z?: number } = this.eval(t);
    const s = 1 - t;
    const [a, b, c] = [s * s, 2 * s * t, t * t];
    const scale = 1 / (weights[0] + weights[1] + weights[2] + weights[3]);
    const [t0, t1, t2, t3] = [weights[0] * scale, weights[1] * scale, weights[2] * scale, weights[3] * scale];
    const w = t0 * (a * s) + t1 * (3 * a * t) + t2 * (3 * s * c) + t3 * (c * t);
    const rate = (at: number, from: number) => {
      const q0 = (p[at] - from) * t0;
      const q1 = (p[at + d] - from) * t1;
      const q2 = (p[at + 2 * d] - from) * t2;
      const q3 = (p[at + 3 * d] - from) * t3;
      return (3 * ((q1 - q0) * a + (q2 - q1) * b + (q3 - q2) * c)) / w;
    };
    const [x, y] = [rate(0, origin.x), rate(1, origin.y)];
    const z = d === 3 ? rate(2, origin.z as number) : 0;
    const isSmall = Math.abs(x) + Math.abs(y) + Math.abs(z) <= check.MAX_COORDINATE;
    return isSmall ? ((d === 3 ? { x, y, z } : { x, y }) as Point<D>) : undefined;
  }

  /**
   * The unit tangent at t. Where the derivative vanishes (handles of length 0, cusps) it is the limit; if all control
   * points are equal, it is zero.
   *
   * @param t the parameter, from 0 to 1; others extrapolate
   * @throws {RangeError} as `eval`
   */
  tangent(t: number): Point<D> {
    this.#requireParameter(t);
    curvesModule.functions.rational_tangent(this.#dimension, this._write(), t);
    return this._readPoint();
  }

  /**
   * The unit normal at t: in 2D the tangent turned by +90°, (x, y) → (−y, x); in 3D the principal normal, which is zero
   * where the curve is straight.
   *
   * @param t the parameter, from 0 to 1; others extrapolate
   * @throws {RangeError} as `eval`
   */
  normal(t: number): Point<D> {
    this.#requireParameter(t);
    curvesModule.functions.rational_normal(this.#dimension, this._write(), t);
    return this._readPoint();
  }

  /**
   * The curvature at t: in 2D positive when turning counter-clockwise (x right, y up), in 3D never negative. Infinite
   * at a cusp.
   *
   * @param t the parameter, from 0 to 1; others extrapolate
   * @throws {RangeError} as `eval`
   */
  curvature(t: number): number {
    this.#requireParameter(t);
    return curvesModule.functions.rational_curvature(this.#dimension, this._write(), t);
  }

  /**
   * Splits the curve at t into two, or at several parameters into one part more.
   *
   * With a list, in any order: the parts from 0 to the smallest parameter, between neighbours, and from the largest to 1,
   * see `subsegment`. Equal parameters, 0 and 1 give parts that are points.
   *
   * @param t the parameter, from 0 to 1; others extrapolate
   * @throws {RangeError} outside of [0, 1] if a weight of a part would not be above 0
   */
  split(t: number): [RationalCurve<D>, RationalCurve<D>];
  /** @param ts any number of parameters */
  split(ts: ArrayLike<number>): RationalCurve<D>[];
  split(t: number | ArrayLike<number>): RationalCurve<D>[] {
    if (check.isList(t)) return partsAt<RationalCurve<D>>(this, t, 1);
    check.finite(t, "t");
    const length = curvesModule.count(curvesModule.functions.rational_split(this.#dimension, this._write(), t));
    return [this._read(length / 2), this._read(length, length / 2)];
  }

  /** Splits the curve at t = ½ into two. */
  halve(): [RationalCurve<D>, RationalCurve<D>] {
    return this.split(0.5);
  }

  /**
   * The part from t0 to t1, reversed if t0 > t1.
   *
   * @param t0 the parameter of the start
   * @param t1 the parameter of the end
   * @throws {RangeError} as `split`
   */
  subsegment(t0: number, t1: number): RationalCurve<D> {
    check.finite(t0, "t0");
    check.finite(t1, "t1");
    return this._read(curvesModule.functions.rational_subsegment(this.#dimension, this._write(), t0, t1));
  }

  /** The same curve with the opposite direction. */
  reverse(): RationalCurve<D> {
    const d = this.#dimension;
    const flat = new Float64Array(this.#flat.length);
    for (let i = 0; i < flat.length; i += d) flat.set(this.#flat.subarray(i, i + d), flat.length - d - i);
    return rationalCurveOf({ flat, dimension: d }, this.#weights.slice().reverse()) as RationalCurve<D>;
  }

  /**
   * The same curve with a higher degree.
   *
   * @param times by how much the degree is raised, by default 1
   * @throws {RangeError} for a degree above 64
   */
  elevate(times = 1): RationalCurve<D> {
    check.whole(times, "times", 0, 64);
    let curve: RationalCurve<D> = this;
    for (let k = 0; k < times; k++)
      curve = curve._read(curvesModule.functions.rational_elevate(this.#dimension, curve._write()));
    return curve;
  }

  /**
   * The same curve in standard form: its first and last weight are 1.
   *
   * The points stay, t is replaced by the t′ with t′/(1 − t′) = ρ t/(1 − t), and wᵢ by wᵢ/(w₀ ρⁱ), where ρⁿ = wₙ/w₀. The ratios
   * wᵢ₋₁ wᵢ₊₁/wᵢ², which make up the shape, stay up to rounding.
   *
   * @throws {RangeError} for a weight beyond 2^500 or below 2^-500
   */
  reparametrize(): RationalCurve<D> {
    return this._read(curvesModule.functions.rational_reparametrize(this.#dimension, this._write()));
  }

  /**
   * The curve transformed by an affine map, which keeps the weights, or by a projective map, which changes them. The image is
   * exact up to rounding.
   *
   * A projective map is a matrix of 3×3 numbers in the plane or 4×4 numbers, column by column, whose last row is not 0 … 0 1:
   * (P, 1) is mapped to (Q, v), the point Q/v with the weight wv. Multiples of a matrix are the same map.
   *
   * @param matrix 6, 9 or 16 numbers, a DOMMatrix or another object with a matrix, or a text such as "translate(50 50) rotate(30)"
   * @throws {RangeError} for an image with a coordinate beyond 2^500, and for a projective map whose line (or plane) at infinity
   *   passes between the control points: split the curve and map its parts
   */
  transform(matrix: TransformLike): RationalCurve<D> {
    const numbers = projective(matrix, this.#dimension);
    if (numbers) return this._read(curvesModule.functions.rational_project(this.#dimension, this._write(numbers)));
    const map = affine(matrix);
    curvesModule.write(this.#flat, map.length).set(map, this.#flat.length);
    const length = curvesModule.functions.points_transform(this.#dimension, this.#weights.length);
    const points = { flat: curvesModule.read(0, length), dimension: this.#dimension };
    return rationalCurveOf(points, this.#weights) as RationalCurve<D>;
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
    const vertices = curvesModule.functions.rational_flatten(this.#dimension, this._write(), tolerance);
    return curvesModule.readPolyline(curvesModule.count(vertices), this.#dimension);
  }

  /** The smallest box that contains the curve. */
  bounds(): Bounds<D> {
    curvesModule.functions.rational_bounds(this.#dimension, this._write());
    return boxAt(curvesModule.read(0, 6), this.#dimension);
  }

  /** The box of the control points, which contains the curve. */
  controlBounds(): Bounds<D> {
    curvesModule.functions.curve_bounds(this.#dimension, this._write(), false);
    return boxAt(curvesModule.read(0, 6), this.#dimension);
  }

  /** The parameters inside (0, 1) where a coordinate has a local extremum (its derivative changes sign), sorted. */
  extrema(): Extrema {
    const [x, y, z] = Array.from({ length: this.#dimension }, (_, axis) =>
      curvesModule.read(0, curvesModule.functions.rational_extrema(this.#dimension, this._write(), axis)),
    );
    return this.#dimension === 2 ? { x, y } : { x, y, z };
  }

  /** The parameters inside (0, 1) where the curvature changes sign, sorted; 2D only. */
  inflections(): Float64Array {
    this._require2D("inflections");
    return curvesModule.read(0, curvesModule.functions.rational_inflections(this._write()));
  }

  /**
   * The arc length ∫ |B′(t)| dt with a relative error below 10⁻¹² for weights whose ratios are at most 2²⁰ (up to degree 3, 2¹⁰⁰).
   *
   * At most 4096 intervals are integrated.
   *
   * @returns 0 if all control points are equal
   */
  length(): number {
    return curvesModule.functions.rational_length(this.#dimension, this._write());
  }

  /**
   * The t at which the arc length from the start is s. An s outside of [0, length] gives the nearer end. The error, as a
   * length, is at most 10⁻¹² of the curve's length.
   *
   * @param s the length, in the unit of the points
   * @returns 0 to 1
   */
  timeAtLength(s: number): number {
    check.finite(s, "s");
    return curvesModule.functions.rational_time_at_length(this.#dimension, this._write(), s);
  }

  /**
   * The point at the arc length s from the start, with its t, unit tangent and unit normal. An s outside of [0, length] gives
   * the nearer end. If all control points are equal, t is 0 and both directions are zero.
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
   * The signed area ½ ∫ (x dy − y dx) swept by the line from the origin to the point of the curve, positive while that
   * line turns counter-clockwise (x right, y up). The areas of the segments of an outline add up to its area. The error is about
   * 10⁻¹⁴ of the square of the size for weights whose ratios are at most 2²⁰. 2D only.
   */
  area(): number {
    this._require2D("area");
    return curvesModule.functions.rational_area(this._write());
  }

  /**
   * The point of the curve that is nearest to p: the global minimum of the distance for t in [0, 1], found by isolating
   * the roots of (B(t) − p)·B′(t), of degree 3n − 2. Of several nearest points, it is the one with the smallest t.
   *
   * @param p the point, in the unit of the points
   */
  nearest(p: PointLike): Nearest<D> {
    const d = this.#dimension;
    const coordinates = new Float64Array(d);
    writePoint(coordinates, 0, p, d, "p");
    return this._nearest(coordinates);
  }

  /**
   * The nearest point to a point that is checked.
   *
   * @internal
   * @param coordinates of the point
   */
  _nearest(coordinates: Float64Array): Nearest<D> {
    curvesModule.count(curvesModule.functions.rational_nearest(this.#dimension, this._write(coordinates)));
    return readNearest(this.#dimension);
  }

  /**
   * All intersections with a curve, another rational curve, a NURBS curve or a spline (then u is its t), or a path (then u is a
   * location {subpath, t}), sorted by t, then by u; with a path by its subpaths first.
   *
   * End points count; kinds and limits are those of `Curve.intersections`. Arcs of one conic section overlap however they are
   * parametrized. 2D only.
   *
   * Curves intersect where their distance is below rounding: about 2ε (L + 2(n + 1) S), with ε = 2.2e-16, the largest
   * coordinate L, the size S of the box around both curves and the higher degree n. Where weights differ much, the rounding of
   * t moves the point by more than that, and a tangency there may be missed.
   *
   *     const quarter = RationalCurve.conic([1, 0], [1, 1], [0, 1], Math.SQRT1_2);
   *     quarter.intersections(new Curve([[0, 0], [3, 4]]))[0].point; // about { x: 0.6, y: 0.8 }
   *
   * @param other a curve, a rational curve, a NURBS curve, a spline or a path, of any entry point
   * @throws {TypeError} for a 3D curve
   */
  intersections<S extends CoreCurve | RationalCurve | NurbsCurve | CoreSpline | CorePath>(
    other: S,
  ): Intersection<number, S extends CorePath ? PathTime : number>[] {
    return intersectNurbs(nurbsOfRational(this.casteljauData()), other) as any;
  }

  /**
   * The points that the curve passes twice, sorted by t; t < u. If the end equals the start, that point is one of them.
   * Parts that the curve retraces are not reported; conics have none. 2D only.
   */
  selfIntersections(): SelfIntersection[] {
    return selfIntersectNurbs(nurbsOfRational(this.casteljauData()));
  }

  /**
   * The curve as a spline of cubics, or, if all weights are equal, exactly as one segment of its degree.
   *
   * Its joints are smooth: each cubic has the ends and the end tangents of its part of the curve. A circle of radius 1
   * takes 8 cubics for 1e-4 and 16 for 1e-6.
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
    const error = check.optionalTolerance(tolerance) || defaultTolerance(this.#flat, this.controlBounds());
    return readSplineData(
      curvesModule.functions.rational_to_spline(this.#dimension, this._write(), error),
      this.#dimension,
    );
  }

  /** The segments of `toSpline` as a packed path, for drawing. */
  #packed(tolerance: number | undefined): Float64Array {
    const { flat, degrees } = this.#spline(tolerance);
    return packedSpline(flat, degrees, false);
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
    traceOn(this.#packed(check.options(options, ["tolerance"]).tolerance), canvas, options);
  }

  /**
   * The curve as SVG path data: an arc (`A`) if it has degree 2 and is an arc of an ellipse, otherwise cubics. 2D only.
   *
   * @param options `precision`: 0 to 100, the maximum number of digits after the decimal point; selects the shortest form;
   *   `tolerance`: of the cubics, as in `toSpline`
   */
  toSVG(options?: SvgOptions): string {
    this._require2D("toSVG");
    const { precision, tolerance } = check.options(options, ["precision", "tolerance"]);
    const maxError = check.optionalTolerance(tolerance);
    checkTolerance(packedSpline(this.#flat, [this.degree], false), maxError);
    return svgOfRational([this.casteljauData()], false, precision, maxError, () => this.#packed(tolerance));
  }

  /** The curve as `toSVG` writes it, or in space as JSON: `String(curve)` and `${curve}` give this text. */
  toString(): string {
    return this.dimension === 2 ? this.toSVG() : JSON.stringify(this);
  }

  /**
   * The conic section of degree 2 with the weights 1, w, 1.
   *
   * It touches the lines p0p1 and p1p2 at its ends. w < 1 gives an arc of an ellipse, w = 1 of a parabola, w > 1 of a
   * hyperbola. If p1 is at the same distance from both ends, w = cos α gives an arc of a circle, where 2α is its angle, and α is
   * the angle between p0p1 and p0p2.
   *
   *     RationalCurve.conic([1, 0], [1, 1], [0, 1], Math.SQRT1_2); // a quarter of the unit circle
   *
   * @param p0 the start
   * @param p1 the point where the tangents at both ends meet
   * @param p2 the end
   * @param w the weight of p1, above 0
   * @throws {RangeError} as the constructor
   */
  static conic<D extends 2 | 3 = 2 | 3>(
    p0: PointArrays<D>[number] | PointLike,
    p1: PointArrays<D>[number] | PointLike,
    p2: PointArrays<D>[number] | PointLike,
    w: number,
  ): RationalCurve<D> {
    const dimension = dimensionOf(p0, "p0");
    const flat = new Float64Array(3 * dimension);
    [p0, p1, p2].forEach((p, k) => writePoint(flat, k * dimension, p, dimension, `p${k}`));
    const weights = Float64Array.of(1, checkedWeight(w, "w"), 1);
    return rationalCurveOf({ flat, dimension }, weights) as RationalCurve<D>;
  }

  /**
   * A curve with the weights 1, or a rational curve itself.
   *
   * @param curve of any entry point
   */
  static from<D extends 2 | 3 = 2 | 3>(curve: CoreCurve<D> | RationalCurve<D>): RationalCurve<D> {
    if (typeOf(curve) === "rationalcurve") {
      const { flat, dimension, weights } = rationalData(curve, "curve");
      return rationalCurveOf({ flat, dimension }, weights) as RationalCurve<D>;
    }
    const { flat, dimension } = curveData(curve, "curve");
    const weights = new Float64Array(flat.length / dimension).fill(1);
    return rationalCurveOf({ flat, dimension }, weights) as RationalCurve<D>;
  }

  /**
   * The curve that `toJSON` described.
   *
   * @param json what `toJSON` returned
   */
  static fromJSON(json: RationalCurveJSON): RationalCurve {
    requireJSON(json, "points and weights", ({ points, weights }) => points !== undefined && weights !== undefined);
    const points = checkedPoints(json.points, { dimension: json.dimension });
    return rationalCurveOf(points, checkedWeights(json.weights, points.flat.length / points.dimension));
  }
}

/** Outside of the class, so that it does not refer to itself; see `markClassNames` in xtask/bundle.js. */
function show() {
  isShown = showInNode(RationalCurve.prototype, "RationalCurve", (value) => value.toJSON());
}

/**
 * A rational curve whose points and weights are checked already.
 *
 * @internal
 */
export function rationalCurveOf(points: ControlPoints, weights: Float64Array): RationalCurve {
  return fromChecked(RationalCurve, { flat: points.flat, dimension: points.dimension, weights }); // outside of the class, see ../curve/core-curve.js
}

/**
 * The tolerance of cubics that replace a curve with the given coordinates and the box of its control points.
 *
 * @internal
 */
export function defaultTolerance(flat: Float64Array, { min, max }: Bounds): number {
  const diagonal = Math.hypot(max.x - min.x, max.y - min.y, (max.z ?? 0) - (min.z ?? 0));
  const largest = flat.reduce((size, x) => Math.max(size, Math.abs(x)), 0);
  return Math.max(1e-4 * diagonal, 1e-12 * largest) || 1;
}

function checkedPoints(points: PointsLike, options?: { dimension?: 2 | 3 }): ControlPoints {
  requireList(points);
  const { flat, dimension } = flatten(points, check.options(options, ["dimension"]).dimension, 2);
  const count = flat.length / dimension;
  if (count >= 2 && count <= 65) return { flat, dimension };
  throw new RangeError(`points: expected 2 to 65 control points (degree 1 to 64), got ${count}`);
}

/**
 * The weights as numbers, one for each point.
 *
 * @internal
 * @param count of the points
 */
export function checkedWeights(weights: ArrayLike<number>, count: number, name = "weights"): Float64Array {
  const numbers = check.numbers(weights, name);
  if (numbers.length !== count) {
    throw new RangeError(`${name}: expected ${count} numbers, one for each point, got ${numbers.length}`);
  }
  numbers.forEach((w, i) => checkedWeight(w, `${name}[${i}]`));
  return numbers;
}

function checkedWeight(value: number, name: string): number {
  const w = check.finite(value, name);
  if (w >= 1 / MAX_WEIGHT && w <= MAX_WEIGHT) return w;
  throw new RangeError(`${name}: expected a number above 0, from 2^-500 to 2^500, got ${w}`);
}

function notDefinedAt(t: number, name: string) {
  return new RangeError(`${name}: expected a parameter at which the denominator of the curve is above 0, got ${t}`);
}

/** The polynomials wP and w of which a rational curve is the quotient. */
type Homogeneous = { numerator: CoreCurve<3>; denominator: CoreCurve<2> | null };

/**
 * The weights, the products of the weights and the coordinates x, the same of y and of z, as those of a cubic: zeros follow those
 * of a lower degree. All are divided by a power of two near the largest weight.
 */
function homogeneousPoints(flat: Float64Array, weights: Float64Array, dimension: number): Float64Array {
  const numbers = new Float64Array(4 * (dimension + 1));
  const scale = scaleOf(weights);
  for (const [i, weight] of weights.entries()) {
    numbers[i] = weight * scale;
    for (let k = 0; k < dimension; k++) numbers[4 * (k + 1) + i] = flat[i * dimension + k] * (weight * scale);
  }
  return numbers;
}

const scaleOf = (weights: Float64Array) => 2 ** -Math.floor(Math.log2(Math.max(...weights)));

/**
 * The polynomials of a rational curve, as curves: in the plane one in space, with w as the third coordinate; in space wP, and w as
 * the first coordinate of a plane curve. Both are divided by a power of two near the largest weight.
 */
function homogeneous(flat: Float64Array, weights: Float64Array, dimension: number): Homogeneous {
  const scale = scaleOf(weights);
  const [numerator, denominator] = [new Float64Array(3 * weights.length), new Float64Array(2 * weights.length)];
  for (const [i, weight] of weights.entries()) {
    const w = weight * scale;
    for (let k = 0; k < 3; k++) numerator[3 * i + k] = k < dimension ? flat[i * dimension + k] * w : w;
    denominator[2 * i] = w;
  }
  return {
    numerator: coreCurveOf({ flat: numerator, dimension: 3 }) as CoreCurve<3>,
    denominator: dimension === 2 ? null : (coreCurveOf({ flat: denominator, dimension: 2 }) as CoreCurve<2>),
  };
}
