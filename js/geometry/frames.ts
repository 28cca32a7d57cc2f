// Rotation-minimising frames of 3D curves and splines.
import { curvesModule } from "../wasm/curves-module.js";
import * as check from "./check.js";
import { writePoint } from "./points.js";
import type { PointLike } from "./check.js";

/**
 * Rotation-minimising frames: each array has three numbers for each frame. The three directions are orthonormal, and
 * binormal = tangent × normal. If all control points of the curve are equal, they are zero.
 */
export interface Frames {
  points: Float64Array;
  tangents: Float64Array;
  normals: Float64Array;
  binormals: Float64Array;
}

/** Options of `frames`. */
export interface FrameOptions {
  /**
   * The requested normal at t = 0, projected to the plane perpendicular to the tangent. By default the principal
   * normal; where the curve is straight, the coordinate axis with the largest angle to the tangent
   */
  normal?: PointLike;
}

/** The limit of 1 GiB for results: a frame has 12 numbers and its t. */
const MAX_FRAMES = Math.floor(2 ** 27 / 13);

/**
 * The parameters of the frames: equally spaced, or given by the caller.
 *
 * @internal
 * @param where a number of segments per curve, or values of t
 * @param curves the number of curves
 */
export function frameTimes(where: unknown, curves: number): Float64Array {
  if (typeof where !== "number") return check.numbers(where, "where");
  const segments = check.segmentCount(where) * curves;
  if (segments >= MAX_FRAMES) {
    throw new RangeError(`segments: expected at most ${MAX_FRAMES - 1}, this needs ${segments}`);
  }
  return Float64Array.from({ length: segments + 1 }, (_, i) => i / where);
}

/**
 * The arguments of the core: the parameters, then the requested first normal if there is one.
 *
 * @internal
 */
export function frameArguments(ts: Float64Array, options: FrameOptions | undefined): Float64Array {
  const { normal } = check.options(options, ["normal"]);
  if (normal === undefined) return ts;
  const args = new Float64Array(ts.length + 3);
  args.set(ts);
  writePoint(args, ts.length, normal, 3, "normal");
  return args;
}

/**
 * Reads frames from the arena.
 *
 * @internal
 */
export function readFrames(count: number): Frames {
  const [points, tangents, normals, binormals] = [0, 3, 6, 9].map((k) => curvesModule.read(k * count, (k + 3) * count));
  curvesModule.release();
  return { points, tangents, normals, binormals };
}
