import { firstCurve, verdict } from "./utils/curves.js";

/** The sine of about 2°: what a slider in steps of a hundredth can reach. */
const LEVEL = 0.04;

export const predict = {
  options: ["on a vertical line", "on a horizontal line", "on the line through P0 and P3"],
  answer: 1,
  because:
    "The handles of an inserted point lie on the last leg, and that is the tangent. At the highest point the tangent is horizontal.",
};

/** @param {{ pieces: { curve: any }[], continuity: { g1: boolean }[] }} figure */
export function check(figure) {
  if (figure.pieces.length < 2) return verdict(false, "The curve is still one piece. Move t and press Split at t.");
  const slopes = figure.pieces.slice(1).map(({ curve }) => Math.abs(curve.tangent(0).y));
  const level = slopes.some((slope) => slope < LEVEL);
  return verdict(
    level,
    level
      ? "The new point is the highest: both of its handles are horizontal."
      : "The new point is not the highest. Undo, and find the t with a horizontal tangent.",
  );
}

/** @param {{ figure: any, undo(): void, insertJoint(t?: number): void, t: number }} element */
export function reveal(element) {
  const [t] = firstCurve(element.figure).extrema().y;
  if (t === undefined) return;
  element.t = t;
  element.insertJoint(t);
}
