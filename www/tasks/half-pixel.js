import { firstCurve, polylineError, px, verdict } from "./utils/curves.js";

/** What eyes forgive: half a pixel. */
const FORGIVEN = 0.5;

export const predict = {
  options: ["about 8", "about 25", "about 60", "about 200"],
  answer: 1,
  because: "The error falls with the square of the number of segments: twice as many are four times as close.",
};

/** @param {{ pieces: { curve: any }[] }} figure @param {{ segments: string | number }} element its attribute, as a property */
export function check(figure, element) {
  const segments = Number(element.segments);
  const curve = firstCurve(figure);
  const error = polylineError(curve, segments);
  if (error >= FORGIVEN) return verdict(false, `${segments} segments: the curve strays by ${px(error)}.`);
  const spare = segments > 1 && polylineError(curve, segments - 1) < FORGIVEN;
  return verdict(!spare, `${segments} segments: ${px(error)}. ${spare ? "Fewer will do." : "One less would not do."}`);
}

/** @param {{ figure: any, segments: string | number }} element */
export function reveal(element) {
  const curve = firstCurve(element.figure);
  let segments = 1;
  while (polylineError(curve, segments) >= FORGIVEN) segments += 1;
  element.segments = String(segments);
}
