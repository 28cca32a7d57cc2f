// Lengths of curves and splines, and what goes by length.
import * as check from "./check.js";
import { core } from "../wasm/init.js";
import { load, take } from "../wasm/transfer.js";

/**
 * The length of a curve.
 *
 * @internal
 * @param {Float64Array} p
 * @param {2 | 3} dimension
 * @param {number | undefined} tolerance
 * @returns {number}
 */
export function curveLength(p, dimension, tolerance) {
  // A plane cubic, the most common kind of curve, goes over as arguments and always as exactly as can be.
  if (tolerance === undefined && p.length === 8 && dimension === 2) {
    return core().cubic_length(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7]);
  }
  const most = check.optionalTolerance(tolerance);
  load(p);
  return take(0, core().curve_length(dimension, p.length / dimension, most))[0];
}

/**
 * The t of a length.
 *
 * @internal
 * @param {Float64Array} p
 * @param {2 | 3} dimension
 * @param {number} s
 * @param {number | undefined} tolerance
 * @returns {number}
 */
export function curveTimeAtLength(p, dimension, s, tolerance) {
  check.finite(s, "s");
  const most = check.optionalTolerance(tolerance);
  load(p);
  return take(0, core().curve_time_at_length(dimension, p.length / dimension, s, most))[0];
}
