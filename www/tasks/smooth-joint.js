import { JOINT_POINT, jointAngle, SURFACES } from "../figures/lib/surfaces.js";
import { verdict } from "./utils/surfaces.js";

/** The limit that the task states, in degrees. */
const MAX_ANGLE = 3;

/** @param {{ surface: any }} figure */
export function check({ surface }) {
  const angle = jointAngle(surface);
  const done = angle <= MAX_ANGLE;
  return verdict(
    done,
    done
      ? `The largest angle is ${angle.toFixed(1)}°. It is 0 if the three points of every row lie on one line with the same ratio.`
      : `The largest angle between normals is ${angle.toFixed(1)}°; at most ${MAX_ANGLE}° is allowed.`,
  );
}

/** @param {any} element */
export function reveal(element) {
  element.surface = SURFACES.joint().movePoint(JOINT_POINT.vertex, JOINT_POINT.at);
}
