// Where curves meet, read from the arena.
import { arena } from "../wasm/arena.js";
import { shown } from "./check.js";
import { core } from "../wasm/init.js";
import { load, trim } from "../wasm/transfer.js";

/**
 * @import { Point } from "./points.js"
 */

/**
 * A chain of curves as the core reads it; a curve is a chain of one.
 *
 * @internal
 * @typedef {{ flat: Float64Array, dimension: 2 | 3, degrees: readonly number[], closed: boolean }} Chain
 */

/**
 * The method by which curves and splines hand each other their numbers.
 *
 * @internal
 */
export const CHAIN = Symbol("chain");

/**
 * A place that two curves share: t on the first, u on the second. "tangent": with the same direction or the opposite
 * one. "overlap": a shared piece, from t and u to tEnd and uEnd; `point` is its start.
 *
 * @typedef {{ t: number, u: number, point: Point, kind: "cross" | "tangent" }} Meeting
 * @typedef {{ t: number, u: number, point: Point, kind: "overlap", tEnd: number, uEnd: number }} Overlap
 * @typedef {Meeting | Overlap} Intersection
 */

/**
 * A point that a curve passes twice: at t and again at u, t < u.
 *
 * @typedef {{ t: number, u: number, point: Point }} SelfIntersection
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

/**
 * @internal
 * @param {number} length
 * @returns {SelfIntersection[]}
 */
export function takeSelfIntersections(length) {
  return takeIntersections(length).map(({ t, u, point }) => ({ t, u, point }));
}

/**
 * The chain of a curve or a spline of the plane.
 *
 * @internal
 * @param {unknown} value
 * @returns {Chain}
 * @throws {TypeError} for anything else
 */
export function chainOf(value) {
  const chain = /** @type {{ [CHAIN]?: () => Chain } | null | undefined} */ (value)?.[CHAIN];
  if (typeof chain !== "function") throw new TypeError(`other: expected a Curve or a Spline, got ${shown(value)}`);
  return chain.call(value);
}

/**
 * The places that two chains share.
 *
 * @internal
 * @param {Chain} chain
 * @param {Chain} other
 * @returns {Intersection[]}
 */
export function meetChains(chain, other) {
  loadChains([chain, other]);
  return takeIntersections(core().spline_intersect());
}

/**
 * The points that a chain passes twice.
 *
 * @internal
 * @param {Chain} chain
 * @returns {SelfIntersection[]}
 */
export function meetSelf(chain) {
  loadChains([chain]);
  return takeSelfIntersections(core().spline_self_intersections());
}

/** @param {Chain[]} chains */
function loadChains(chains) {
  const length = chains.reduce((sum, { flat, degrees }) => sum + 2 + degrees.length + flat.length, 0);
  const view = load(new Float64Array(0), length);
  let at = 0;
  for (const { flat, degrees, closed } of chains) {
    view[at] = degrees.length;
    view[at + 1] = closed ? 1 : 0;
    view.set(degrees, at + 2);
    view.set(flat, at + 2 + degrees.length);
    at += 2 + degrees.length + flat.length;
  }
}

/**
 * Refuses what is not in the plane.
 *
 * @internal
 * @param {string} method
 * @param {string} what "curve" or "spline"
 * @param {2 | 3} dimension
 */
export function inPlane(method, what, dimension) {
  if (dimension === 3) throw new TypeError(`${method}: expected a 2D ${what}, got a 3D one`);
}
