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

/**
 * @import { BasisLike, BasisName } from "../basis.js"
 * @import { TransformLike } from "../check.js"
 * @import { Bounds } from "../points.js"
 * @import { Subdivision } from "../subdivision.js"
 * @import { SvgOptions } from "../../io/svg-write.js"
 */

/**
 * What the curves of all entry points have in common. Where a function takes a curve, it takes the curves of every entry
 * point.
 *
 * @template {2 | 3} [D=2 | 3]
 * @extends {CurveEvaluation<D>}
 */
export class CoreCurve extends CurveEvaluation {
  /**
   * The values of the n + 1 Bernstein polynomials of a degree at t; for t in [0, 1] their sum is 1 within one ulp.
   *
   * @param {number} degree 0 to 64
   * @param {number} t the parameter, mostly from 0 to 1
   * @returns {Float64Array}
   */
  static bernstein(degree, t) {
    check.whole(degree, "degree", 0, 64);
    return readResult(0, core().bernstein_weights(degree, check.finite(t, "t")));
  }

  /**
   * The 4×4 matrix of a basis, row-major: rows for t³, t², t and 1, columns for the geometry points.
   *
   * @param {BasisName} name the basis
   * @returns {Float64Array} 16 numbers
   */
  static basisMatrix(name) {
    check.oneOf(name, "basis", BASES);
    return basisNumbers(name);
  }

  /**
   * Splits the curve at t into two.
   *
   * @param {number} t the parameter, from 0 to 1; others extrapolate
   * @param {never[]} surplus
   * @returns {[this, this]}
   */
  split(t, ...surplus) {
    check.noSurplus(surplus, "split", 1, "subsegment(t0, t1)");
    if (typeof t !== "number" || t - t !== 0) check.finite(t, "t");
    core().curve_split(this.dimension, this._write(), t);
    const n = this._flat.length;
    return [this._curveOf(readResult(0, n)), this._curveOf(readResult(n, 2 * n))];
  }

  /**
   * Splits the curve at t = ½ into two.
   *
   * @param {never[]} surplus
   * @returns {[this, this]}
   */
  halve(...surplus) {
    check.noSurplus(surplus, "halve", 0, "split(t)");
    return this.split(0.5);
  }

  /**
   * The part from t0 to t1, reversed if t0 > t1.
   *
   * @param {number} t0 the parameter of the start
   * @param {number} t1 the parameter of the end
   * @param {never[]} surplus
   * @returns {this}
   */
  subsegment(t0, t1, ...surplus) {
    check.noSurplus(surplus, "subsegment", 2);
    check.finite(t0, "t0");
    check.finite(t1, "t1");
    core().curve_subsegment(this.dimension, this._write(), t0, t1);
    return this._read(this._flat.length);
  }

  /**
   * The same curve with the opposite direction.
   *
   * @returns {this}
   */
  reverse() {
    const d = this.dimension;
    const flat = new Float64Array(this._flat.length);
    for (let i = 0; i < flat.length; i += d) flat.set(this._flat.subarray(i, i + d), flat.length - d - i);
    return this._curveOf(flat);
  }

  /**
   * The same curve with a higher degree.
   *
   * @param {number} [times] by how much the degree is raised, by default 1
   * @returns {this}
   * @throws {RangeError} for a degree above 64
   */
  elevate(times = 1) {
    check.whole(times, "times", 0, 64);
    /** @type {this} */
    let curve = this;
    for (let k = 0; k < times; k++) curve = curve._read(core().curve_elevate(this.dimension, curve._write()));
    return curve;
  }

  /**
   * The curve transformed by an affine map.
   *
   * @param {TransformLike} matrix a matrix, or a text such as "translate(50 50) rotate(30)"
   * @returns {this}
   * @throws {RangeError} for an image with a coordinate beyond 2^500
   */
  transform(matrix) {
    return this._read(core().points_transform(this.dimension, this._write(affine(matrix))));
  }

  /**
   * The four geometry points that give this curve (of degree at most 3) in another basis.
   *
   * @param {BasisLike} basis a name, or a 4×4 matrix, row-major
   * @returns {Float64Array}
   */
  toBasis(basis) {
    const matrix = basisNumbers(basis);
    return readResult(0, core().curve_to_basis(this.dimension, this._write(matrix)));
  }

  /**
   * A polyline whose distance from the curve is nowhere greater than `tolerance`.
   *
   * @param {number} tolerance in the unit of the points
   * @param {never[]} surplus
   * @returns {{ points: Float64Array, ts: Float64Array }} the vertices and their parameters
   * @throws {RangeError} for a tolerance not above 0 or below 4 ulps of the largest coordinate
   */
  flatten(tolerance, ...surplus) {
    check.noSurplus(surplus, "flatten", 1);
    check.positive(tolerance, "tolerance");
    const vertices = core().curve_flatten(this.dimension, this._write(), tolerance);
    return readPolyline(vertices, this.dimension);
  }

  /**
   * The tree of recursive halving until D1 − D2 < tolerance, where D1 is the length of the control polygon and D2 the
   * length of the chord. For teaching: D1 − D2 is not a bound on the distance, but `deviationBound` is.
   *
   * @param {number} tolerance the largest distance, in the unit of the points
   * @param {never[]} surplus
   * @returns {Subdivision<this>}
   */
  subdivide(tolerance, ...surplus) {
    check.noSurplus(surplus, "subdivide", 1);
    check.positive(tolerance, "tolerance");
    const used = core().curve_subdivide(this.dimension, this._write(), tolerance);
    return readTree(readResult(0, used), this._flat.length, (flat) => this._curveOf(flat));
  }

  /**
   * The smallest box that contains the curve.
   *
   * @param {never[]} surplus
   * @returns {Bounds<D>}
   */
  bounds(...surplus) {
    check.noSurplus(surplus, "bounds", 0, "subsegment(t0, t1).bounds()");
    return this._box(true);
  }

  /**
   * The box of the control points, which contains the curve.
   *
   * @returns {Bounds<D>}
   */
  controlBounds() {
    return this._box(false);
  }

  /**
   * The corners of the convex hull of the control points, counter-clockwise (x right, y up); 2D only.
   *
   * @param {never[]} surplus
   * @returns {Float64Array}
   */
  hull(...surplus) {
    check.noSurplus(surplus, "hull", 0, "deCasteljau(t)");
    this._require2D("hull");
    return readResult(0, core().curve_hull(this._write()));
  }

  /**
   * Draws the curve on a canvas context or a Path2D: `moveTo` its start, then the curve. 2D only.
   *
   * @param {CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D | Path2D} target a canvas context or a Path2D
   * @param {{ tolerance?: number }} [options] `tolerance`: for degrees above 3, which are drawn as cubics
   */
  trace(target, options) {
    this._require2D("trace");
    traceOn(packedSpline(this._flat, [this.degree], false), target, options);
  }

  /**
   * The curve as SVG path data without arcs, see `Path.toSVG`; 2D only.
   *
   * @param {SvgOptions} [options]
   * @returns {string}
   */
  toSVG(options) {
    this._require2D("toSVG");
    return svgOf(packedSpline(this._flat, [this.degree], false), options);
  }

  /**
   * @internal
   * @param {boolean} exact
   * @returns {Bounds<D>}
   */
  _box(exact) {
    core().curve_bounds(this.dimension, this._write(), exact);
    return boxAt(readResult(0, 6), this.dimension);
  }
}
