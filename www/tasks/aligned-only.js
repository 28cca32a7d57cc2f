import { PRECISION_PX, distance, verdict } from "./utils/curves.js";

/** One handle must be more than this many times as long as the other. */
const UNEQUAL = 1.5;
/** A corner of less than two degrees cannot be seen. */
const STRAIGHT_DEGREES = 2;
/** Rounding errors do not count as a corner. */
const EXACT_DEGREES = 1e-6;

/** The angle by which the line turns at P3, in degrees. @param {[number, number][]} points */
function turn([, , p2, p3, p4]) {
  const [a, b] = [Math.atan2(p3[1] - p2[1], p3[0] - p2[0]), Math.atan2(p4[1] - p3[1], p4[0] - p3[0])];
  return Math.abs(Math.atan2(Math.sin(b - a), Math.cos(b - a)) * 180) / Math.PI;
}

/** @param {{ points: [number, number][] }} figure */
export function check({ points }) {
  if (points.length < 7) return verdict(false, "Show all seven points first (press m).");
  const [before, after] = [distance(points[2], points[3]), distance(points[3], points[4])];
  if (Math.min(before, after) < PRECISION_PX) return verdict(false, "Both handles need a length greater than 0.");
  const degrees = turn(points);
  const ratio = Math.max(before, after) / Math.min(before, after);
  const words = `The curve turns by ${degrees.toFixed(1)}° at P3; one handle is ${ratio.toFixed(2)} times as long as the other.`;
  const done = degrees < STRAIGHT_DEGREES && ratio > UNEQUAL;
  if (!done) return verdict(false, words);
  const aligned = degrees < EXACT_DEGREES ? "The joint is G1" : "At exactly 0° the joint is G1";
  return verdict(true, `${words} ${aligned}: it looks smooth, but the speed jumps (not C1).`);
}

/** @param {{ points: [number, number][] }} element */
export function reveal(element) {
  const points = /** @type {[number, number][]} */ ([...element.points]);
  const [[x2, y2], [x3, y3]] = [points[2], points[3]];
  points[4] = [x3 + (x3 - x2) / 2, y3 + (y3 - y2) / 2];
  element.points = points;
}
