// Intersections of curves, splines and paths, read from the arena.
import { arena } from "../wasm/arena.js";
import { packedPath, splineData, typeOf } from "./brand.js";
import { require2D } from "./check.js";
import { packedShape } from "./path/packed-shape.js";
import { packedSplines } from "../wasm/packed-path.js";
import { core } from "../wasm/init.js";
import { writeArguments, readResult, releaseMemory } from "../wasm/transfer.js";

/**
 * @import { SplineData } from "./brand.js"
 * @import { PathTime } from "./path/path-queries.js"
 * @import { Point } from "./points.js"
 */

/**
 * An intersection of two shapes: t on the first, u on the second. Both are numbers for curves and splines, and locations
 * {subpath, t} for paths. At a "tangent" intersection, both have the same or opposite directions. An "overlap" is a
 * shared part from t and u to tEnd and uEnd; `point` is its start.
 *
 * @template [T=number]
 * @template [U=number]
 * @typedef {PointIntersection<T, U> | OverlapIntersection<T, U>} Intersection
 */

/**
 * A single point where two shapes intersect.
 *
 * @template [T=number]
 * @template [U=number]
 * @typedef {object} PointIntersection
 * @property {T} t the parameter on the first shape
 * @property {U} u the parameter on the second shape
 * @property {Point} point
 * @property {"cross" | "tangent"} kind
 */

/**
 * A part that two shapes share.
 *
 * @template [T=number]
 * @template [U=number]
 * @typedef {object} OverlapIntersection
 * @property {T} t the start of the shared part on the first shape
 * @property {U} u its start on the second shape
 * @property {Point} point its start
 * @property {"overlap"} kind
 * @property {T} tEnd the end of the shared part on the first shape
 * @property {U} uEnd its end on the second shape, before `u` if the directions are opposite
 */

/**
 * An intersection of two paths, or of a path with itself.
 *
 * @typedef {Intersection<PathTime, PathTime>} PathIntersection
 */

/**
 * A point that a curve passes twice: at t and at u, t < u.
 *
 * @typedef {{ t: number, u: number, point: Point }} SelfIntersection
 */

/** The numbers of an intersection: t, u, x, y, the kind, t and u of its end. */
const RECORD_LENGTH = 7;

/** Those of an intersection of paths: the same ones, then the subpath of the first path and that of the second. */
const PATH_RECORD_LENGTH = RECORD_LENGTH + 2;

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
 * The intersections of a 2D spline with a curve, a spline or a path.
 *
 * @internal
 * @param {SplineData} spline
 * @param {unknown} other
 * @returns {Intersection<number, number | PathTime>[]}
 * @throws {TypeError} for any other value, and for a 3D one
 */
export function intersectSplines(spline, other) {
  const packed = packedPath(other);
  if (packed) return intersectPacked(packedSplines([spline]), packed, timeOnSpline, timeOnPath);
  const data = splineData(other, "other", "a Curve, a Spline or a Path");
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

/**
 * The intersections of a packed path with a curve, a spline or a path.
 *
 * @internal
 * @param {Float64Array} packed
 * @param {unknown} other
 * @returns {Intersection<PathTime, number | PathTime>[]}
 * @throws {TypeError} for any other value, and for a 3D one
 */
export function intersectPathWith(packed, other) {
  const otherPacked = packedShape(other, "other");
  if (typeOf(other) === "path") return intersectPacked(packed, otherPacked, timeOnPath, timeOnPath);
  return intersectPacked(packed, otherPacked, timeOnPath, timeOnSpline);
}

/**
 * The points that a path passes twice.
 *
 * @internal
 * @param {Float64Array} packed
 * @returns {PathIntersection[]}
 */
export function selfIntersectPath(packed) {
  writeArguments(packed);
  return readPathIntersections(core().path_intersect(false), timeOnPath, timeOnPath);
}

/**
 * @param {number} subpath
 * @param {number} t
 * @returns {PathTime}
 */
function timeOnPath(subpath, t) {
  return { subpath, t };
}

/**
 * @param {number} _ the subpath of a path with one subpath
 * @param {number} t
 */
function timeOnSpline(_, t) {
  return t;
}

/**
 * @template T, U
 * @param {Float64Array} a a packed path
 * @param {Float64Array} b a packed path
 * @param {(subpath: number, t: number) => T} timeOnA
 * @param {(subpath: number, t: number) => U} timeOnB
 * @returns {Intersection<T, U>[]}
 */
function intersectPacked(a, b, timeOnA, timeOnB) {
  writeArguments(a, b.length).set(b, a.length);
  return readPathIntersections(core().path_intersect(true), timeOnA, timeOnB);
}

/**
 * @template T, U
 * @param {number} length
 * @param {(subpath: number, t: number) => T} timeOnA
 * @param {(subpath: number, t: number) => U} timeOnB
 * @returns {Intersection<T, U>[]}
 */
function readPathIntersections(length, timeOnA, timeOnB) {
  const numbers = readResult(0, length);
  releaseMemory();
  return Array.from({ length: length / PATH_RECORD_LENGTH }, (_, k) => {
    const record = numbers.subarray(PATH_RECORD_LENGTH * k, PATH_RECORD_LENGTH * (k + 1));
    const [t, u, x, y, kind, tEnd, uEnd, a, b] = record;
    const shared = { t: timeOnA(a, t), u: timeOnB(b, u), point: { x, y } };
    return kind === 2
      ? { ...shared, kind: "overlap", tEnd: timeOnA(a, tEnd), uEnd: timeOnB(b, uEnd) }
      : { ...shared, kind: kind === 1 ? "tangent" : "cross" };
  });
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
