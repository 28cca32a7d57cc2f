// Circles, ellipses, arcs, rectangles and polygons as packed paths.
import * as check from "../check.js";
import { flatten, writePoint } from "../points.js";
import { arc, directionOfDegrees } from "../../io/svg-arc.js";
import { checkTolerance } from "../../io/svg-write.js";
import { PackedPathBuilder, packedSplines } from "../../wasm/packed-path.js";
import type { PointLike, PointsLike } from "../check.js";
import type { Pair } from "../../io/svg-arc.js";

/** How arcs are approximated. */
export interface ArcOptions {
  /**
   * The largest distance of the cubics from the arcs, by default 1e-5 of the larger radius. No cubic
   * covers more than a quarter turn, whatever the tolerance
   */
  tolerance?: number;
}

/** The corners of a rectangle, and how their arcs are approximated. */
export interface RectOptions {
  /**
   * The radius of all corners, or the four radii in the order of the corners on the path: (x, y), (x + width, y), (x +
   * width, y + height), (x, y + height). As in CSS, all are reduced by one factor if two do not fit on a side
   */
  radii?: number | ArrayLike<number>;
  /** The largest distance of the cubics from the arcs, as in `ArcOptions` */
  tolerance?: number;
}

/**
 * See `Path.circle`.
 *
 * @internal
 */
export function circle(center: PointLike, radius: number, options: ArcOptions | undefined): Float64Array {
  checkedLength(radius, "radius");
  return ellipse(center, radius, radius, 0, options);
}

/**
 * See `Path.ellipse`.
 *
 * @internal
 */
export function ellipse(
  center: PointLike,
  radiusX: number,
  radiusY: number,
  rotation: number | undefined = 0,
  options: ArcOptions | undefined = undefined,
): Float64Array {
  const [x, y] = checkedPoint(center, "center");
  checkedLength(radiusX, "radiusX");
  checkedLength(radiusY, "radiusY");
  const degrees = degreesOf(check.finite(rotation, "rotation"));
  const builder = new ShapeBuilder(check.options(options, ["tolerance"]).tolerance);
  const [cos, sin] = directionOfDegrees(degrees);
  const corner = (u: number, v: number) =>
    [x + (u * radiusX * cos - v * radiusY * sin), y + (u * radiusX * sin + v * radiusY * cos)] as Pair;
  builder.moveTo(corner(1, 0));
  for (const [u, v] of [
    [0, 1],
    [-1, 0],
    [0, -1],
    [1, 0],
  ])
    builder.arcTo(radiusX, radiusY, degrees, true, corner(u, v));
  return builder.packed(true);
}

/**
 * See `Path.arc`.
 *
 * @internal
 */
export function circularArc(
  center: PointLike,
  radius: number,
  startAngle: number,
  endAngle: number,
  options: ArcOptions | undefined,
): Float64Array {
  const [x, y] = checkedPoint(center, "center");
  checkedLength(radius, "radius");
  const [start, end] = [check.finite(startAngle, "startAngle"), check.finite(endAngle, "endAngle")];
  const turn = end - start;
  if (!(Math.abs(turn) <= 2 * Math.PI * (1 + Number.EPSILON))) {
    throw new RangeError(
      `endAngle: expected at most a full turn (2π) from startAngle (${start}), got ${end}; angles are in radians`,
    );
  }
  const at = (angle: number) => {
    const [cos, sin] = directionOfDegrees(degreesOf(angle));
    return [x + radius * cos, y + radius * sin] as Pair;
  };
  const builder = new ShapeBuilder(check.options(options, ["tolerance"]).tolerance);
  builder.moveTo(at(start));
  const parts = Math.max(1, Math.ceil(Math.abs(turn) / (Math.PI / 2) - ANGLE_ROUNDING));
  for (let k = 1; k <= parts; k++) {
    builder.arcTo(radius, radius, 0, turn > 0, at(k === parts ? end : start + (turn * k) / parts));
  }
  return builder.packed(false);
}

/** A rounded angle may exceed a number of quarter turns by this part of a quarter turn. */
const ANGLE_ROUNDING = 1e-12;

/**
 * See `Path.rect`.
 *
 * @internal
 */
export function rect(corner: PointLike, width: number, height: number, options: RectOptions | undefined): Float64Array {
  const [x, y] = checkedPoint(corner, "corner");
  checkedLength(width, "width");
  checkedLength(height, "height");
  const { radii: requested, tolerance } = check.options(options, ["radii", "tolerance"]);
  const radii = fittingRadii(cornerRadii(requested), width, height);
  const [right, top] = [x + width, y + height];
  const builder = new ShapeBuilder(tolerance);
  builder.moveTo([x + radii[0], y]);
  const roundCorner = (k: number, before: Pair, after: Pair) => {
    builder.lineTo(before);
    if (radii[k] > 0) builder.arcTo(radii[k], radii[k], 0, true, after);
  };
  roundCorner(1, [right - radii[1], y], [right, y + radii[1]]);
  roundCorner(2, [right, top - radii[2]], [right - radii[2], top]);
  roundCorner(3, [x + radii[3], top], [x, top - radii[3]]);
  roundCorner(0, [x, y + radii[0]], [x + radii[0], y]);
  return builder.packed(true);
}

function cornerRadii(radii: unknown = 0): number[] {
  if (typeof radii === "number") return new Array(4).fill(checkedLength(radii, "radii"));
  const list = [...check.numbers(radii, "radii")];
  if (list.length !== 4) throw new RangeError(`radii: expected a number or 4 numbers, got ${list.length} numbers`);
  return list.map((radius, k) => checkedLength(radius, `radii[${k}]`));
}

function fittingRadii(radii: number[], width: number, height: number): number[] {
  const sides = [width, height, width, height];
  const factors = sides.map((side, k) => {
    const sum = radii[k] + radii[(k + 1) % 4];
    return sum > side ? side / sum : 1;
  });
  const factor = Math.min(...factors);
  return radii.map((radius) => radius * factor);
}

/**
 * See `Path.polygon`.
 *
 * @internal
 */
export function polygon(points: PointsLike, options: { closed?: boolean } | undefined): Float64Array {
  const closed = check.optionalBoolean(check.options(options, ["closed"]).closed, "closed", true);
  const { flat } = flatten(points, 2, 2);
  const count = flat.length / 2;
  const min = closed ? 1 : 2;
  if (count < min) throw new RangeError(`points: expected at least ${min} points, got ${count}`);
  return packedSplines([{ flat, degrees: new Array(closed ? count : count - 1).fill(1), closed }]);
}

/** Builds one subpath of lines and elliptical arcs. */
class ShapeBuilder {
  #packer = new PackedPathBuilder();
  #tolerance;
  #x = 0;
  #y = 0;

  constructor(tolerance: number | undefined) {
    this.#tolerance = check.optionalTolerance(tolerance);
  }

  moveTo([x, y]: Pair) {
    this.#point(x, y);
  }

  /**
   * Adds a line, unless it would be a point but for rounding.
   *
   * @param point the point, in the unit of the points
   */
  lineTo([x, y]: Pair) {
    if (!isRounding(x, this.#x) || !isRounding(y, this.#y)) this.#line(x, y);
  }

  /**
   * Adds an arc, which is a line of length 0 if a radius is 0.
   *
   * @param point the point, in the unit of the points
   */
  arcTo(radiusX: number, radiusY: number, degrees: number, isCounterClockwise: boolean, [x, y]: Pair) {
    const numbers = Float64Array.of(radiusX, radiusY, degrees, 0, isCounterClockwise ? 1 : 0);
    const cubics = arc(this.#x, this.#y, numbers, x, y, this.#tolerance);
    if (!cubics) return this.#line(x, y);
    for (let k = 0; k < cubics.length; k += 2) {
      if (k % 6 === 0) this.#packer.degrees.push(3);
      this.#point(cubics[k], cubics[k + 1]);
    }
  }

  /**
   * The packed path of the subpath.
   *
   * @throws {RangeError} for coordinates that overflow, and a tolerance below their precision
   */
  packed(closed: boolean): Float64Array {
    if (this.#packer.degrees.length === 0) this.#line(this.#x, this.#y);
    this.#packer.endSubpath(closed);
    const packed = this.#packer.packed();
    const bad = packed.find((number) => !check.isCoordinate(number));
    if (bad !== undefined) throw new RangeError(`shape: expected coordinates from -2^500 to 2^500, got ${bad}`);
    checkTolerance(packed, this.#tolerance);
    return packed;
  }

  #line(x: number, y: number) {
    this.#packer.degrees.push(1);
    this.#point(x, y);
  }

  #point(x: number, y: number) {
    this.#packer.points.push(x);
    this.#packer.points.push(y);
    this.#x = x;
    this.#y = y;
  }
}

/** Whether two coordinates differ by rounding only. */
function isRounding(a: number, b: number) {
  return Math.abs(a - b) <= 4 * Number.EPSILON * Math.max(Math.abs(a), Math.abs(b));
}

function checkedPoint(point: PointLike, name: string): Pair {
  const coordinates = new Float64Array(2);
  writePoint(coordinates, 0, point, 2, name);
  return [coordinates[0], coordinates[1]];
}

/** A length: a finite number from 0. */
function checkedLength(value: unknown, name: string): number {
  const length = check.finite(value, name);
  if (length < 0) throw new RangeError(`${name}: expected a number from 0, got ${length}`);
  return length;
}

function degreesOf(radians: number) {
  return (radians * 180) / Math.PI; // exact for the multiples of π/2 that f64 rounds to
}
