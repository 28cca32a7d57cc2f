import { firstCurve, verdict } from "./utils/curves.js";

/** The sine of about 2°: what a slider in steps of a hundredth can reach. */
const LEVEL = 0.04;

export const predict = {
  options: ["Yes, a little", "No, it stays as it is", "Only between the new points"],
  answer: 1,
  because:
    "The two halves consist of exactly the same points as the old curve. Only the control polygon is different: it is closer to the curve.",
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

/** @param {{ figure: any, undo(): void, insert(t?: number): void, t: number }} element */
export function reveal(element) {
  const [t] = firstCurve(element.figure).extrema().y;
  if (t === undefined) return;
  element.t = t;
  element.insert(t);
}
