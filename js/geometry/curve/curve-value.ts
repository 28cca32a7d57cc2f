import { curveData } from "../brand.js";
import * as check from "../check.js";
import { showInNode } from "../inspected.js";
import { flatten, nested, pointAt, pointList, samePoints, requireList } from "../points.js";
import { CheckedPoints, writeArguments, readResult } from "../../wasm/transfer.js";
import type { SplineData } from "../brand.js";
import type { PointsLike } from "../check.js";
import type { Point, PointArrays } from "../points.js";

/** Whether Node knows how to show the instances. */
let isShown = false;

/** What `Curve.toJSON` returns; `Curve.fromJSON` also reads other forms of points. */
export type CurveJSON = { points: PointsLike; dimension?: 2 | 3 };

/**
 * The control points of a curve, and what the classes of curves need to pass them to the core.
 *
 * The members with an underscore are for the classes that extend this one. Private names cannot be shared between files,
 * and bundlers keep an unused class that has a computed name.
 *
 * @template D the dimension
 */
export class CurveValue<D extends 2 | 3 = 2 | 3> {
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
    if (!isShown) isShown = showInNode(CurveValue.prototype, "Curve", (value) => value.toJSON());
    const checked = points as unknown;
    if (checked instanceof CheckedPoints) {
      this.#flat = checked.flat;
      this.#dimension = checked.dimension as D;
      return;
    }
    const { flat, dimension } = checkedPoints(points, options);
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
  equals(other: CurveValue, tolerance = 0): boolean {
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
   * A curve of the same class and dimension. The class of each entry point implements it.
   *
   * @internal
   */
  _curveOf(flat: Float64Array): this {
    throw new TypeError(`expected a class that makes curves of ${flat.length} numbers`);
  }

  /**
   * @internal
   * Writes the control points, and then further numbers, to the arena.
   * @returns the number of points
   */
  _write(further?: ArrayLike<number>): number {
    const view = writeArguments(this.#flat, further?.length);
    if (further) view.set(further, this.#flat.length);
    return this.#flat.length / this.#dimension;
  }

  /**
   * @internal
   * Reads the control points of a curve from the arena.
   */
  _read(length: number): this {
    return this._curveOf(readResult(0, length));
  }

  /**
   * @internal
   */
  _readPoint(): Point<D> {
    return pointAt(readResult(0, 3), 0, this.#dimension);
  }

  /**
   * @internal
   */
  _require2D(method: string) {
    check.require2D(method, "curve", this.#dimension);
  }
}

function checkedPoints(points: PointsLike, options?: { dimension?: 2 | 3 }): CheckedPoints {
  requireList(points);
  const { flat, dimension } = flatten(points, check.options(options, ["dimension"]).dimension, 2);
  const count = flat.length / dimension;
  if (count >= 2 && count <= 65) return new CheckedPoints(flat, dimension);
  throw new RangeError(`points: expected 2 to 65 control points (degree 1 to 64), got ${count}`);
}

/**
 * The control points of a curve in JSON.
 *
 * @internal
 */
export function curvePointsOf(json: CurveJSON): CheckedPoints {
  if (typeof json !== "object" || json === null) {
    throw new TypeError(`json: expected an object with points, got ${check.describe(json)}`);
  }
  return checkedPoints(json.points, { dimension: json.dimension });
}
