// What is kept at joints, and what is true there.
import * as check from "./check.js";

/**
 * What is kept at a joint while points move: nothing; aligned handles; equal first derivatives; equal second ones, too;
 * aligned handles and equal curvatures (2D only); or handles that follow the neighbouring joints (centripetal Catmull-Rom).
 *
 * @typedef {"free" | "g1" | "c1" | "c2" | "g2" | "auto"} JointMode
 */

/**
 * What is true at a joint.
 *
 * @typedef {object} Continuity
 * @property {boolean} c0 the segments meet
 * @property {boolean} g1 they have the same tangent direction
 * @property {boolean} c1 they have the same first derivative
 * @property {boolean} g2 they have the same tangent and curvature
 * @property {boolean} c2 they have the same first and second derivative
 * @property {number} gap the distance between the two ends
 * @property {number} angle the angle between the two tangents, in radians
 */

/** @type {readonly JointMode[]} in the order of the core */
const MODES = ["free", "g1", "c1", "c2", "g2", "auto"];

/**
 * The core's code for a mode.
 *
 * @internal
 * @param {JointMode} mode
 * @param {string} name
 * @param {2 | 3} dimension
 * @returns {number}
 */
export function modeCode(mode, name, dimension) {
  const code = MODES.indexOf(check.oneOf(mode, name, MODES));
  if (mode === "g2" && dimension === 3) throw new RangeError(`${name}: expected a 2D spline for "g2", got a 3D one`);
  return code;
}

/**
 * A code for the start of each segment.
 *
 * @internal
 * @param {ArrayLike<JointMode | undefined> | Record<number, JointMode> | undefined} joints
 * @param {number} segments
 * @param {2 | 3} dimension
 * @returns {Float64Array}
 */
export function modeCodes(joints, segments, dimension) {
  const modes = /** @type {Record<number, JointMode | undefined>} */ (check.options(joints, "joints"));
  const codes = new Float64Array(segments);
  for (let k = 0; k < segments; k++) {
    const mode = modes[k];
    if (mode !== undefined) codes[k] = modeCode(mode, `joints[${k}]`, dimension);
  }
  return codes;
}
