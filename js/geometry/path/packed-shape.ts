// Curves, splines and paths of any entry point as packed paths. This file imports none of their classes, so that all of
// them can import it.
import { packedPath, splineData } from "../brand.js";
import { extents, packedSplines } from "../../wasm/packed-path.js";
import type { SplineData } from "../brand.js";

/**
 * The data of a spline that must be plane.
 *
 * @internal
 * @throws {TypeError} for a 3D spline
 */
export function require2D(data: SplineData, name: string): SplineData {
  if (data.dimension === 3) throw new TypeError(`${name}: expected a 2D one, got a 3D one`);
  return data;
}

/**
 * The data of a subpath.
 *
 * @internal
 */
export function checkedSplineData(spline: unknown, name: string, expected = "a Spline or a Curve"): SplineData {
  return require2D(splineData(spline, name, expected), name);
}

/**
 * The packed path of a curve, a spline or a path.
 *
 * @internal
 */
export function packedShape(shape: unknown, name: string): Float64Array {
  return packedPath(shape) ?? packedSplines([checkedSplineData(shape, name, "a Path, a Spline or a Curve")]);
}

/**
 * The subpaths as splines.
 *
 * @internal
 */
export function subpathsOf(packed: Float64Array): SplineData[] {
  return Array.from(extents(packed), ({ closed, degrees, points, end }) => ({
    flat: packed.slice(points, end),
    dimension: 2,
    degrees: [...packed.subarray(degrees, points)],
    closed,
  }));
}
