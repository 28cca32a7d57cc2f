import { distance, firstCurve, PRECISION_PX, verdict } from "./utils/curves.js";

export const live = true;

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
  if (points.length !== 4) return verdict(false, "Keep the four control points.");
  if (distance(points[0], ENDS[0]) > PRECISION_PX || distance(points[3], ENDS[1]) > PRECISION_PX)
    return verdict(false, "Put P0 and P3 back to the ends of a horizontal line: (90, 400) and (590, 400).");
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
