import { basisNumbers, BASES } from "../basis.js";
import { affine } from "../affine.js";
import * as check from "../check.js";
import { CurveEvaluation } from "./curve-evaluation.js";
import { boxAt } from "../points.js";
import { readTree } from "../subdivision.js";
import { svgOf, traceOn } from "../../io/svg-write.js";
import { core } from "../../wasm/init.js";
import { packedSpline } from "../../wasm/packed-path.js";
import { readPolyline, readResult } from "../../wasm/transfer.js";
import type { BasisLike, BasisName } from "../basis.js";
import type { TransformLike } from "../check.js";
import type { Bounds } from "../points.js";
import type { Subdivision } from "../subdivision.js";
import type { SvgOptions } from "../../io/svg-write.js";

/**
 * What the curves of all entry points have in common. Where a function takes a curve, it takes the curves of every entry
 * point.
 */
export class CoreCurve<D extends 2 | 3 = 2 | 3> extends CurveEvaluation<D> {
  /**
   * The values of the n + 1 Bernstein polynomials of a degree at t; for t in [0, 1] their sum is 1 within one ulp.
   *
   * @param degree 0 to 64
   * @param t the parameter, mostly from 0 to 1
   */
  static bernstein(degree: number, t: number): Float64Array {
    check.whole(degree, "degree", 0, 64);
    return readResult(0, core().bernstein_weights(degree, check.finite(t, "t")));
  }

  /**
   * The 4×4 matrix of a basis, row-major: rows for t³, t², t and 1, columns for the geometry points.
   *
   * @param name the basis
   * @returns 16 numbers
   */
  static basisMatrix(name: BasisName): Float64Array {
    check.oneOf(name, "basis", BASES);
    return basisNumbers(name);
  }

  /**
   * Splits the curve at t into two.
   *
   * @param t the parameter, from 0 to 1; others extrapolate
   */
  split(t: number, ...surplus: never[]): [this, this] {
    check.noSurplus(surplus, "split", 1, "subsegment(t0, t1)");
    if (typeof t !== "number" || t - t !== 0) check.finite(t, "t");
    core().curve_split(this.dimension, this._write(), t);
    const n = this._flat.length;
    return [this._curveOf(readResult(0, n)), this._curveOf(readResult(n, 2 * n))];
  }

  /** Splits the curve at t = ½ into two. */
  halve(...surplus: never[]): [this, this] {
    check.noSurplus(surplus, "halve", 0, "split(t)");
    return this.split(0.5);
  }

  /**
   * The part from t0 to t1, reversed if t0 > t1.
   *
   * @param t0 the parameter of the start
   * @param t1 the parameter of the end
   */
  subsegment(t0: number, t1: number, ...surplus: never[]): this {
    check.noSurplus(surplus, "subsegment", 2);
    check.finite(t0, "t0");
    check.finite(t1, "t1");
    core().curve_subsegment(this.dimension, this._write(), t0, t1);
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
    for (let k = 0; k < times; k++) curve = curve._read(core().curve_elevate(this.dimension, curve._write()));
    return curve;
  }

  /**
   * The curve transformed by an affine map.
   *
   * @param matrix a matrix, or a text such as "translate(50 50) rotate(30)"
   * @throws {RangeError} for an image with a coordinate beyond 2^500
   */
  transform(matrix: TransformLike): this {
    return this._read(core().points_transform(this.dimension, this._write(affine(matrix))));
  }

  /**
   * The four geometry points that give this curve (of degree at most 3) in another basis.
   *
   * @param basis a name, or a 4×4 matrix, row-major
   */
  toBasis(basis: BasisLike): Float64Array {
    const matrix = basisNumbers(basis);
    return readResult(0, core().curve_to_basis(this.dimension, this._write(matrix)));
  }

  /**
   * A polyline whose distance from the curve is nowhere greater than `tolerance`.
   *
   * @param tolerance in the unit of the points
   * @returns the vertices and their parameters
   * @throws {RangeError} for a tolerance not above 0 or below 4 ulps of the largest coordinate
   */
  flatten(tolerance: number, ...surplus: never[]): { points: Float64Array; ts: Float64Array } {
    check.noSurplus(surplus, "flatten", 1);
    check.positive(tolerance, "tolerance");
    const vertices = core().curve_flatten(this.dimension, this._write(), tolerance);
    return readPolyline(vertices, this.dimension);
  }

  /**
   * The tree of recursive halving until D1 − D2 < tolerance, where D1 is the length of the control polygon and D2 the
   * length of the chord. For teaching: D1 − D2 is not a bound on the distance, but `deviationBound` is.
   *
   * @param tolerance the largest distance, in the unit of the points
   */
  subdivide(tolerance: number, ...surplus: never[]): Subdivision<this> {
    check.noSurplus(surplus, "subdivide", 1);
    check.positive(tolerance, "tolerance");
    const used = core().curve_subdivide(this.dimension, this._write(), tolerance);
    return readTree(readResult(0, used), this._flat.length, (flat) => this._curveOf(flat));
  }

  /** The smallest box that contains the curve. */
  bounds(...surplus: never[]): Bounds<D> {
    check.noSurplus(surplus, "bounds", 0, "subsegment(t0, t1).bounds()");
    return this._box(true);
  }

  /** The box of the control points, which contains the curve. */
  controlBounds(): Bounds<D> {
    return this._box(false);
  }

  /** The corners of the convex hull of the control points, counter-clockwise (x right, y up); 2D only. */
  hull(...surplus: never[]): Float64Array {
    check.noSurplus(surplus, "hull", 0, "deCasteljau(t)");
    this._require2D("hull");
    return readResult(0, core().curve_hull(this._write()));
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

  /** The curve as SVG path data without arcs, see `Path.toSVG`; 2D only. */
  toSVG(options?: SvgOptions): string {
    this._require2D("toSVG");
    return svgOf(packedSpline(this._flat, [this.degree], false), options);
  }

  /**
   * @internal
   */
  _box(exact: boolean): Bounds<D> {
    core().curve_bounds(this.dimension, this._write(), exact);
    return boxAt(readResult(0, 6), this.dimension);
  }
}
