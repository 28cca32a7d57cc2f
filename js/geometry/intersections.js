// Intersections of curves and splines, read from the arena.
import { arena } from "../wasm/arena.js";
import { splineData, typeOf } from "./brand.js";
import { require2D } from "./check.js";
import { core } from "../wasm/init.js";
import { writeArguments, releaseMemory } from "../wasm/transfer.js";

/**
 * @import { SplineData } from "./brand.js"
 * @import { Point } from "./points.js"
 */

/**
 * An intersection of two curves: t on the first, u on the second. At a "tangent" intersection, both have the same or
 * opposite directions. An "overlap" is a shared part from t and u to tEnd and uEnd; `point` is its start.
 *
 * @typedef {PointIntersection | OverlapIntersection} Intersection
 */

/**
 * @typedef {object} PointIntersection
 * @property {number} t the parameter on the first curve
 * @property {number} u the parameter on the second curve
 * @property {Point} point
 * @property {"cross" | "tangent"} kind
 */

/**
 * @typedef {object} OverlapIntersection
 * @property {number} t the start of the shared part on the first curve
 * @property {number} u its start on the second curve
 * @property {Point} point its start
 * @property {"overlap"} kind
 * @property {number} tEnd the end of the shared part on the first curve
 * @property {number} uEnd its end on the second curve, below `u` if the directions are opposite
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
 * The intersections of a 2D spline with a curve or a spline.
 *
 * @internal
 * @param {SplineData} spline
 * @param {unknown} other
 * @returns {Intersection[]}
 * @throws {TypeError} for any other value, and for a 3D one
 */
export function intersectSplines(spline, other) {
  const data = splineData(other, "other");
  require2D("intersections", /** @type {string} */ (typeOf(other)), data.dimension);
  writeSplines([spline, data]);
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
