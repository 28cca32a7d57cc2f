// Where curves meet, read from the arena.
import { arena } from "./arena.js";
import { trim } from "./transfer.js";

/**
 * @import { Point } from "./points.js"
 */

/**
 * A place that two curves share: t on the first, u on the second. "tangent": with the same direction or the opposite
 * one. "overlap": a shared piece, from t and u to tEnd and uEnd; `point` is its start.
 *
 * @typedef {{ t: number, u: number, point: Point, kind: "cross" | "tangent" }} Meeting
 * @typedef {{ t: number, u: number, point: Point, kind: "overlap", tEnd: number, uEnd: number }} Overlap
 * @typedef {Meeting | Overlap} Intersection
 */

/** The numbers that the core leaves for a place: t, u, x, y, the kind, t and u of its end. */
const PLACE = 7;

/**
 * The places that the core left.
 *
 * @internal
 * @param {number} length
 * @returns {Intersection[]}
 */
export function takeIntersections(length) {
  const view = arena(length);
  /** @type {Intersection[]} */
  const places = [];
  for (let i = 0; i < length; i += PLACE) {
    const t = view[i];
    const u = view[i + 1];
    const point = { x: view[i + 2], y: view[i + 3] };
    const kind = view[i + 4];
    if (kind === 2) places.push({ t, u, point, kind: "overlap", tEnd: view[i + 5], uEnd: view[i + 6] });
    else places.push({ t, u, point, kind: kind === 1 ? "tangent" : "cross" });
  }
  trim();
  return places;
}
