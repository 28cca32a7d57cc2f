import { distance, verdict } from "./utils/curves.js";

const WANTED = /** @type {const} */ ([0.6, 0.8]);
/** A slider in steps of a hundredth moves the point by up to 0.02. */
const ALLOWED = 0.01;

export const predict = {
  options: ["at t = 0.5", "at t ≈ 0.59, the part of the angle", "at t = 0.6"],
  answer: 0,
  because:
    "(1 − t²) / (1 + t²) = 0.6 gives t² = 0.4 / 1.6 = ¼. The angle is 53.1° there, 0.59 of 90°: equal steps of t are not equal angles.",
};

/** @param {unknown} _figure @param {{ t: number, point: [number, number] }} element the site's figure of the projection */
export function check(_figure, { t, point }) {
  const [x, y] = point.map((value) => value.toFixed(3));
  return verdict(distance(point, WANTED) <= ALLOWED, `At t = ${t.toFixed(2)} the point of the circle is (${x}, ${y}).`);
}

/** @param {{ t: number }} element */
export const reveal = (element) => {
  element.t = 0.5;
};
