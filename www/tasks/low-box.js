import { firstCurve, verdict } from "./utils/curves.js";
import { movedPoints } from "./utils/moved.js";

const WANTED_PERCENT = 50;
/** The ends as the page places them. @type {[number, number][]} */
const ENDS = [
  [90, 400],
  [590, 400],
];
/** Flatter boxes are nearly lines. */
const MIN_HEIGHT_PX = 40;

/** @param {{ min: { y: number }, max: { y: number } }} box */
const heightOf = ({ min, max }) => max.y - min.y;

/** @param {{ points: [number, number][], pieces: { curve: any }[] }} figure */
export function check(figure) {
  const { points } = figure;
  const moved = movedPoints(
    [points[0], ...points.slice(3)],
    ENDS,
    (element) => (element.points = [ENDS[0], ...element.points.slice(1, 3), ENDS[1]]),
  );
  if (moved) return moved;
  const curve = firstCurve(figure);
  const [exact, control] = [heightOf(curve.bounds()), heightOf(curve.controlBounds())];
  if (control < MIN_HEIGHT_PX)
    return verdict(false, `The box of the control points must be at least ${MIN_HEIGHT_PX} px high.`);
  const percent = (100 * exact) / control;
  return verdict(
    percent < WANTED_PERCENT,
    `The exact box is ${exact.toFixed(0)} px high, the box of the control points ${control.toFixed(0)} px: ${percent.toFixed(0)} %.`,
  );
}

/** P1 above the line and P2 below it. @param {{ points: [number, number][] }} element */
export const reveal = (element) => {
  element.points = [ENDS[0], [200, 330], [480, 470], ENDS[1]];
};
