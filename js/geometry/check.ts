// Checks of arguments. The public functions check every argument once; after that, values have the right type, are
// finite and have matching counts.
import { describe, shorten } from "./describe.js";
import { similarName } from "./options.js";

export { describe } from "./describe.js";
export { optionalBoolean, options } from "./options.js";

/** A point: `[x, y]`, `[x, y, z]`, `{x, y}`, `{x, y, z}` or a DOMPoint. */
export type PointLike = ArrayLike<number> | { x: number; y: number; z?: number };

/** Points, one by one or as one flat array of coordinates. */
export type PointsLike = ArrayLike<number> | ArrayLike<PointLike>;

/**
 * An affine map: `[a, b, c, d, e, f]` in SVG order, an object with these six members, 16 numbers column-major, a
 * DOMMatrix, or an object with `elements`, 16 numbers column-major (a Matrix4 of three.js).
 */
export type MatrixLike =
  | ArrayLike<number>
  | { a: number; b: number; c: number; d: number; e: number; f: number }
  | { toFloat64Array(): Float64Array }
  | { elements: ArrayLike<number> };

/**
 * An affine map as a matrix or as a text: functions of the SVG attribute `transform`, such as "translate(50 50)
 * rotate(30)". The last function is applied first; angles are degrees unless they have a unit of CSS.
 */
export type TransformLike = MatrixLike | string;

/** The type of a map that is a list of a known length: never if that is neither 6 nor 16. */
export type Complete<M> = M extends readonly number[]
  ? number extends M["length"]
    ? M
    : M["length"] extends 6 | 16
      ? M
      : never
  : M;

/** The largest absolute value of a coordinate; src/geometry/check.rs explains it. @internal */
export const MAX_COORDINATE = 2 ** 500;

/** Results of operations on the largest coordinates may exceed the limit by rounding. */
const MAX_ACCEPTED = MAX_COORDINATE * (1 + 1e-9);

/**
 * Whether a number can be a coordinate.
 *
 * @internal
 */
export function isCoordinate(value: number) {
  return Math.abs(value) <= MAX_ACCEPTED;
}

/**
 * A coordinate: a number from -2^500 to 2^500.
 *
 * @internal
 */
export function coordinate(value: unknown, name: string): number {
  const number = finite(value, name);
  if (isCoordinate(number)) return number;
  throw new RangeError(`${name}: expected a coordinate from -2^500 to 2^500 (3.27e150), got ${number}`);
}

/** A finite number. */
export function finite(value: unknown, name: string): number {
  if (typeof value !== "number") throw new TypeError(`${name}: expected a number, got ${describe(value)}`);
  if (!Number.isFinite(value)) throw new RangeError(`${name}: expected a finite number, got ${value}`);
  return value;
}

/** A finite number from 0. */
export function nonNegative(value: unknown, name: string): number {
  const number = finite(value, name);
  if (number < 0) throw new RangeError(`${name}: expected a number from 0, got ${number}`);
  return number;
}

/** A finite number greater than 0. */
export function positive(value: unknown, name: string): number {
  const number = finite(value, name);
  if (number <= 0) throw new RangeError(`${name}: expected a number above 0, got ${number}`);
  return number;
}

/** A tolerance; 0 stands for the default. */
export function optionalTolerance(value: unknown): number {
  return value === undefined ? 0 : positive(value, "tolerance");
}

/** An integer in a range. */
export function whole(value: unknown, name: string, min: number, max: number = Infinity): number {
  if (typeof value !== "number") throw new TypeError(`${name}: expected a whole number, got ${describe(value)}`);
  if (!Number.isInteger(value) || value < min || value > max) {
    const range = max === Infinity ? `from ${min}` : `from ${min} to ${max}`;
    throw new RangeError(`${name}: expected a whole number ${range}, got ${value}`);
  }
  return value;
}

/** The largest count that can be passed to the core, 2³² − 1; the core has lower limits of its own. */
const MAX_COUNT = 0xffffffff;

/** A number of segments. */
export function segmentCount(value: unknown, name = "segments"): number {
  return whole(value, name, 1, MAX_COUNT);
}

/** One of several strings. */
export function oneOf<T extends string>(value: unknown, name: string, words: readonly T[]): T {
  const found = words.find((word) => word === value);
  if (found !== undefined) return found;
  const list = words.map((word) => JSON.stringify(word)).join(", ");
  const message = `${name}: expected one of ${list}, got ${describe(value)}`;
  if (typeof value !== "string") throw new TypeError(message);
  const similar = value && similarName(shorten(value), words, 0.4);
  throw new RangeError(similar ? `${message}; did you mean "${similar}"?` : message);
}

/** An object whose keys are not a fixed list of options; undefined and null count as an empty one. */
export function object<T extends object>(value: T | undefined, name: string): Partial<T> {
  if (value === undefined || value === null) return {};
  if (typeof value !== "object") throw new TypeError(`${name}: expected an object, got ${describe(value)}`);
  return value;
}

/**
 * An instance of a class.
 *
 * @param expected the class in messages, with its article
 */
export function instanceOf<T>(value: unknown, name: string, type: new (...args: any[]) => T, expected: string): T {
  if (value instanceof type) return value;
  throw new TypeError(`${name}: expected ${expected}, got ${describe(value)}`);
}

/** A dimension option. */
export function optionalDimension(value: unknown): 2 | 3 | undefined {
  if (value === undefined || value === 2 || value === 3) return value;
  if (typeof value !== "number") throw new TypeError(`dimension: expected 2 or 3, got ${describe(value)}`);
  throw new RangeError(`dimension: expected 2 or 3, got ${value}`);
}

/** Whether a value holds numbers or points by index: an array or a typed array. */
export function isList(value: unknown): value is ArrayLike<unknown> {
  return Array.isArray(value) || (ArrayBuffer.isView(value) && !(value instanceof DataView));
}

/** An array of finite numbers, copied. */
export function numbers(value: unknown, name: string): Float64Array {
  if (!isList(value)) throw new TypeError(`${name}: expected an array of numbers, got ${describe(value)}`);
  const copy = new Float64Array(value.length);
  for (let i = 0; i < copy.length; i++) copy[i] = finite(value[i], `${name}[${i}]`);
  return copy;
}

/**
 * The numbers of a matrix.
 *
 * @param counts how many there may be
 */
export function matrixNumbers(matrix: MatrixLike, name = "matrix", counts = [6, 16]): Float64Array {
  if (isList(matrix)) return matrixOf(matrix, name, counts);
  const { elements, toFloat64Array } = (matrix ?? {}) as { elements?: unknown; toFloat64Array?: unknown };
  if (isList(elements)) return matrixOf(elements, `${name}.elements`, counts.slice(1));
  if (typeof toFloat64Array === "function") return matrixOf(toFloat64Array.call(matrix), name, [16]);
  const members = Object(matrix ?? {}) as Record<string, unknown>;
  if ("a" in members) return Float64Array.from("abcdef", (key) => finite(members[key], `${name}.${key}`));
  const forms = `${counts.join(" or ")} numbers, a DOMMatrix or an object with elements`;
  throw new TypeError(`${name}: expected ${forms}, got ${describe(matrix)}`);
}

function matrixOf(list: unknown, name: string, lengths: number[]): Float64Array {
  const m = numbers(list, name);
  if (lengths.includes(m.length)) return m;
  throw new RangeError(`${name}: expected ${lengths.join(" or ")} numbers, got ${m.length}`);
}

/** The array for results: the caller's array, or a new one. */
export function resultArray(into: unknown, length: number): Float64Array {
  if (into === undefined) return new Float64Array(length);
  if (!(into instanceof Float64Array)) throw new TypeError(`into: expected a Float64Array, got ${describe(into)}`);
  if (into.length < length) throw new RangeError(`into: expected at least ${length} numbers, got ${into.length}`);
  return into;
}

/** The target of `trace`: a 2D context or a Path2D. */
export function drawingTarget(value: unknown): CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D | Path2D {
  const methods = ["moveTo", "lineTo", "quadraticCurveTo", "bezierCurveTo", "closePath"];
  const target = value as Record<string, unknown> | null;
  if (typeof target === "object" && target !== null && methods.every((name) => typeof target[name] === "function")) {
    return value as any;
  }
  throw new TypeError(`target: expected a CanvasRenderingContext2D or a Path2D, got ${describe(value)}`);
}

/**
 * Throws a TypeError in 3D.
 *
 * @param what "curve" or "spline"
 */
export function require2D(method: string, what: string, dimension: 2 | 3) {
  if (dimension === 3) throw new TypeError(`${method}: expected a 2D ${what}, got a 3D one`);
}
