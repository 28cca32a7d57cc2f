import { PRECISION_PX, distance, px, verdict } from "./utils/curves.js";

/** Where P4 must be: P3 amid P2 and P4. @param {[number, number][]} points */
const mirrored = (points) =>
  /** @type {[number, number]} */ ([2 * points[3][0] - points[2][0], 2 * points[3][1] - points[2][1]]);

export const predict = {
  options: ["P2, P3 and P4 lie on one line", "P3 lies exactly amid P2 and P4", "P1, P3 and P5 lie on one line"],
  answer: 1,
  because:
    "The velocities at P3 are 3(P3 − P2) and 3(P4 − P3). A line alone makes their directions equal, not their lengths.",
};

/** @param {{ points: [number, number][] }} figure */
export function check({ points }) {
  if (points.length < 7) return verdict(false, "Show all seven points first (m).");
  if (distance(points[2], points[3]) < 2 * PRECISION_PX)
    return verdict(false, "Not with a handle of no length: move P2 away from P3.");
  const off = distance(points[4], mirrored(points));
  return verdict(
    off <= PRECISION_PX,
    off <= PRECISION_PX
      ? "C1: the point runs through P3 without a jolt."
      : `P4 is ${px(off)} from where P3 would be amid.`,
  );
}

/** @param {{ points: [number, number][] }} element */
export function reveal(element) {
  const points = /** @type {[number, number][]} */ ([...element.points]);
  points[4] = mirrored(points);
  element.points = points;
}
