import { verdict } from "./utils/curves.js";
import { movedPoints } from "./utils/moved.js";

/** The control points of the site's figure. @type {[number, number][]} */
export const POINTS = [
  [14, 62],
  [43, 57],
  [84, 40],
  [67, 23],
];

/** The radius may be greater than the smallest one by this factor. */
const ALLOWED = 1.01;
/** Where the smallest radius is looked for. */
const STEPS = 1000;

/** @param {{ curvature(t: number): number }} curve */
const sharpest = (curve) =>
  Array.from({ length: STEPS + 1 }, (_, i) => i / STEPS).reduce((best, t) =>
    Math.abs(curve.curvature(t)) > Math.abs(curve.curvature(best)) ? t : best,
  );

/** @param {number} curvature */
const radiusOf = (curvature) => (curvature === 0 ? Infinity : 1 / Math.abs(curvature));

export const predict = {
  options: ["At the start", "In the middle, at t = 0.5", "Near P2, between t = 0.5 and t = 1"],
  answer: 2,
  because: "The control polygon has its sharpest corner at P2, and the curve follows the polygon.",
};

/** @param {unknown} _figure @param {{ points: [number, number][], t: number, curve: any }} element the site's figure of the derivative */
export function check(_figure, { points, t, curve }) {
  const moved = movedPoints(points, POINTS);
  if (moved) return moved;
  const radius = radiusOf(curve.curvature(t));
  const done = radius <= ALLOWED * radiusOf(curve.curvature(sharpest(curve)));
  return verdict(done, `At t = ${t.toFixed(2)} the radius of curvature is ${radius.toFixed(1)}.`);
}

/** @param {{ points: [number, number][], t: number, curve: any }} element */
export const reveal = (element) => {
  element.points = POINTS;
  element.t = Math.round(100 * sharpest(element.curve)) / 100;
};
