import { firstCurve, verdict } from "./utils/curves.js";

/** A hundredth: the steps of the slider. */
const LEVEL = 0.04;

export const predict = {
  options: ["Yes, a little", "No, it stays as it is", "Only between the new points"],
  answer: 1,
  because:
    "Both halves lie on the old curve, point for point. Only the control polygon is another: closer than before.",
};

/** @param {{ pieces: { curve: any }[], continuity: { g1: boolean }[] }} figure */
export function check(figure) {
  if (figure.pieces.length < 2) return verdict(false, "It is one piece still. Slide t and press Cut at t.");
  const slopes = figure.pieces.slice(1).map(({ curve }) => Math.abs(curve.tangent(0).y));
  const level = slopes.some((slope) => slope < LEVEL);
  return verdict(
    level,
    level
      ? "The new joint is the top: both of its handles lie level."
      : "Cut, but not at the top. Undo, and look for the place where the tangent lies level.",
  );
}

/** @param {{ figure: any, undo(): void, insert(t?: number): void, t: number }} element */
export function reveal(element) {
  const [t] = firstCurve(element.figure).extrema().y;
  if (t === undefined) return;
  element.t = t;
  element.insert(t);
}
