// Positions on paths and intersections of paths, read from the arena.
import { core } from "../../wasm/init.js";
import { writeArguments, readResult } from "../../wasm/transfer.js";

/**
 * @import { Point } from "../points.js"
 */

/**
 * A position on a path: the index of the subpath, and the parameter on it.
 *
 * @typedef {{ subpath: number, t: number }} PathTime
 */

/**
 * A position on a path with its point and the distance from the query point.
 *
 * @typedef {PathTime & { point: Point, distance: number }} PathPoint
 */

/**
 * An intersection of two paths: t on a subpath of the first, u on a subpath of the second. At a "tangent" intersection,
 * both have the same or opposite directions. An "overlap" is a shared part from t and u to tEnd and uEnd; `point` is
 * its start.
 *
 * @typedef {PathTime & { otherSubpath: number, u: number, point: Point, kind: "cross" | "tangent" }} PathPointIntersection
 * @typedef {PathTime & { otherSubpath: number, u: number, point: Point, kind: "overlap", tEnd: number, uEnd: number }} PathOverlapIntersection
 * @typedef {PathPointIntersection | PathOverlapIntersection} PathIntersection
 */

/** The numbers of an intersection: t, u, x, y, the kind, t and u of its end, both subpaths. */
const RECORD_LENGTH = 9;

/**
 * The intersections of two packed paths, or the self-intersections of one.
 *
 * @internal
 * @param {Float64Array} packed
 * @param {Float64Array} [other]
 * @returns {PathIntersection[]}
 */
export function intersectPaths(packed, other) {
  const view = writeArguments(packed, other?.length);
  if (other) view.set(other, packed.length);
  const numbers = readResult(0, core().path_intersect(other !== undefined));
  return Array.from({ length: numbers.length / RECORD_LENGTH }, (_, k) => {
    const [t, u, x, y, kind, tEnd, uEnd, subpath, otherSubpath] = numbers.subarray(
      RECORD_LENGTH * k,
      RECORD_LENGTH * (k + 1),
    );
    const shared = { subpath, t, otherSubpath, u, point: { x, y } };
    return kind === 2
      ? { ...shared, kind: "overlap", tEnd, uEnd }
      : { ...shared, kind: kind === 1 ? "tangent" : "cross" };
  });
}

/**
 * Reads positions from the arena, two numbers each.
 *
 * @internal
 * @param {number} length
 * @returns {PathTime[]}
 */
export function readTimes(length) {
  const numbers = readResult(0, length);
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
  writeArguments(packed, 2).set(point, packed.length);
  const [subpath, t, x, y, distance] = readResult(0, core().path_nearest());
  return subpath === undefined ? null : { subpath, t, point: { x, y }, distance };
}
