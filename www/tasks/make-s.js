import { firstCurve, verdict } from "./utils/curves.js";

/** @param {{ pieces: { curve: any }[] }} figure */
export function check(figure) {
  const curve = firstCurve(figure);
  if (curve.degree < 3) return verdict(false, "A quadratic has no inflection. Use the cubic.");
  const bends = curve.inflections().filter((/** @type {number} */ t) => t > 0 && t < 1);
  if (bends.length === 1) return verdict(true, `One inflection, at t = ${bends[0].toFixed(2)}.`);
  return verdict(false, bends.length === 0 ? "There is no inflection." : "There are two inflections.");
}

/** Its inflection is not at t = ½, which the next task asks for. @param {{ points: [number, number][] }} element */
export const reveal = (element) => {
  element.points = [
    [90, 390],
    [430, 470],
    [110, 10],
    [580, 250],
  ];
};
