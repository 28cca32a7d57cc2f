// How curves, splines, paths, patches and surfaces of one copy of this package are recognised by another copy: each entry point
// is a bundle with its own classes, so that `instanceof` does not answer that question. All of them have the two members
// of `Branded`, whose names are strings because bundlers keep an unused class that has a computed name.
import { describe } from "./describe.js";

/**
 * The data of a spline: its control points (joints once), the degree of each segment, whether it is closed.
 *
 * @internal
 * @typedef {{ flat: Float64Array, dimension: 2 | 3, degrees: readonly number[], closed: boolean }} SplineData
 */

/**
 * The data of a patch: its net and its degrees.
 *
 * @internal
 * @typedef {{ flat: Float64Array, degreeU: number, degreeV: number }} PatchData
 */

/**
 * @internal
 * @typedef {"curve" | "spline" | "path" | "patch" | "surface" | "mesh"} BrandedType
 */

/**
 * @internal
 * @template T
 * @typedef {{ readonly casteljauType: BrandedType, casteljauData(): T }} Branded
 */

/**
 * @internal
 * @param {unknown} value
 * @returns {BrandedType | undefined} undefined for any other value
 */
export function typeOf(value) {
  return /** @type {Partial<Branded<unknown>> | null | undefined} */ (value)?.casteljauType;
}

/**
 * @internal
 * @param {unknown} value
 * @param {string} name
 * @returns {SplineData}
 * @throws {TypeError} for anything but a curve
 */
export function curveData(value, name) {
  return dataOf(value, name, typeOf(value) === "curve", "a Curve");
}

/**
 * The data of a spline, or of a curve as a spline of one segment.
 *
 * @internal
 * @param {unknown} value
 * @param {string} name
 * @param {string} [expected]
 * @returns {SplineData}
 * @throws {TypeError} for anything else
 */
export function splineData(value, name, expected = "a Curve or a Spline") {
  const type = typeOf(value);
  return dataOf(value, name, type === "curve" || type === "spline", expected);
}

/**
 * @internal
 * @param {unknown} value
 * @param {string} name
 * @returns {SplineData}
 * @throws {TypeError} for anything but a spline
 */
export function onlySplineData(value, name) {
  return dataOf(value, name, typeOf(value) === "spline", "a Spline");
}

/**
 * @internal
 * @param {unknown} value
 * @param {string} name
 * @returns {Float64Array} see `packed-path.js`
 * @throws {TypeError} for anything but a path
 */
export function pathData(value, name) {
  return dataOf(value, name, typeOf(value) === "path", "a Path");
}

/**
 * @internal
 * @param {unknown} value
 * @param {string} name
 * @returns {PatchData}
 * @throws {TypeError} for anything but a patch
 */
export function patchData(value, name) {
  return dataOf(value, name, typeOf(value) === "patch", "a Patch");
}

/**
 * The packed path of a path.
 *
 * @internal
 * @param {unknown} value
 * @returns {Float64Array | undefined} undefined for any other value
 */
export function packedPath(value) {
  return typeOf(value) === "path" ? /** @type {Branded<Float64Array>} */ (value).casteljauData() : undefined;
}

/**
 * @template T
 * @param {unknown} value
 * @param {string} name
 * @param {boolean} isExpected
 * @param {string} expected
 * @returns {T}
 */
function dataOf(value, name, isExpected, expected) {
  if (isExpected) return /** @type {Branded<T>} */ (value).casteljauData();
  throw new TypeError(`${name}: expected ${expected}, got ${describe(value)}`);
}
