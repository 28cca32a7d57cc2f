import { Curve } from "casteljau";
import { apart, firstCurve, px, verdict } from "./utils/curves.js";

/** [t³ t² t 1]·M·P = P0 + t (P3 − P0) */
const STRAIGHT = [0, 0, 0, 0, 0, 0, 0, 0, -1, 0, 0, 1, 1, 0, 0, 0];

/** @param {{ basis: string, points: [number, number][], pieces: { curve: any }[] }} figure */
export function check(figure) {
  if (figure.basis !== "matrix") return verdict(false, "Change a number of the matrix.");
  const curve = firstCurve(figure);
  if (!curve) return verdict(false, "This matrix does not give a curve.");
  const gap = apart(curve, new Curve([figure.points[0], figure.points[3]]));
  return verdict(
    gap < 0.5,
    gap < 0.5
      ? "This is the line from P0 to P3 at constant speed."
      : `At equal t the greatest distance from the line is ${px(gap)}.`,
  );
}

/** @param {{ matrix: number[], basis: string }} element */
export function reveal(element) {
  element.basis = "matrix";
  element.matrix = STRAIGHT;
}
