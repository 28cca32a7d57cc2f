// Locations on a path where a coordinate has a given value or an extremum.
import { requestedCoordinate } from "../curve-queries.js";
import type { Extrema } from "../curve-queries.js";
import type { PathTime } from "./path-queries.js";

/** What is asked of each subpath. */
interface Subpath {
  extrema: () => Extrema;
  timesAtCoordinate: (where: { x: number } | { y: number }) => Float64Array;
}

/** The locations where a coordinate has a local extremum. */
export type PathExtrema = { x: PathTime[]; y: PathTime[] };

/**
 * See `Path.extrema`.
 *
 * @internal
 */
export function extremaOfPath(subpaths: readonly Subpath[]): PathExtrema {
  const extrema = subpaths.map((spline) => spline.extrema());
  const locations = (axis: "x" | "y") =>
    extrema.flatMap((found, subpath) => Array.from(found[axis], (t) => ({ subpath, t })));
  return { x: locations("x"), y: locations("y") };
}

/**
 * See `Path.timesAtCoordinate`.
 *
 * @internal
 */
export function timesAtCoordinateOfPath(
  subpaths: readonly Subpath[],
  where: { x: number } | { y: number },
): PathTime[] {
  requestedCoordinate(where, 2); // checked for an empty path too
  return subpaths.flatMap((spline, subpath) => Array.from(spline.timesAtCoordinate(where), (t) => ({ subpath, t })));
}
