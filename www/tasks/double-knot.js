import { distance, verdict } from "./utils/curves.js";

export const live = true;

/** In units of the figure: the sliders come no closer with two knots that are not equal. */
const ALLOWED = 0.001;
/** Points that are closer than this are in one place. */
const ONE_PLACE = 0.5;

export const predict = {
  options: ["A large weight of P2", "Two equal knots", "Neither: P2 only attracts the curve"],
  answer: 1,
  because:
    "A large weight brings the curve close to P2, but not to it. At a double knot of a quadratic all factors except that of P2 are 0. There two Bézier curves meet.",
};

/** @param {unknown} _figure @param {{ points: [number, number][], weight: number, first: number, second: number, curve: import("casteljau/nurbs").NurbsCurve }} element the site's figure of a NURBS curve */
export function check(_figure, { points, weight, first, second, curve }) {
  const { distance: nearest } = curve.nearest(points[2]);
  const isOnePlace = distance(points[1], points[2]) <= ONE_PLACE || distance(points[2], points[3]) <= ONE_PLACE;
  const gap = second - first;
  if (isOnePlace || (nearest <= ALLOWED && gap > 0))
    return verdict(
      false,
      "The points have moved to where the curve meets P2 anyway. Move them back, and use the sliders.",
    );
  const words = `The curve is ${nearest.toFixed(3)} away from P2. The weight of P2 is ${weight.toFixed(1)}, and the inner knots are ${gap.toFixed(2)} apart.`;
  return verdict(nearest <= ALLOWED, words);
}

/** @param {{ first: number, second: number }} element */
export const reveal = (element) => void Object.assign(element, { first: 0.5, second: 0.5 });
