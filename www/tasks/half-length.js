import { verdict } from "./utils/curves.js";
import { movedPoints } from "./utils/moved.js";

/** The control points of the site's figure. @type {[number, number][]} */
export const POINTS = [
  [12, 66],
  [12, 52],
  [36, 8],
  [118, 28],
];

const ALLOWED_PERCENT = 1;

export const predict = {
  options: ["at t < 0.5", "at t = 0.5", "at t > 0.5"],
  answer: 2,
  because:
    "The point is slow at first, because the first legs are short. At t = 0.5 most of the length is still ahead.",
};

/** @param {unknown} _figure @param {{ points: [number, number][], t: number, curve: any }} element the site's figure of the arc length */
export function check(_figure, { points, t, curve }) {
  const moved = movedPoints(points, POINTS);
  if (moved) return moved;
  const share = (100 * curve.subsegment(0, t).length()) / curve.length();
  return verdict(
    Math.abs(share - 50) <= ALLOWED_PERCENT,
    `From P0 to t = ${t.toFixed(2)}: ${share.toFixed(1)} % of the length.`,
  );
}

/** @param {{ points: [number, number][], t: number, curve: any }} element */
export function reveal(element) {
  element.points = POINTS;
  const { curve } = element;
  element.t = Math.round(100 * curve.timeAtLength(curve.length() / 2)) / 100;
}
