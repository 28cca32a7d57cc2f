// Intersections of curves and splines, read from the arena.
import { arena } from "../wasm/arena.js";
import { describe } from "./check.js";
import { core } from "../wasm/init.js";
import { writeArguments, releaseMemory } from "../wasm/transfer.js";

/**
 * @import { Point } from "./points.js"
 */

/**
 * The data of a spline: its control points (joints once), the degree of each segment, whether it is closed.
 *
 * @internal
 * @typedef {{ flat: Float64Array, dimension: 2 | 3, degrees: readonly number[], closed: boolean }} SplineData
 */

/**
 * The name of the method by which curves and splines give each other their data; a curve is a spline of one segment.
 *
 * @internal
 */
export const SPLINE_DATA = Symbol("spline data");

/**
 * An intersection of two curves: t on the first, u on the second. At a "tangent" intersection, both have the same or
 * opposite directions. An "overlap" is a shared part from t and u to tEnd and uEnd; `point` is its start.
 *
 * @typedef {{ t: number, u: number, point: Point, kind: "cross" | "tangent" }} PointIntersection
 * @typedef {{ t: number, u: number, point: Point, kind: "overlap", tEnd: number, uEnd: number }} OverlapIntersection
 * @typedef {PointIntersection | OverlapIntersection} Intersection
 */

/**
 * A point that a curve passes twice: at t and at u, t < u.
 *
 * @typedef {{ t: number, u: number, point: Point }} SelfIntersection
 */

/** The numbers of an intersection: t, u, x, y, the kind, t and u of its end. */
const RECORD_LENGTH = 7;

/**
 * Reads intersections from the arena.
 *
 * @internal
 * @param {number} length
 * @returns {Intersection[]}
 */
export function readIntersections(length) {
  const view = arena(length);
  /** @type {Intersection[]} */
  const intersections = [];
  for (let i = 0; i < length; i += RECORD_LENGTH) {
    const t = view[i];
    const u = view[i + 1];
    const point = { x: view[i + 2], y: view[i + 3] };
    const kind = view[i + 4];
    if (kind === 2) intersections.push({ t, u, point, kind: "overlap", tEnd: view[i + 5], uEnd: view[i + 6] });
    else intersections.push({ t, u, point, kind: kind === 1 ? "tangent" : "cross" });
  }
  releaseMemory();
  return intersections;
}

/**
 * @internal
 * @param {number} length
 * @returns {SelfIntersection[]}
 */
export function readSelfIntersections(length) {
  return readIntersections(length).map(({ t, u, point }) => ({ t, u, point }));
}

/**
 * The data of a 2D curve or spline.
 *
 * @internal
 * @param {unknown} value
 * @returns {SplineData}
 * @throws {TypeError} for anything else
 */
export function splineDataOf(value) {
  const method = /** @type {{ [SPLINE_DATA]?: () => SplineData } | null | undefined} */ (value)?.[SPLINE_DATA];
  if (typeof method !== "function") throw new TypeError(`other: expected a Curve or a Spline, got ${describe(value)}`);
  return method.call(value);
}

/**
 * The intersections of two splines.
 *
 * @internal
 * @param {SplineData} spline
 * @param {SplineData} other
 * @returns {Intersection[]}
 */
export function intersectSplines(spline, other) {
  writeSplines([spline, other]);
  return readIntersections(core().spline_intersect());
}

/**
 * The points that a spline passes twice.
 *
 * @internal
 * @param {SplineData} spline
 * @returns {SelfIntersection[]}
 */
export function selfIntersectSpline(spline) {
  writeSplines([spline]);
  return readSelfIntersections(core().spline_self_intersections());
}

/** @param {SplineData[]} splines */
function writeSplines(splines) {
  const length = splines.reduce((sum, { flat, degrees }) => sum + 2 + degrees.length + flat.length, 0);
  const view = writeArguments(new Float64Array(0), length);
  let at = 0;
  for (const { flat, degrees, closed } of splines) {
    view[at] = degrees.length;
    view[at + 1] = closed ? 1 : 0;
    view.set(degrees, at + 2);
    view.set(flat, at + 2 + degrees.length);
    at += 2 + degrees.length + flat.length;
  }
}

/**
 * Throws a TypeError in 3D.
 *
 * @internal
 * @param {string} method
 * @param {string} what "curve" or "spline"
 * @param {2 | 3} dimension
 */
export function require2D(method, what, dimension) {
  if (dimension === 3) throw new TypeError(`${method}: expected a 2D ${what}, got a 3D one`);
}
