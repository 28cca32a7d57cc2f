import { verdict } from "./utils/curves.js";
import { movedPoints } from "./utils/moved.js";

/** In units of the figure: the sliders come no closer with two knots that are not equal. */
const ALLOWED = 0.001;
/** The control points of the site's figure. @type {[number, number][]} */
export const POINTS = [
  [14, 64],
  [24, 24],
  [67, 16],
  [110, 24],
  [120, 64],
];

export const predict = {
  options: ["A large weight of P2", "Two equal knots", "Neither: P2 only attracts the curve"],
  answer: 1,
  because:
    "A large weight brings the curve close to P2, but not to it. At a double knot of a quadratic all factors except that of P2 are 0. There two Bézier curves meet.",
};

/** @param {unknown} _figure @param {{ points: [number, number][], weight: number, first: number, second: number, curve: import("casteljau/nurbs").NurbsCurve }} element the site's figure of a NURBS curve */
export function check(_figure, { points, weight, first, second, curve }) {
  const moved = movedPoints(points, POINTS);
  if (moved) return moved;
  const { distance: nearest } = curve.nearest(points[2]);
  const words = `The curve is ${nearest.toFixed(3)} away from P2. The weight of P2 is ${weight.toFixed(1)}, and the inner knots are ${(second - first).toFixed(2)} apart.`;
  return verdict(nearest <= ALLOWED, words);
}

/** @param {{ points: [number, number][], first: number, second: number }} element */
export const reveal = (element) => void Object.assign(element, { points: POINTS, first: 0.5, second: 0.5 });
