import { firstCurve, verdict } from "./utils/curves.js";

/** @param {{ pieces: { curve: any }[] }} figure */
export function check(figure) {
  const curve = firstCurve(figure);
  if (curve.degree < 3) return verdict(false, "A quadratic turns to one side only. Take the cubic.");
  const bends = curve.inflections().filter((/** @type {number} */ t) => t > 0 && t < 1);
  if (bends.length === 1) return verdict(true, `An S: it changes its side at t = ${bends[0].toFixed(2)}.`);
  return verdict(
    false,
    bends.length === 0
      ? "It turns to one side only."
      : "Two inflections: it turns to one side, to the other, and back.",
  );
}

/** @param {{ points: [number, number][] }} element */
export const reveal = (element) => {
  element.points = [
    [90, 390],
    [560, 470],
    [110, 10],
    [580, 90],
  ];
};
