import { PRECISION_PX, px, verdict } from "./utils/curves.js";

/** The distance of the spline from P2: the joint there is (P1 + 4 P2 + P3) / 6. @param {[number, number][]} points */
const missed = ([, p1, p2, p3]) => Math.hypot(p1[0] + p3[0] - 2 * p2[0], p1[1] + p3[1] - 2 * p2[1]) / 6;

/** @param {{ points: [number, number][], basis: string }} figure */
export function check({ points, basis }) {
  if (basis !== "b-spline")
    return verdict(false, "Keep the B-spline. The other splines pass through their points anyway.");
  const off = missed(points);
  return verdict(
    off <= PRECISION_PX / 2,
    off <= PRECISION_PX / 2
      ? "It passes through P2: P2 is the midpoint of P1 and P3."
      : `Its distance from P2 is ${px(off)}.`,
  );
}

/** @param {{ points: [number, number][] }} element */
export function reveal(element) {
  const points = /** @type {[number, number][]} */ ([...element.points]);
  points[2] = [(points[1][0] + points[3][0]) / 2, (points[1][1] + points[3][1]) / 2];
  element.points = points;
}
