import { curveData } from "../brand.js";
import { affine } from "../affine.js";
import * as check from "../check.js";
import { modeCode, modeCodes } from "../joints.js";
import { SplineEvaluation } from "./spline-evaluation.js";
import { svgOf, traceOn } from "../../io/svg-write.js";
import { core } from "../../wasm/init.js";
import { packedSpline } from "../../wasm/packed-path.js";
import { writeArguments, readResult } from "../../wasm/transfer.js";
import type { TransformLike, PointLike } from "../check.js";
import type { CoreCurve } from "../curve/core-curve.js";
import type { Continuity, JointMode } from "../joints.js";
import type { SvgOptions } from "../../io/svg-write.js";

/**
 * What the splines of all entry points have in common. Where a function takes a spline, it takes the splines of every
 * entry point.
 */
export class CoreSpline<D extends 2 | 3 = 2 | 3, C extends CoreCurve<D> = CoreCurve<D>> extends SplineEvaluation<D, C> {
  /**
   * The continuity at the joint t = `joint` (closed splines have a joint 0, too).
   *
   * @param joint the number of the joint: its t
   * @param tolerance a distance, by default 1e-9 of the extent of the two segments
   */
  continuity(joint: number, tolerance?: number): Continuity {
    this._checkJoint(joint);
    const count = core().spline_continuity(this._write(), joint, check.optionalTolerance(tolerance));
    const [c0, g1, c1, g2, c2, gap, angle] = readResult(0, count);
    return { c0: c0 === 1, g1: g1 === 1, c1: c1 === 1, g2: g2 === 1, c2: c2 === 1, gap, angle };
  }

  /**
   * The spline with one more segment that ends at `point`, with automatic handles.
   *
   * @param point the point, in the unit of the points
   */
  append(point: PointLike): this {
    if (this.closed) throw new RangeError("append: expected an open spline, which has an end, got a closed one");
    return this._read(core().spline_append(this._write(this._coordinates(point, "point"))));
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
   * @param options `joints[k]`: the mode of the joint at t = k, by default "free"
   * @throws {RangeError} for an index past the last point, an unknown mode, and "g2" in 3D
   */
  movePoint(
    index: number,
    to: PointLike,
    options?: { joints?: ArrayLike<JointMode | undefined> | Record<number, JointMode> },
  ): this {
    const last = this.casteljauData().flat.length / this.dimension - 1;
    check.whole(index, "index", 0, last);
    const modes = modeCodes(check.options(options, ["joints"]).joints, this.segmentCount, this.dimension);
    const position = this._coordinates(to, "to");
    const args = new Float64Array(position.length + modes.length);
    args.set(position);
    args.set(modes, position.length);
    return this._read(core().spline_move_point(this._write(args), index));
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
    return this._read(core().spline_set_joint(this._write(), joint, modeCode(mode, "mode", this.dimension)));
  }

  /**
   * The parts before and after t, as open splines whose parameters start at 0.
   *
   * The segment that contains t is split by `Curve.split`; the other control points are unchanged. At a joint no
   * segment is split. At the start and at the end one part is a single segment whose points are equal. A closed spline
   * is also divided at its start: the first part begins there, the second part ends there.
   *
   * @param t 0 to the number of segments; values outside extrapolate the first and the last segment
   * @throws {RangeError} for a t that is not finite
   */
  split(t: number, ...surplus: never[]): [this, this] {
    check.noSurplus(surplus, "split", 1, "subsegment(t0, t1)");
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
  subsegment(t0: number, t1: number, ...surplus: never[]): this {
    check.noSurplus(surplus, "subsegment", 2);
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
  hull(...surplus: never[]): Float64Array {
    check.noSurplus(surplus, "hull", 0);
    this._require2D("hull");
    const { flat } = this.casteljauData();
    writeArguments(flat);
    return readResult(0, core().curve_hull(flat.length / 2));
  }

  /**
   * The same spline with an additional joint at t.
   *
   * @param t 0 to the number of segments
   */
  insert(t: number, ...surplus: never[]): this {
    check.noSurplus(surplus, "insert", 1);
    check.finite(t, "t");
    return this._read(core().spline_insert(this._write(), t));
  }

  /**
   * The spline without a joint: its two segments become one. This is the exact inverse of `insert`.
   *
   * @param joint the number of the joint: its t
   */
  remove(joint: number): this {
    this._checkJoint(joint);
    return this._read(core().spline_remove(this._write(), joint));
  }

  /** The same spline with the opposite direction. */
  reverse(): this {
    return this._read(core().spline_reverse(this._write()));
  }

  /**
   * The spline transformed by an affine map.
   *
   * @param matrix a matrix, or a text such as "translate(50 50) rotate(30)"
   * @throws {RangeError} for an image with a coordinate beyond 2^500
   */
  transform(matrix: TransformLike): this {
    const { flat, dimension } = this.casteljauData();
    writeArguments(flat, 12).set(affine(matrix), flat.length);
    const length = core().points_transform(dimension, flat.length / dimension);
    return this._splineOf({ ...this.casteljauData(), flat: readResult(0, length) });
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

  /** The spline as SVG path data without arcs, see `Path.toSVG`; 2D only. */
  toSVG(options?: SvgOptions): string {
    const { flat, dimension, degrees, closed } = this.casteljauData();
    check.require2D("toSVG", "spline", dimension);
    return svgOf(packedSpline(flat, degrees, closed), options);
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
   * @internal
   */
  _checkJoint(joint: unknown) {
    check.whole(joint, "joint", this.closed ? 0 : 1, this.segmentCount - 1);
  }
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
  writeArguments(Float64Array.from([data.length, closed, ...degrees, ...data.flatMap(({ flat }) => [...flat])]));
  return { length: core().spline_from_curves(dimension), dimension };
}
