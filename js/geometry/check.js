// Checks of arguments. The public functions check every argument once; after that, values have the right type, are
// finite and have matching counts.
import { describe } from "./describe.js";

export { describe } from "./describe.js";
export { noSurplus, optionalBoolean, options } from "./options.js";

/**
 * A point: `[x, y]`, `[x, y, z]`, `{x, y}`, `{x, y, z}` or a DOMPoint.
 *
 * @typedef {ArrayLike<number> | { x: number, y: number, z?: number }} PointLike
 */

/**
 * Points, one by one or as one flat array of coordinates.
 *
 * @typedef {ArrayLike<number> | ArrayLike<PointLike>} PointsLike
 */

/**
 * An affine map: `[a, b, c, d, e, f]` in SVG order, an object with these six members, 16 numbers column-major, a
 * DOMMatrix, or an object with `elements`, 16 numbers column-major (a Matrix4 of three.js).
 *
 * @typedef {ArrayLike<number> | { a: number, b: number, c: number, d: number, e: number, f: number } | { toFloat64Array(): Float64Array } | { elements: ArrayLike<number> }} MatrixLike
 */

/**
 * An affine map as a matrix or as a text: functions of the SVG attribute `transform`, such as "translate(50 50)
 * rotate(30)". The last function is applied first; angles are degrees unless they have a unit of CSS.
 *
 * @typedef {MatrixLike | string} TransformLike
 */

/** The largest absolute value of a coordinate; src/geometry/check.rs explains it. @internal */
export const MAX_COORDINATE = 2 ** 500;

/** Results of operations on the largest coordinates may exceed the limit by rounding. */
const MAX_ACCEPTED = MAX_COORDINATE * (1 + 1e-9);

/**
 * Whether a number can be a coordinate.
 *
 * @internal
 * @param {number} value
 */
export function isCoordinate(value) {
  return Math.abs(value) <= MAX_ACCEPTED;
}

/**
 * A coordinate: a number from -2^500 to 2^500.
 *
 * @internal
 * @param {unknown} value
 * @param {string} name
 * @returns {number}
 */
export function coordinate(value, name) {
  const number = finite(value, name);
  if (isCoordinate(number)) return number;
  throw new RangeError(`${name}: expected a coordinate from -2^500 to 2^500 (3.27e150), got ${number}`);
}

/**
 * A finite number.
 *
 * @param {unknown} value
 * @param {string} name
 * @returns {number}
 */
export function finite(value, name) {
  if (typeof value !== "number") throw new TypeError(`${name}: expected a number, got ${describe(value)}`);
  if (!Number.isFinite(value)) throw new RangeError(`${name}: expected a finite number, got ${value}`);
  return value;
}

/**
 * A finite number greater than 0.
 *
 * @param {unknown} value
 * @param {string} name
 * @returns {number}
 */
export function positive(value, name) {
  const number = finite(value, name);
  if (number <= 0) throw new RangeError(`${name}: expected a number above 0, got ${number}`);
  return number;
}

/**
 * A tolerance; 0 stands for the default.
 *
 * @param {unknown} value
 * @returns {number}
 */
export function optionalTolerance(value) {
  return value === undefined ? 0 : positive(value, "tolerance");
}

/**
 * An integer in a range.
 *
 * @param {unknown} value
 * @param {string} name
 * @param {number} min
 * @param {number} [max]
 * @returns {number}
 */
export function whole(value, name, min, max = Infinity) {
  if (typeof value !== "number") throw new TypeError(`${name}: expected a whole number, got ${describe(value)}`);
  if (!Number.isInteger(value) || value < min || value > max) {
    const range = max === Infinity ? `from ${min}` : `from ${min} to ${max}`;
    throw new RangeError(`${name}: expected a whole number ${range}, got ${value}`);
  }
  return value;
}

/** The largest count that can be passed to the core, 2³² − 1; the core has lower limits of its own. */
const MAX_COUNT = 0xffffffff;

/**
 * A number of segments.
 *
 * @param {unknown} value
 * @param {string} [name]
 * @returns {number}
 */
export function segmentCount(value, name = "segments") {
  return whole(value, name, 1, MAX_COUNT);
}

/**
 * One of several strings.
 *
 * @template {string} T
 * @param {unknown} value
 * @param {string} name
 * @param {readonly T[]} words
 * @returns {T}
 */
export function oneOf(value, name, words) {
  const found = words.find((word) => word === value);
  if (found !== undefined) return found;
  const list = words.map((word) => JSON.stringify(word)).join(", ");
  const message = `${name}: expected one of ${list}, got ${describe(value)}`;
  throw typeof value === "string" ? new RangeError(message) : new TypeError(message);
}

/**
 * An object whose keys are not a fixed list of options; undefined and null count as an empty one.
 *
 * @template {object} T
 * @param {T | undefined} value
 * @param {string} name
 * @returns {Partial<T>}
 */
export function object(value, name) {
  if (value === undefined || value === null) return {};
  if (typeof value !== "object") throw new TypeError(`${name}: expected an object, got ${describe(value)}`);
  return value;
}

/**
 * An instance of a class.
 *
 * @template T
 * @param {unknown} value
 * @param {string} name
 * @param {new (...args: any[]) => T} type
 * @param {string} expected the class in messages, with its article
 * @returns {T}
 */
export function instanceOf(value, name, type, expected) {
  if (value instanceof type) return value;
  throw new TypeError(`${name}: expected ${expected}, got ${describe(value)}`);
}

/**
 * A dimension option.
 *
 * @param {unknown} value
 * @returns {2 | 3 | undefined}
 */
export function optionalDimension(value) {
  if (value === undefined || value === 2 || value === 3) return value;
  if (typeof value !== "number") throw new TypeError(`dimension: expected 2 or 3, got ${describe(value)}`);
  throw new RangeError(`dimension: expected 2 or 3, got ${value}`);
}

/**
 * Whether a value holds numbers or points by index: an array or a typed array.
 *
 * @param {unknown} value
 * @returns {value is ArrayLike<unknown>}
 */
export function isList(value) {
  return Array.isArray(value) || (ArrayBuffer.isView(value) && !(value instanceof DataView));
}

/**
 * An array of finite numbers, copied.
 *
 * @param {unknown} value
 * @param {string} name
 * @returns {Float64Array}
 */
export function numbers(value, name) {
  if (!isList(value)) throw new TypeError(`${name}: expected an array of numbers, got ${describe(value)}`);
  const copy = new Float64Array(value.length);
  for (let i = 0; i < copy.length; i++) copy[i] = finite(value[i], `${name}[${i}]`);
  return copy;
}

/**
 * The 6 or 16 numbers of a matrix.
 *
 * @param {MatrixLike} matrix
 * @param {string} [name]
 * @returns {Float64Array}
 */
export function matrixNumbers(matrix, name = "matrix") {
  if (isList(matrix)) return matrixOf(matrix, name, [6, 16]);
  const { elements, toFloat64Array } = /** @type {{ elements?: unknown, toFloat64Array?: unknown }} */ (matrix ?? {});
  if (isList(elements)) return matrixOf(elements, `${name}.elements`, [16]);
  if (typeof toFloat64Array === "function") return matrixOf(toFloat64Array.call(matrix), name, [16]);
  const members = /** @type {Record<string, unknown>} */ (Object(matrix ?? {}));
  if ("a" in members) return Float64Array.from("abcdef", (key) => finite(members[key], `${name}.${key}`));
  const forms = "6 or 16 numbers, a DOMMatrix or an object with elements";
  throw new TypeError(`${name}: expected ${forms}, got ${describe(matrix)}`);
}

/**
 * @param {unknown} list
 * @param {string} name
 * @param {number[]} lengths
 * @returns {Float64Array}
 */
function matrixOf(list, name, lengths) {
  const m = numbers(list, name);
  if (lengths.includes(m.length)) return m;
  throw new RangeError(`${name}: expected ${lengths.join(" or ")} numbers, got ${m.length}`);
}

/**
 * The array for results: the caller's array, or a new one.
 *
 * @param {unknown} into
 * @param {number} length
 * @returns {Float64Array}
 */
export function resultArray(into, length) {
  if (into === undefined) return new Float64Array(length);
  if (!(into instanceof Float64Array)) throw new TypeError(`into: expected a Float64Array, got ${describe(into)}`);
  if (into.length < length) throw new RangeError(`into: expected at least ${length} numbers, got ${into.length}`);
  return into;
}

/**
 * The target of `trace`: a 2D context or a Path2D.
 *
 * @param {unknown} value
 * @returns {CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D | Path2D}
 */
export function drawingTarget(value) {
  const methods = ["moveTo", "lineTo", "quadraticCurveTo", "bezierCurveTo", "closePath"];
  const target = /** @type {Record<string, unknown> | null} */ (value);
  if (typeof target === "object" && target !== null && methods.every((name) => typeof target[name] === "function")) {
    return /** @type {any} */ (value);
  }
  throw new TypeError(`target: expected a CanvasRenderingContext2D or a Path2D, got ${describe(value)}`);
}

/**
 * Throws a TypeError in 3D.
 *
 * @param {string} method
 * @param {string} what "curve" or "spline"
 * @param {2 | 3} dimension
 */
export function require2D(method, what, dimension) {
  if (dimension === 3) throw new TypeError(`${method}: expected a 2D ${what}, got a 3D one`);
}
