// Places on paths, as the core leaves them.
import { core } from "../wasm/init.js";
import { load, take } from "../wasm/transfer.js";

/**
 * @import { Point } from "./points.js"
 */

/**
 * A place on a path: the index of the subpath, and the parameter on it.
 *
 * @typedef {{ subpath: number, t: number }} PathTime
 */

/**
 * The same with the point there and its distance from the point that was asked for.
 *
 * @typedef {PathTime & { point: Point, distance: number }} PathPoint
 */

/**
 * A place that two paths share: t on a subpath of the first, u on one of the second. "tangent": with the same direction
 * or the opposite one. "overlap": a shared piece, from t and u to tEnd and uEnd; `point` is its start.
 *
 * @typedef {PathTime & { otherSubpath: number, u: number, point: Point, kind: "cross" | "tangent" }} PathMeeting
 * @typedef {PathTime & { otherSubpath: number, u: number, point: Point, kind: "overlap", tEnd: number, uEnd: number }} PathOverlap
 * @typedef {PathMeeting | PathOverlap} PathIntersection
 */

/** The numbers of a place that two paths share: t, u, x, y, the kind, t and u of its end, both subpaths. */
const PLACE = 9;

/**
 * Where two packed paths meet, or one meets itself.
 *
 * @internal
 * @param {Float64Array} packed
 * @param {Float64Array} [other]
 * @returns {PathIntersection[]}
 */
export function meetPaths(packed, other) {
  const view = load(packed, other?.length);
  if (other) view.set(other, packed.length);
  const numbers = take(0, core().path_intersect(other !== undefined));
  return Array.from({ length: numbers.length / PLACE }, (_, k) => {
    const [t, u, x, y, kind, tEnd, uEnd, subpath, otherSubpath] = numbers.subarray(PLACE * k, PLACE * (k + 1));
    const place = { subpath, t, otherSubpath, u, point: { x, y } };
    return kind === 2
      ? { ...place, kind: "overlap", tEnd, uEnd }
      : { ...place, kind: kind === 1 ? "tangent" : "cross" };
  });
}

/**
 * The places that the core left, two numbers each.
 *
 * @internal
 * @param {number} length
 * @returns {PathTime[]}
 */
export function takeTimes(length) {
  const numbers = take(0, length);
  return Array.from({ length: numbers.length / 2 }, (_, k) => ({ subpath: numbers[2 * k], t: numbers[2 * k + 1] }));
}

/**
 * The point of a packed path that is nearest to another one.
 *
 * @internal
 * @param {Float64Array} packed
 * @param {Float64Array} point
 * @returns {PathPoint | null}
 */
export function nearestOnPath(packed, point) {
  load(packed, 2).set(point, packed.length);
  const [subpath, t, x, y, distance] = take(0, core().path_nearest());
  return subpath === undefined ? null : { subpath, t, point: { x, y }, distance };
}
