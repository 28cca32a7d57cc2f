// The path of the camera: a spline through points, places on it at even or raw speed, and frames.
import { Spline } from "casteljau";

/** @typedef {[number, number, number]} Vector */
/** @typedef {{ point: Vector, tangent: Vector, normal: Vector, binormal: Vector }} Frame */
/** @typedef {"minimising" | "frenet" | "upright"} FrameKind */

const UP = /** @type {Vector} */ ([0, 0, 1]);
/** Below this part of |B′|³ the curve is as good as straight, and Frenet has no answer. */
const STRAIGHT = 1e-9;

/** @param {Vector} a @param {Vector} b */
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
/** @param {Vector} a @param {Vector} b @returns {Vector} */
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
/** @param {Vector} a @param {number} k @returns {Vector} */
export const times = (a, k) => [a[0] * k, a[1] * k, a[2] * k];
/** @param {Vector} a @param {Vector} b @returns {Vector} */
export const plus = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
/** @param {Vector} a @param {Vector} b @returns {Vector} */
export const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
/** @param {Vector} a @returns {Vector} */
export const unit = (a) => times(a, 1 / (Math.hypot(...a) || 1));
/** @param {{ x: number, y: number, z?: number }} p @returns {Vector} */
const vector = ({ x, y, z = 0 }) => [x, y, z];
/** @param {ArrayLike<number>} flat @param {number} i @returns {Vector} */
const triple = (flat, i) => [flat[3 * i], flat[3 * i + 1], flat[3 * i + 2]];

/**
 * @param {readonly Vector[]} points
 * @param {{ kind: "natural" | "catmull-rom", closed: boolean }} options
 */
export const pathThrough = (points, { kind, closed }) =>
  Spline.interpolate(
    points.map((point) => [...point]),
    { kind, closed, dimension: 3 },
  );

/**
 * Where the camera is after a part of the time.
 *
 * @param {Spline} path
 * @param {number} progress 0 to 1
 * @param {boolean} even equal ways in equal times; otherwise equal steps of t
 * @returns {number} t
 */
export const timeAt = (path, progress, even) =>
  even ? path.timeAtLength(progress * path.length()) : progress * path.segmentCount;

/**
 * The times of equal steps.
 *
 * @param {Spline} path
 * @param {number} steps
 * @param {boolean} even
 */
export const equalSteps = (path, steps, even) =>
  even
    ? path.equidistantTimes(steps)
    : Float64Array.from({ length: steps + 1 }, (_, i) => (i / steps) * path.segmentCount);

/**
 * Rotation-minimising frames: carried along from the start without turning about the path.
 *
 * @param {Spline} path
 * @param {ArrayLike<number>} ts increasing
 * @returns {Frame[]}
 */
export function minimising(path, ts) {
  // The start comes first, whatever is asked: that is where the camera stands upright.
  const { points, tangents, normals, binormals } = path.frames([0, ...Array.from(ts)], { normal: UP });
  return Array.from(ts, (_, i) => ({
    point: triple(points, i + 1),
    tangent: triple(tangents, i + 1),
    normal: triple(normals, i + 1),
    binormal: triple(binormals, i + 1),
  }));
}

/**
 * Frenet's frame: the normal towards the inside of the bend; null where there is no bend.
 *
 * @param {Spline} path
 * @param {number} t
 * @returns {Frame | null}
 */
export function frenet(path, t) {
  const k = Math.min(Math.floor(t), path.segmentCount - 1);
  const segment = path.segments()[k];
  const [first, second] = [1, 2].map((order) => vector(/** @type {any} */ (segment.derivativeAt(t - k, order))));
  const across = cross(first, second);
  if (!(Math.hypot(...across) > STRAIGHT * Math.hypot(...first) ** 3)) return null;
  const [tangent, binormal] = [unit(first), unit(across)];
  return { point: vector(/** @type {any} */ (path.eval(t))), tangent, normal: cross(binormal, tangent), binormal };
}

/** Its normal as near to the zenith as the tangent allows. @param {Frame} frame @returns {Frame} */
function upright(frame) {
  const normal = unit(minus(UP, times(frame.tangent, dot(UP, frame.tangent))));
  return { ...frame, normal, binormal: cross(frame.tangent, normal) };
}

/**
 * Frames of a kind; where Frenet has none the last one is kept.
 *
 * @param {Spline} path
 * @param {ArrayLike<number>} ts increasing
 * @param {FrameKind} kind
 * @returns {Frame[]}
 */
export function framesOf(path, ts, kind) {
  const carried = minimising(path, ts);
  if (kind === "minimising") return carried;
  if (kind === "upright") return carried.map(upright);
  let last = carried[0];
  return carried.map(
    (frame, i) => (last = frenet(path, ts[i]) ?? { ...frame, normal: last.normal, binormal: last.binormal }),
  );
}

/**
 * How far a frame is turned about the path against a rotation-minimising one, in degrees, −180 to 180.
 *
 * @param {Frame} frame
 * @param {Frame} carried
 */
export const roll = (frame, carried) =>
  (Math.atan2(dot(frame.normal, carried.binormal), dot(frame.normal, carried.normal)) * 180) / Math.PI;

/**
 * The frame for a camera that turns to a place instead of looking ahead.
 *
 * @param {Frame} frame
 * @param {Vector} target
 * @returns {Frame}
 */
export function lookingAt(frame, target) {
  const tangent = unit(minus(target, frame.point));
  const normal = unit(minus(frame.normal, times(tangent, dot(frame.normal, tangent))));
  return { point: frame.point, tangent, normal, binormal: cross(tangent, normal) };
}
