// Boxes, points, and chains of cubics.
import { Spline } from "../geometry/spline/spline.js";
import { finiteNumber, kindOf } from "./check.js";

/** The view box; coordinates are in its units, y down */
export type Box = { width: number; height: number };

/** A further cubic shares its first point with the last one before it. */
export const POINTS_PER_SEGMENT = 3;

/** The canvas of the web lesson; used where the canvas states no size of its own. */
export const DEFAULT_BOX: Box = { width: 670, height: 480 };

/** Two cubics. P2, P3 and P4 lie on one line, but P3 is not half-way: G1 and not C1. */
const FIRST_POINTS = [
  [70, 330],
  [110, 90],
  [235, 120],
  [325, 230],
  [433, 362],
  [590, 400],
  [600, 130],
];

/** The two cubics of the web lesson, in a box of any size. */
export function firstPoints(box: Box): [number, number][] {
  const [sx, sy] = [box.width / DEFAULT_BOX.width, box.height / DEFAULT_BOX.height];
  return FIRST_POINTS.map(([x, y]) => [x * sx, y * sy]);
}

export function cubics(points: ArrayLike<number>[]): Spline {
  return new Spline(
    points.map((point) => Array.from(point)),
    { degree: 3, dimension: 2 },
  );
}

export function pairs(flat: ArrayLike<number>): [number, number][] {
  return Array.from({ length: flat.length / 2 }, (_, i) => [flat[2 * i], flat[2 * i + 1]]);
}

/** The nearest place inside the view box. */
export function clamped(
  { x = 0, y = 0, width, height }: Box & { x?: number; y?: number },
  point: ArrayLike<number>,
): [number, number] {
  return [Math.min(Math.max(point[0], x), x + width), Math.min(Math.max(point[1], y), y + height)];
}

export function isInside({ width, height }: Box, point: ArrayLike<number>): boolean {
  return point[0] >= 0 && point[0] <= width && point[1] >= 0 && point[1] <= height;
}

export function pointPair(value: unknown, name: string): [number, number] {
  const { 0: x, 1: y, length } = (isList(value) ? value : []) as ArrayLike<unknown>;
  if (length !== 2) throw new TypeError(`${name}: expected [x, y], got ${kindOf(value)}`);
  return [finiteNumber(x, `x of ${name}`, "a finite number"), finiteNumber(y, `y of ${name}`, "a finite number")];
}

/** Chains of cubics only: 4, 7, 10 … points. */
export function pointsArray(value: unknown): [number, number][] {
  if (!Array.isArray(value)) {
    throw new TypeError(`points: expected an array of [x, y], got ${kindOf(value)}`);
  }
  if (value.length < 4 || value.length % 3 !== 1) {
    throw new RangeError(`points: expected 4, 7, 10 … points (3n + 1), got ${value.length}`);
  }
  return Array.from(value, (point, i) => pointPair(point, `points[${i}]`));
}

function isList(value: unknown): boolean {
  return Array.isArray(value) || (ArrayBuffer.isView(value) && "length" in value);
}
