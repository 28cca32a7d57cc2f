// Joint modes and continuity.
import * as check from "./check.js";

/**
 * The constraint of a joint while points move: "free", none; "g1", equal tangent directions; "c1", equal first
 * derivatives; "c2", equal first and second derivatives; "g2", equal tangent directions and curvatures (2D only);
 * "auto", handles that follow from the neighbouring joints (centripetal Catmull-Rom).
 *
 * @typedef {"free" | "g1" | "c1" | "c2" | "g2" | "auto"} JointMode
 */

/**
 * The continuity at a joint.
 *
 * @typedef {object} Continuity
 * @property {boolean} c0 the segments meet
 * @property {boolean} g1 the segments have the same tangent direction
 * @property {boolean} c1 the segments have the same first derivative
 * @property {boolean} g2 the segments have the same tangent direction and curvature
 * @property {boolean} c2 the segments have the same first and second derivatives
 * @property {number} gap the distance between the ends of the segments
 * @property {number} angle the angle between the two tangents, in radians
 */

/** @type {readonly JointMode[]} in the order of the core's codes */
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
 * The code of the joint at the start of each segment.
 *
 * @internal
 * @param {ArrayLike<JointMode | undefined> | Record<number, JointMode> | undefined} joints
 * @param {number} segments
 * @param {2 | 3} dimension
 * @returns {Float64Array}
 */
export function modeCodes(joints, segments, dimension) {
  const modes = /** @type {Record<number, JointMode | undefined>} */ (check.object(joints, "joints"));
  const codes = new Float64Array(segments);
  for (let k = 0; k < segments; k++) {
    const mode = modes[k];
    if (mode !== undefined) codes[k] = modeCode(mode, `joints[${k}]`, dimension);
  }
  return codes;
}
