// The segments of a path at a location, and parts of a path, for the queries of `CorePath`.
import * as check from "../check.js";
import type { SplineData } from "../brand.js";
import type { CoreCurve } from "../curve/core-curve.js";
import type { PathTime } from "./path-queries.js";
import type { CorePath } from "./core-path.js";

/**
 * A checked copy of a location.
 *
 * @internal
 * @throws {TypeError} for a value that is not an object
 * @throws {RangeError} for a subpath that does not exist, and a t that is not finite
 */
export function checkedLocation(path: CorePath, location: unknown, name = "location"): PathTime {
  if (typeof location !== "object" || location === null) {
    throw new TypeError(`${name}: expected an object {subpath, t}, got ${check.describe(location)}`);
  }
  const { subpath, t } = location as { subpath?: unknown; t?: unknown };
  if (path.subpathCount === 0) throw new RangeError(`${name}: expected a path with a subpath, got an empty path`);
  return {
    subpath: check.whole(subpath, `${name}.subpath`, 0, path.subpathCount - 1),
    t: check.finite(t, `${name}.t`),
  };
}

/**
 * The index of the segment that contains t, and the parameter on it: at a joint the segment that starts there, at the
 * end the last segment. The first and the last segment are extrapolated.
 *
 * @param count the number of segments
 */
function locate(count: number, t: number): [number, number] {
  const segment = Math.min(Math.max(Math.floor(t), 0), count - 1);
  return [segment, t - segment];
}

/**
 * The segment at a location, and the parameter on it.
 *
 * @internal
 */
export function segmentAt(path: CorePath, location: PathTime): [CoreCurve<2>, number] {
  const { subpath, t } = checkedLocation(path, location);
  const segments = path._segments(subpath);
  const [segment, rest] = locate(segments.length, t);
  return [segments[segment], rest];
}

/** The part of a chain of segments from t0 to t1, t0 <= t1, as a chain of segments. */
function forwardPart(segments: readonly CoreCurve[], t0: number, t1: number): CoreCurve[] {
  const [first, from] = locate(segments.length, t0);
  let [last, to] = locate(segments.length, t1);
  if (to === 0 && last > first) [last, to] = [last - 1, 1];
  if (first === last) return [segments[first].subsegment(from, to)];
  const start = from === 0 ? segments[first] : segments[first].subsegment(from, 1);
  const end = to === 1 ? segments[last] : segments[last].subsegment(0, to);
  return [start, ...segments.slice(first + 1, last), end];
}

/** The open spline of consecutive curves. */
function join(curves: CoreCurve[]): SplineData {
  const degrees = curves.map(({ degree }) => degree);
  const flat = new Float64Array(2 * degrees.reduce((sum, degree) => sum + degree, 1));
  let at = 0;
  for (const curve of curves) {
    flat.set(curve._flat, at); // the first point of a curve replaces the last one of the previous curve
    at += 2 * curve.degree;
  }
  return { flat, dimension: 2, degrees, closed: false };
}

/**
 * The part of a subpath from t0 to t1, reversed if t0 > t1. The whole subpath is returned unchanged, and therefore
 * closed if it is closed.
 */
function partOfSubpath(path: CorePath, subpath: number, t0: number, t1: number): SplineData {
  const segments = path._segments(subpath);
  if (t0 === 0 && t1 === segments.length) return path.subpaths[subpath].casteljauData();
  if (t0 <= t1) return join(forwardPart(segments, t0, t1));
  return join(
    forwardPart(segments, t1, t0)
      .reverse()
      .map((curve) => curve.reverse()),
  );
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
 * The subpaths between two locations in order; parts with t0 = t1 are omitted.
 *
 * @internal
 * @param to not before `from`
 */
export function partsBetween(path: CorePath, from: PathTime, to: PathTime): SplineData[] {
  const parts: SplineData[] = [];
  for (let k = from.subpath; k <= to.subpath; k++) {
    const t0 = k === from.subpath ? from.t : 0;
    const t1 = k === to.subpath ? to.t : path._segments(k).length;
    if (t0 !== t1) parts.push(partOfSubpath(path, k, t0, t1));
  }
  return parts;
}

/**
 * The point at a location as a subpath of one segment.
 *
 * @internal
 */
export function pointAsSubpath(path: CorePath, { subpath, t }: PathTime): SplineData {
  return join(forwardPart(path._segments(subpath), t, t));
}
