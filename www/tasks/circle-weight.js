import { circleWeight } from "../figures/lib/circle.js";
import { verdict } from "./utils/curves.js";

export const live = true;

const ALLOWED = 0.01;

export const predict = {
  options: ["w = ½", "w = √½ ≈ 0.71", "w = 1"],
  answer: 1,
  because:
    "The legs of the polygon make an angle of 45° with the chord, and cos 45° = √½. With w = ½ they would have to make 60°; w = 1 is a parabola.",
};

/** @param {unknown} _figure @param {{ points: any[], weight: number }} element the site's figure of the conic */
export function check(_figure, { points, weight }) {
  const circle = circleWeight(points);
  const w = weight.toFixed(2);
  if (circle === null)
    return verdict(false, "For a circle both legs must be equally long, and P1 off the chord: move P1 back.");
  if (Math.abs(weight - circle) <= ALLOWED) return verdict(true, `w = ${w}: an arc of a circle.`);
  const side = weight < circle ? "flatter than the circle" : "more pointed than the circle";
  return verdict(false, `w = ${w}: the arc is ${side}.`);
}

/** @param {{ points: any[], weight: number }} element */
export const reveal = (element) => {
  element.weight = Math.round(100 * (circleWeight(element.points) ?? Math.SQRT1_2)) / 100;
};
