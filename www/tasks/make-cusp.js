import { firstCurve, verdict } from "./utils/curves.js";
import { movedPoints } from "./utils/moved.js";

/** The ends as the page places them. @type {[number, number][]} */
export const ENDS = [
  [190, 400],
  [490, 400],
];
/** At a cusp the speed is at most this part of its maximum. */
const MAX_PART = 0.02;
/** A zero of the velocity closer than this to an end is no cusp. */
const MIN_FROM_END = 0.02;
const STEPS = 2000;
/** Less than this part of its length from its chord, a curve is a line. */
const FLAT = 0.01;

/** @param {{ points: [number, number][], pieces: { curve: any }[] }} figure */
export function check(figure) {
  const moved = movedPoints([figure.points[0], figure.points[3]], ENDS, (element) => {
    element.points = element.points.with(0, ENDS[0]).with(3, ENDS[1]);
  });
  if (moved) return moved;
  const curve = firstCurve(figure);
  const speeds = Array.from({ length: STEPS + 1 }, (_, i) => {
    const { x, y } = curve.derivativeAt(i / STEPS);
    return Math.hypot(x, y);
  });
  const inside = speeds.slice(MIN_FROM_END * STEPS, (1 - MIN_FROM_END) * STEPS + 1);
  const slowest = Math.min(...inside);
  const t = (inside.indexOf(slowest) + MIN_FROM_END * STEPS) / STEPS;
  const part = slowest / Math.max(...speeds);
  const { min, max } = curve.bounds();
  if (max.y - min.y < FLAT * curve.length())
    return verdict(false, "The curve is a straight line. Move P1 and P2 off it.");
  const words = `Between the ends, the speed falls to ${(100 * part).toFixed(1)} % of its maximum, at t = ${t.toFixed(2)}.`;
  if (part <= MAX_PART) return verdict(true, words);
  const crossings = curve.selfIntersections().length;
  return verdict(false, `${words} ${crossings ? "The curve still has a loop." : "The curve has no loop."}`);
}

/** The legs are the diagonals of a rectangle. @param {{ points: [number, number][] }} element */
export const reveal = (element) => {
  const [[x0, y0], [x3]] = ENDS;
  element.points = [ENDS[0], [x3, y0 - 300], [x0, y0 - 300], ENDS[1]];
};
