// Frames along curves and splines in space.
import * as check from "./check.js";
import { writePoint } from "./points.js";
import { take, trim } from "./transfer.js";

/**
 * @import { PointLike } from "./check.js"
 */

/**
 * Rotation-minimising frames, three numbers for each in all four arrays. The directions have length 1 and stand at right
 * angles to each other; binormal = tangent × normal. Of a curve that is a point they are zero.
 *
 * @typedef {object} Frames
 * @property {Float64Array} points
 * @property {Float64Array} tangents
 * @property {Float64Array} normals
 * @property {Float64Array} binormals
 */

/**
 * @typedef {object} FrameOptions
 * @property {PointLike} [normal] the wish for the normal at t = 0: what of it is at right angles to the tangent is taken. By
 *   default the principal normal; on a straight piece the axis that is farthest from the tangent
 */

/** A frame is 12 numbers and its t; a result may have 1 GiB, as everywhere. */
const MOST_FRAMES = Math.floor(2 ** 27 / 13);

/**
 * Where frames are wanted: even steps of t, or the caller's values.
 *
 * @internal
 * @param {unknown} where a number of segments, or values of t
 * @param {number} curves how many curves each get that many segments
 * @returns {Float64Array}
 */
export function frameTimes(where, curves) {
  if (typeof where !== "number") return check.numbers(where, "ts");
  const segments = check.segmentCount(where) * curves;
  if (segments >= MOST_FRAMES) {
    throw new RangeError(`segments: expected at most ${MOST_FRAMES - 1}, this needs ${segments}`);
  }
  return Float64Array.from({ length: segments + 1 }, (_, i) => i / where);
}

/**
 * The parameters, and behind them the wish for the first normal.
 *
 * @internal
 * @param {Float64Array} ts
 * @param {FrameOptions | undefined} options
 * @returns {Float64Array}
 */
export function frameWishes(ts, options) {
  const { normal } = check.options(options);
  if (normal === undefined) return ts;
  const wishes = new Float64Array(ts.length + 3);
  wishes.set(ts);
  writePoint(wishes, ts.length, normal, 3, "normal");
  return wishes;
}

/**
 * The frames that the core left.
 *
 * @internal
 * @param {number} count
 * @returns {Frames}
 */
export function takeFrames(count) {
  const [points, tangents, normals, binormals] = [0, 3, 6, 9].map((k) => take(k * count, (k + 3) * count));
  trim();
  return { points, tangents, normals, binormals };
}
