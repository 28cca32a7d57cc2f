import { onlySplineData } from "../brand.js";
import * as check from "../check.js";
import { showInNode } from "../inspected.js";
import { flatten, nested, pointAt, pointList, samePoints, writePoint, requireList } from "../points.js";
import { SegmentIndex } from "./segment-index.js";
import { writeArguments, readResult } from "../../wasm/transfer.js";
import type { SplineData } from "../brand.js";
import type { PointLike, PointsLike } from "../check.js";
import type { CoreCurve } from "../curve/core-curve.js";
import type { Point, PointArrays } from "../points.js";

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
 * The control points and segments of a spline, and what the classes of splines need to pass them to the core. The members
 * with an underscore are for the classes that extend this one, see `CurveValue`.
 *
 * @template D the dimension
 * @template C the class of the segments
 */
export class SplineValue<D extends 2 | 3 = 2 | 3, C extends CoreCurve<D> = CoreCurve<D>> {
  #data: SplineData;
  /** The segments that were asked for so far. */
  #segments: C[] = [];
  #index: SegmentIndex | undefined;

  /**
   * The spline of the given control points, with segments of one degree that share their end points.
   *
   * @param points n · degree + 1 control points, closed n · degree
   * @param options `degree`: of all segments, 3 by default; `closed`: whether the last segment ends at the first
   *   point, false by default; `dimension`: 2 or 3, how a flat array is read
   * @throws {RangeError} for a wrong number of points, a NaN or an infinity
   */
  constructor(points: PointArrays<D> | PointsLike, options?: { degree?: number; closed?: boolean; dimension?: D }) {
    if (!isShown) isShown = showInNode(SplineValue.prototype, "Spline", (value) => value.toJSON());
    const checked = points as unknown;
    if (checked instanceof CheckedSplineData) {
      this.#data = checked.data;
      return;
    }
    this.#data = checkedData(points, options);
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
  equals(other: SplineValue, tolerance = 0): boolean {
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
   * A segment. The class of each entry point implements it.
   *
   * @internal
   */
  _curveOf(flat: Float64Array): C {
    throw new TypeError(`expected a class that makes curves of ${flat.length} numbers`);
  }

  /**
   * A spline of the same class. The class of each entry point implements it.
   *
   * @internal
   */
  _splineOf(data: SplineData): this {
    throw new TypeError(`expected a class that makes splines of ${data.flat.length} numbers`);
  }

  /**
   * @internal
   * Writes the spline, and then further numbers, to the arena.
   * @returns the dimension
   */
  _write(further?: ArrayLike<number>): D {
    const { flat, dimension, degrees, closed } = this.#data;
    const head = 2 + degrees.length;
    const view = writeArguments(
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
   * @internal
   */
  _readPoint(): Point<D> {
    return pointAt(readResult(0, 3), 0, this.dimension);
  }

  /**
   * @internal
   */
  _coordinates(point: PointLike, name: string): Float64Array {
    const coordinates = new Float64Array(this.dimension);
    writePoint(coordinates, 0, point, this.dimension, name);
    return coordinates;
  }

  /**
   * @internal
   */
  _require2D(method: string) {
    check.require2D(method, "spline", this.dimension);
  }
}

/**
 * Data that is already checked: the constructor accepts it from inside the package.
 *
 * @internal
 */
export class CheckedSplineData {
  data: SplineData;

  constructor(data: SplineData) {
    this.data = data;
  }
}

function checkedData(points: PointsLike, options: SplineOptions | undefined): SplineData {
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
export function splineDataOf(json: SplineJSON): SplineData {
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
  return { flat, dimension, degrees, closed };
}

/**
 * Reads a spline from the arena.
 *
 * @internal
 */
export function readSplineData(length: number, dimension: 2 | 3): SplineData {
  const numbers = readResult(0, length);
  const head = 2 + numbers[0];
  return {
    flat: numbers.slice(head),
    dimension,
    degrees: [...numbers.subarray(2, head)],
    closed: numbers[1] === 1,
  };
}
