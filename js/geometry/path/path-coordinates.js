// Locations on a path where a coordinate has a given value or an extremum.
import { requestedCoordinate } from "../curve-queries.js";

/**
 * @import { PathTime } from "./path-queries.js"
 * @import { PathValue } from "./path-value.js"
 */

/**
 * The locations where a coordinate has a local extremum.
 *
 * @typedef {{ x: PathTime[], y: PathTime[] }} PathExtrema
 */

/**
 * @internal
 * @param {PathValue} path
 * @returns {PathExtrema}
 */
export function extremaOfPath(path) {
  const extrema = path.subpaths.map((spline) => spline.extrema());
  const locations = (/** @type {"x" | "y"} */ axis) =>
    extrema.flatMap((found, subpath) => Array.from(found[axis], (t) => ({ subpath, t })));
  return { x: locations("x"), y: locations("y") };
}

/**
 * @internal
 * @param {PathValue} path
 * @param {{ x: number } | { y: number }} where
 * @returns {PathTime[]}
 */
export function timesAtCoordinateOfPath(path, where) {
  requestedCoordinate(where, 2); // checked for an empty path too
  return path.subpaths.flatMap((spline, subpath) =>
    Array.from(spline.timesAtCoordinate(where), (t) => ({ subpath, t })),
  );
}
