import { formatNumber, verdict } from "./utils/surfaces.js";
import { SURFACES } from "../figures/lib/surfaces.js";

/** The limit that the task states: a few pixels of the picture. */
const MAX_DISTANCE = 0.12;

/** @param {{ points: [number, number, number][] }} figure */
export function check({ points }) {
  const distance = Math.max(...points.map(([, , z]) => Math.abs(z)));
  const done = distance <= MAX_DISTANCE;
  return verdict(
    done,
    done
      ? `The largest distance is ${formatNumber(distance)}. If all control points lie in one plane, so does the patch.`
      : `One point is still ${formatNumber(distance)} away from the plane; at most ${MAX_DISTANCE} is allowed.`,
  );
}

/** @param {any} element */
export function reveal(element) {
  element.surface = SURFACES.nine().movePoint(4, [0, 0, 0]);
}
