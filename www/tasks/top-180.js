import { PRECISION_PX, px, verdict } from "./utils/curves.js";
import { movedPoints } from "./utils/moved.js";

/** The height of the curve in px above the line from P0 to P2. */
const WANTED = 180;
/** P0 and P2 as the page places them. @type {[number, number][]} */
const ENDS = [
  [80, 430],
  [590, 430],
];

export const predict = {
  options: ["180 px above it", "270 px above it", "360 px above it"],
  answer: 2,
  because: "At t = ½ the weights are ¼, ½, ¼. P0 and P2 have the height 0, so the curve is half as high as P1.",
};

/** @param {{ points: [number, number][] }} figure */
export function check({ points: [p0, p1, p2] }) {
  const moved = movedPoints([p0, p2], ENDS, (element) => (element.points = [ENDS[0], element.points[1], ENDS[1]]));
  if (moved) return moved;
  const high = (p0[1] + p2[1]) / 2 - p1[1];
  return verdict(
    Math.abs(high / 2 - WANTED) <= PRECISION_PX / 2,
    `P1 is ${px(high)} above the line, the arch is ${px(Math.max(0, high / 2))} high.`,
  );
}

/** @param {{ points: [number, number][] }} element */
export function reveal(element) {
  const [p0, p2] = ENDS;
  element.points = [p0, [(p0[0] + p2[0]) / 2, p0[1] - 2 * WANTED], p2];
}
