import * as check from "../check.js";
import { CurveValue } from "./curve-value.js";
import { core, cubicEval } from "../../wasm/init.js";
import { readResult, readResultInto, readLargeResult } from "../../wasm/transfer.js";
import type { Point } from "../points.js";

/** Points and derivatives of a curve at given parameters. */
export class CurveEvaluation<D extends 2 | 3 = 2 | 3> extends CurveValue<D> {
  /**
   * The point at t.
   *
   * @param t the parameter, from 0 to 1; others extrapolate
   */
  eval(t: number): Point<D> {
    if (typeof t !== "number" || t - t !== 0) check.finite(t, "t");
    const flat = this._flat;
    if (flat.length === 4 * this.dimension) return cubicAt(flat, t) as Point<D>;
    core().curve_eval(this.dimension, this._write(), t);
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
    const count = core().curve_sample(this.dimension, this._write(), segments);
    if (into !== undefined) return readResultInto(into, count);
    return readLargeResult(count);
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
    core().curve_eval_at(this.dimension, count, parameters.length);
    return readResultInto(into, length);
  }

  /** The derivative as a curve of degree n − 1; the derivative of a line is a line whose two points are equal. */
  derivative(...surplus: never[]): this {
    check.noSurplus(surplus, "derivative", 0, "derivativeAt(t)");
    return this._read(core().curve_derivative(this.dimension, this._write()));
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
    core().curve_derivative_at(this.dimension, this._write(), t, k);
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
    core().curve_tangent(this.dimension, this._write(), t);
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
    core().curve_normal(this.dimension, this._write(), t);
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
    return core().curve_curvature(this.dimension, this._write(), t);
  }

  /**
   * All levels of de Casteljau's algorithm at t: the first level is the control points, the last is the point of the
   * curve.
   *
   * @param t the parameter, from 0 to 1; others extrapolate
   */
  deCasteljau(t: number): Float64Array[] {
    check.finite(t, "t");
    core().curve_de_casteljau(this.dimension, this._write(), t);
    const levels: Float64Array[] = [];
    for (let length = this._flat.length, from = 0; length > 0; length -= this.dimension) {
      levels.push(readResult(from, from + length));
      from += length;
    }
    return levels;
  }
}

/**
 * The point of a cubic, the most common kind of curve. Passing its coordinates as arguments takes a quarter of the time
 * of passing them through the arena.
 */
function cubicAt(p: Float64Array, t: number): Point {
  const at = cubicEval();
  if (p.length === 8) return { x: at(p[0], p[2], p[4], p[6], t), y: at(p[1], p[3], p[5], p[7], t) };
  return { x: at(p[0], p[3], p[6], p[9], t), y: at(p[1], p[4], p[7], p[10], t), z: at(p[2], p[5], p[8], p[11], t) };
}
