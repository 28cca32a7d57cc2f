// The segments of a path at a location, and parts of a path, for the queries of `PathEvaluation`.
import * as check from "../check.js";

/**
 * @import { SplineData } from "../brand.js"
 * @import { Curve } from "../curve/curve.js"
 * @import { PathTime } from "./path-queries.js"
 * @import { PathValue } from "./path-value.js"
 */

/**
 * A checked copy of a location.
 *
 * @internal
 * @param {PathValue} path
 * @param {unknown} location
 * @param {string} [name]
 * @returns {PathTime}
 * @throws {TypeError} for a value that is not an object
 * @throws {RangeError} for a subpath that does not exist, and a t that is not finite
 */
export function checkedLocation(path, location, name = "location") {
  if (typeof location !== "object" || location === null) {
    throw new TypeError(`${name}: expected an object {subpath, t}, got ${check.describe(location)}`);
  }
  const { subpath, t } = /** @type {{ subpath?: unknown, t?: unknown }} */ (location);
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
 * @param {number} count the number of segments
 * @param {number} t
 * @returns {[number, number]}
 */
function locate(count, t) {
  const segment = Math.min(Math.max(Math.floor(t), 0), count - 1);
  return [segment, t - segment];
}

/**
 * The segment at a location, and the parameter on it.
 *
 * @internal
 * @param {PathValue} path
 * @param {PathTime} location
 * @returns {[Curve, number]}
 */
export function segmentAt(path, location) {
  const { subpath, t } = checkedLocation(path, location);
  const segments = path._segments(subpath);
  const [segment, rest] = locate(segments.length, t);
  return [segments[segment], rest];
}

/**
 * The part of a chain of segments from t0 to t1, t0 <= t1, as a chain of segments.
 *
 * @param {readonly Curve[]} segments
 * @param {number} t0
 * @param {number} t1
 * @returns {Curve[]}
 */
function forwardPart(segments, t0, t1) {
  const [first, from] = locate(segments.length, t0);
  let [last, to] = locate(segments.length, t1);
  if (to === 0 && last > first) [last, to] = [last - 1, 1];
  if (first === last) return [segments[first].subsegment(from, to)];
  const start = from === 0 ? segments[first] : segments[first].subsegment(from, 1);
  const end = to === 1 ? segments[last] : segments[last].subsegment(0, to);
  return [start, ...segments.slice(first + 1, last), end];
}

/**
 * The open spline of consecutive curves.
 *
 * @param {Curve[]} curves
 * @returns {SplineData}
 */
function join(curves) {
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
 *
 * @param {PathValue} path
 * @param {number} subpath
 * @param {number} t0
 * @param {number} t1
 * @returns {SplineData}
 */
function partOfSubpath(path, subpath, t0, t1) {
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
 * @param {PathTime} a
 * @param {PathTime} b
 */
export function isAfter(a, b) {
  return a.subpath > b.subpath || (a.subpath === b.subpath && a.t > b.t);
}

/**
 * The subpaths between two locations in order; parts with t0 = t1 are omitted.
 *
 * @internal
 * @param {PathValue} path
 * @param {PathTime} from
 * @param {PathTime} to not before `from`
 * @returns {SplineData[]}
 */
export function partsBetween(path, from, to) {
  const parts = [];
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
 * @param {PathValue} path
 * @param {PathTime} location
 * @returns {SplineData}
 */
export function pointAsSubpath(path, { subpath, t }) {
  return join(forwardPart(path._segments(subpath), t, t));
}
