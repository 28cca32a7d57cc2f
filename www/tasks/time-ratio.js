import { PRECISION_PX, distance, px, verdict } from "./utils/curves.js";

/** The seconds that the second piece takes for each second of the first. */
const RATIO = 2;

/** Where P4 must be: as far beyond P3 as P2 is before it, times RATIO. @param {[number, number][]} points */
const wanted = ([, , p2, p3]) =>
  /** @type {[number, number]} */ ([p3[0] + RATIO * (p3[0] - p2[0]), p3[1] + RATIO * (p3[1] - p2[1])]);

export const predict = {
  options: [
    "P3 is the midpoint of P2 and P4",
    "P4 is twice as far from P3 as P2 is",
    "P4 is half as far from P3 as P2 is",
  ],
  answer: 1,
  because: "3(P4 − P3) / 2 = 3(P3 − P2) / 1 gives P4 − P3 = 2(P3 − P2): the longer duration needs the longer handle.",
};

/** @param {{ points: [number, number][] }} figure */
export function check({ points }) {
  if (points.length < 7) return verdict(false, "Show all seven points first (press m).");
  if (distance(points[2], points[3]) < 2 * PRECISION_PX)
    return verdict(false, "The handle from P2 to P3 is too short: move P2 away from P3.");
  const off = distance(points[4], wanted(points));
  return verdict(off <= PRECISION_PX, `P4 is ${px(off)} from the exact place.`);
}

/** @param {{ points: [number, number][] }} element */
export function reveal(element) {
  element.points = element.points.with(4, wanted(element.points));
}
