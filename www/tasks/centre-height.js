import { formatNumber, verdict } from "./utils/surfaces.js";
import { SURFACES } from "../figures/lib/surfaces.js";

/** The heights that the task states. */
const [WANTED, TOLERANCE] = [0.5, 0.03];
/** The middle one of the nine control points. */
const MIDDLE = 4;

export const predict = {
  options: ["0.5 units above the plane", "1 unit above the plane", "2 units above the plane"],
  answer: 2,
  because:
    "At the centre its weight is 1/4, and the other points lie in the plane. So it must be four times as high as the patch.",
};

/** @param {{ surface: any, points: [number, number, number][] }} figure */
export function check({ surface, points }) {
  const moved = points.some(([, , z], k) => k !== MIDDLE && z !== 0);
  if (moved)
    return {
      ...verdict(false, "Another point has left the plane."),
      restore: (/** @type {any} */ element) => (element.surface = SURFACES.nine()),
    };
  const { z } = surface.patch(0).eval(0.5, 0.5);
  const done = Math.abs(z - WANTED) <= TOLERANCE;
  return verdict(
    done,
    `At its centre the patch is ${formatNumber(z)} units high; P11 is ${formatNumber(points[MIDDLE][2])} units above the plane.`,
  );
}

/** @param {any} element */
export function reveal(element) {
  element.surface = SURFACES.nine().movePoint(MIDDLE, [0, 0, 4 * WANTED]);
}
