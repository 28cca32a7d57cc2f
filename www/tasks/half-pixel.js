import { firstCurve, polylineError, px, verdict } from "./utils/curves.js";
import { movedPoints } from "./utils/moved.js";

/** In pixels. */
const ALLOWED = 0.5;

/** The control points as the page places them. @type {[number, number][]} */
export const POINTS = [
  [60, 400],
  [160, 40],
  [480, 40],
  [600, 400],
];

export const predict = {
  options: ["about 8", "about 25", "about 60", "about 200"],
  answer: 1,
  because: "With twice as many segments the error is four times smaller: it decreases with the square of their number.",
};

/** @param {{ points: [number, number][], pieces: { curve: any }[] }} figure @param {{ segments: number }} element */
export function check(figure, element) {
  const moved = movedPoints(figure.points, POINTS);
  if (moved) return moved;
  const { segments } = element;
  const curve = firstCurve(figure);
  const error = polylineError(curve, segments);
  if (error >= ALLOWED) return verdict(false, `${segments} segments: the error is ${px(error)}. Too large.`);
  const spare = segments > 1 && polylineError(curve, segments - 1) < ALLOWED;
  return verdict(
    !spare,
    `${segments} segments: the error is ${px(error)}. ${spare ? "Fewer segments are enough." : "With one segment fewer it would be 0.5 px or more."}`,
  );
}

/** @param {{ points: [number, number][], figure: any, segments: number }} element */
export function reveal(element) {
  element.points = POINTS;
  const curve = firstCurve(element.figure);
  let segments = 1;
  while (polylineError(curve, segments) >= ALLOWED) segments += 1;
  element.segments = segments;
}
