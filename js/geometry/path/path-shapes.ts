// Circles, ellipses, arcs, rectangles and polygons as packed paths.
import * as check from "../check.js";
import { flatten, writePoint } from "../points.js";
import { CommandBuilder } from "../../io/command-builder.js";
import { degreesOf, directionOfDegrees, quarterTurns } from "../../io/svg-arc.js";
import { checkTolerance } from "../../io/svg-write.js";
import { packedSplines } from "../../wasm/packed-path.js";
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
  check.nonNegative(radius, "radius");
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
  check.nonNegative(radiusX, "radiusX");
  check.nonNegative(radiusY, "radiusY");
  const degrees = degreesOf(check.finite(rotation, "rotation"));
  const { tolerance } = check.options(options, ["tolerance"]);
  const [cos, sin] = directionOfDegrees(degrees);
  const corner = (u: number, v: number) =>
    [x + (u * radiusX * cos - v * radiusY * sin), y + (u * radiusX * sin + v * radiusY * cos)] as Pair;
  const builder = startAt(corner(1, 0), tolerance);
  for (const [u, v] of [
    [0, 1],
    [-1, 0],
    [0, -1],
    [1, 0],
  ])
    arcTo(builder, [radiusX, radiusY], degrees, true, corner(u, v));
  return packedSubpath(builder, true);
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
  check.nonNegative(radius, "radius");
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
  const builder = startAt(at(start), check.options(options, ["tolerance"]).tolerance);
  const parts = Math.max(1, quarterTurns(turn));
  for (let k = 1; k <= parts; k++) {
    arcTo(builder, [radius, radius], 0, turn > 0, at(k === parts ? end : start + (turn * k) / parts));
  }
  return packedSubpath(builder, false);
}

/**
 * See `Path.rect`.
 *
 * @internal
 */
export function rect(corner: PointLike, width: number, height: number, options: RectOptions | undefined): Float64Array {
  const [x, y] = checkedPoint(corner, "corner");
  check.nonNegative(width, "width");
  check.nonNegative(height, "height");
  const { radii: requested, tolerance } = check.options(options, ["radii", "tolerance"]);
  const radii = fittingRadii(cornerRadii(requested), width, height);
  const [right, top] = [x + width, y + height];
  const builder = startAt([x + radii[0], y], tolerance);
  const roundCorner = (k: number, before: Pair, after: Pair) => {
    lineTo(builder, before);
    if (radii[k] > 0) arcTo(builder, [radii[k], radii[k]], 0, true, after);
  };
  roundCorner(1, [right - radii[1], y], [right, y + radii[1]]);
  roundCorner(2, [right, top - radii[2]], [right - radii[2], top]);
  roundCorner(3, [x + radii[3], top], [x, top - radii[3]]);
  roundCorner(0, [x, y + radii[0]], [x + radii[0], y]);
  return packedSubpath(builder, true);
}

function cornerRadii(radii: unknown = 0): number[] {
  if (typeof radii === "number") return new Array(4).fill(check.nonNegative(radii, "radii"));
  const list = [...check.numbers(radii, "radii")];
  if (list.length !== 4) throw new RangeError(`radii: expected a number or 4 numbers, got ${list.length} numbers`);
  return list.map((radius, k) => check.nonNegative(radius, `radii[${k}]`));
}

/**
 * The radii of the corners, reduced by one factor if two do not fit on a side.
 *
 * @internal
 */
export function fittingRadii(radii: number[], width: number, height: number): number[] {
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

/** A builder whose subpath starts at a point. */
function startAt([x, y]: Pair, tolerance: number | undefined): CommandBuilder {
  const builder = new CommandBuilder(check.optionalTolerance(tolerance));
  [builder.x, builder.y] = [x, y];
  return builder;
}

/** Adds a line, unless it would be a point but for rounding. */
function lineTo(builder: CommandBuilder, [x, y]: Pair) {
  if (!isRounding(x, builder.x) || !isRounding(y, builder.y)) builder.addLine(x, y);
}

/** Adds an arc, which is a line of length 0 if a radius is 0. */
function arcTo(builder: CommandBuilder, radii: Pair, degrees: number, isCounterClockwise: boolean, [x, y]: Pair) {
  builder.args.set([...radii, degrees, 0, isCounterClockwise ? 1 : 0]);
  builder.addArc(x, y);
}

/**
 * The packed path of the subpath.
 *
 * @throws {RangeError} for coordinates that overflow, and a tolerance below their precision
 */
function packedSubpath(builder: CommandBuilder, closed: boolean): Float64Array {
  if (!builder.drawing) builder.addLine(builder.x, builder.y);
  builder.end(closed);
  const packed = builder.packed();
  const bad = packed.find((number) => !check.isCoordinate(number));
  if (bad !== undefined) throw new RangeError(`shape: expected coordinates from -2^500 to 2^500, got ${bad}`);
  checkTolerance(packed, builder.tolerance);
  return packed;
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
