// Positions on paths, read from the arena.
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
 * @typedef {PathTime & { point: Point<2>, distance: number }} PathPoint
 */

/**
 * A position on a path with its point, unit tangent and unit normal.
 *
 * @typedef {PathTime & { point: Point<2>, tangent: Point<2>, normal: Point<2> }} PathPointAtLength
 */

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
