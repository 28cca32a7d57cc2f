// Joint modes and continuity.
import * as check from "./check.js";
import { shorten } from "./describe.js";

/**
 * The constraint of a joint while points move: "free", none; "g1", equal tangent directions; "c1", equal first
 * derivatives; "c2", equal first and second derivatives; "g2", equal tangent directions and curvatures (2D only);
 * "auto", handles that follow from the neighbouring joints (centripetal Catmull-Rom).
 */
export type JointMode = "free" | "g1" | "c1" | "c2" | "g2" | "auto";

/** The continuity at a joint. */
export interface Continuity {
  /** The segments meet */
  c0: boolean;
  /** The segments have the same tangent direction */
  g1: boolean;
  /** The segments have the same first derivative */
  c1: boolean;
  /** The segments have the same tangent direction and curvature */
  g2: boolean;
  /** The segments have the same first and second derivatives */
  c2: boolean;
  /** The distance between the ends of the segments */
  gap: number;
  /** The angle between the two tangents, in radians */
  angle: number;
}

/** In the order of the core's codes */
const MODES: readonly JointMode[] = ["free", "g1", "c1", "c2", "g2", "auto"];

/**
 * The core's code for a mode.
 *
 * @internal
 */
export function modeCode(mode: JointMode, name: string, dimension: 2 | 3): number {
  const code = MODES.indexOf(check.oneOf(mode, name, MODES));
  if (mode === "g2" && dimension === 3) throw new RangeError(`${name}: expected a 2D spline for "g2", got a 3D one`);
  return code;
}

/**
 * The code of the joint at the start of each segment. Modes at the ends of an open spline, and those that are undefined,
 * have no effect.
 *
 * @internal
 * @throws {RangeError} for an unknown mode, and for a joint that does not exist
 */
export function modeCodes(
  joints: ArrayLike<JointMode | undefined> | Record<number, JointMode> | undefined,
  segments: number,
  closed: boolean,
  dimension: 2 | 3,
): Float64Array {
  const modes = check.object(joints, "joints") as Record<string, JointMode | undefined>;
  const codes = new Float64Array(segments);
  const last = closed ? segments - 1 : segments;
  for (const [key, mode] of Object.entries(modes)) {
    if (mode === undefined) continue;
    const name = `joints[${shorten(key)}]`;
    const k = Number(key);
    if (!(Number.isInteger(k) && k >= 0 && k <= last)) {
      throw new RangeError(`joints: expected joints from 0 to ${last}, got ${shorten(key)}`);
    }
    const code = modeCode(mode, name, dimension);
    if (k < segments) codes[k] = code;
  }
  return codes;
}
