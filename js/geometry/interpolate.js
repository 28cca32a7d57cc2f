// Splines through points.
import * as check from "./check.js";
import { core } from "../wasm/init.js";
import { flatten } from "./points.js";
import { load } from "../wasm/transfer.js";

/**
 * @import { PointsLike } from "./check.js"
 */

/**
 * Which smooth curve goes through points: `natural`, the cubic spline with equal second derivatives at all joints and none
 * at free ends; or `catmull-rom`, whose tangent at a point comes from its two neighbours. `alpha` says how much the lengths
 * of chords count there: 0 uniform, ½ centripetal, 1 chordal.
 *
 * @typedef {object} InterpolateOptions
 * @property {"natural" | "catmull-rom"} [kind] "natural" by default
 * @property {number} [alpha] 0 to 1, by default ½
 * @property {boolean} [closed]
 * @property {2 | 3} [dimension]
 */

/** @type {readonly ("natural" | "catmull-rom")[]} */
const KINDS = ["natural", "catmull-rom"];

/**
 * Leaves a spline through points in the arena.
 *
 * @internal
 * @param {PointsLike} points
 * @param {InterpolateOptions} [options]
 * @returns {{ length: number, dimension: 2 | 3 }}
 */
export function interpolate(points, options) {
  const { kind = "natural", alpha = 0.5, closed = false, dimension: wanted } = check.options(options);
  check.oneOf(kind, "kind", KINDS);
  const power = check.finite(alpha, "alpha");
  if (!(power >= 0 && power <= 1)) throw new RangeError(`alpha: expected a number from 0 to 1, got ${power}`);
  const { flat, dimension } = flatten(points, wanted, 2);
  load(flat);
  const count = flat.length / dimension;
  return {
    length: core().spline_interpolate(dimension, count, Boolean(closed), kind === "natural" ? -1 : power),
    dimension,
  };
}
