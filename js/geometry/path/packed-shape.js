// Curves, splines and paths of any entry point as packed paths. This file imports none of their classes, so that all of
// them can import it.
import { packedPath, splineData } from "../brand.js";
import { packedSplines } from "../../wasm/packed-path.js";

/**
 * @import { SplineData } from "../brand.js"
 */

/**
 * @internal
 * @param {SplineData} data
 * @param {string} name
 * @returns {SplineData}
 * @throws {TypeError} for a 3D spline
 */
export function require2D(data, name) {
  if (data.dimension === 3) throw new TypeError(`${name}: expected a 2D one, got a 3D one`);
  return data;
}

/**
 * The data of a subpath.
 *
 * @internal
 * @param {unknown} spline
 * @param {string} name
 * @param {string} [expected]
 * @returns {SplineData}
 */
export function checkedSplineData(spline, name, expected = "a Spline or a Curve") {
  return require2D(splineData(spline, name, expected), name);
}

/**
 * The packed path of a curve, a spline or a path.
 *
 * @internal
 * @param {unknown} shape
 * @param {string} name
 * @returns {Float64Array}
 */
export function packedShape(shape, name) {
  return packedPath(shape) ?? packedSplines([checkedSplineData(shape, name, "a Path, a Spline or a Curve")]);
}
