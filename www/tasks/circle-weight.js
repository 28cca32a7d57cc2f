import { verdict } from "./utils/curves.js";
import { movedPoints } from "./utils/moved.js";

const ALLOWED = 0.01;
/** The control points of the site's figure. @type {[number, number][]} */
export const POINTS = [
  [29, 50],
  [67, 12],
  [105, 50],
];

export const predict = {
  options: ["w = ½", "w = √½ ≈ 0.71", "w = 1"],
  answer: 1,
  because:
    "The legs of the polygon make an angle of 45° with the chord, and cos 45° = √½. With w = ½ they would have to make 60°; w = 1 is a parabola.",
};

/** @param {unknown} _figure @param {{ points: any[], weight: number }} element the site's figure of the conic */
export function check(_figure, { points, weight }) {
  const moved = movedPoints(points, POINTS);
  if (moved) return moved;
  const w = weight.toFixed(2);
  if (Math.abs(weight - Math.SQRT1_2) <= ALLOWED) return verdict(true, `w = ${w}: an arc of a circle.`);
  const side = weight < Math.SQRT1_2 ? "flatter than the circle" : "more pointed than the circle";
  return verdict(false, `w = ${w}: the arc is ${side}.`);
}

/** @param {{ points: any[], weight: number }} element */
export const reveal = (element) => {
  element.points = POINTS;
  element.weight = 0.71;
};
