// The segments of a path at a location, and parts of a path, for the queries of `CorePath`.
import * as check from "../check.js";
import type { SplineData } from "../brand.js";
import type { CoreCurve } from "../curve/core-curve.js";
import type { CoreSpline } from "../spline/core-spline.js";
import type { PathTime } from "./path-queries.js";

/**
 * A checked copy of a location.
 *
 * @internal
 * @param count the number of subpaths
 * @throws {TypeError} for a value that is not an object
 * @throws {RangeError} for a subpath that does not exist, and a t that is not finite
 */
export function checkedLocation(count: number, location: unknown, name = "location"): PathTime {
  if (typeof location !== "object" || location === null) {
    throw new TypeError(`${name}: expected an object {subpath, t}, got ${check.describe(location)}`);
  }
  const { subpath, t } = location as { subpath?: unknown; t?: unknown };
  if (count === 0) throw new RangeError(`${name}: expected a path with a subpath, got an empty path`);
  return {
    subpath: check.whole(subpath, `${name}.subpath`, 0, count - 1),
    t: check.finite(t, `${name}.t`),
  };
}

/**
 * The segment that contains t, and the parameter on it: at a joint the segment that starts there, at the end the last
 * segment. The first and the last segment are extrapolated.
 *
 * @internal
 */
export function segmentAt(segments: readonly CoreCurve<2>[], t: number): [CoreCurve<2>, number] {
  const segment = Math.min(Math.max(Math.floor(t), 0), segments.length - 1);
  return [segments[segment], t - segment];
}

/**
 * Whether the first location is after the second one.
 *
 * @internal
 */
export function isAfter(a: PathTime, b: PathTime) {
  return a.subpath > b.subpath || (a.subpath === b.subpath && a.t > b.t);
}

/**
 * The subpaths between two locations in order; parts with t0 = t1 are omitted. A whole subpath is closed if it is closed in the path.
 *
 * @internal
 * @param to not before `from`
 */
export function partsBetween(subpaths: readonly CoreSpline<2>[], from: PathTime, to: PathTime): SplineData[] {
  const parts: SplineData[] = [];
  for (let k = from.subpath; k <= to.subpath; k++) {
    const subpath = subpaths[k];
    const t0 = k === from.subpath ? from.t : 0;
    const t1 = k === to.subpath ? to.t : subpath.segmentCount;
    const isWhole = t0 === 0 && t1 === subpath.segmentCount;
    if (t0 !== t1) parts.push((isWhole ? subpath : subpath.subsegment(t0, t1)).casteljauData());
  }
  return parts;
}
