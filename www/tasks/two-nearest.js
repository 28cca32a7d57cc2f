import { feet } from "../figures/lib/nearest.js";
import { verdict } from "./utils/curves.js";

/** A step of an arrow key changes the distances by more than 6 % of the smaller one. */
const ALLOWED_PERCENT = 4;

export const predict = {
  options: ["It stays where it is", "It moves a little, too", "It jumps to another part of the curve"],
  answer: 2,
  because:
    "On one side of this place the first minimum is the smaller one, on the other side the second. Programs that follow the nearest point must expect such jumps.",
};

/** @param {unknown} _figure @param {{ q: [number, number], curve: any }} element the site's figure of the nearest point */
export function check(_figure, { q, curve }) {
  const [best, second] = feet(curve, q);
  if (!second) return verdict(false, "The distance has only one local minimum. Move Q between two parts of the curve.");
  const more = second.distance - best.distance;
  const words = `The distances are ${best.distance.toFixed(1)} and ${second.distance.toFixed(1)}`;
  if (more === 0) return verdict(true, `${words}.`);
  return verdict(
    100 * more <= ALLOWED_PERCENT * best.distance,
    `${words}: the second is ${((100 * more) / best.distance).toFixed(1)} % greater.`,
  );
}

/** Bisects the line from P0 to P3, to where the nearest point changes its half of the curve. @param {{ q: [number, number], curve: any }} element */
export function reveal(element) {
  const { curve } = element;
  let [left, right] = [0, 1].map((t) => curve.eval(t)).map(({ x, y }) => /** @type {[number, number]} */ ([x, y]));
  for (let k = 0; k < 50; k++) {
    const middle = /** @type {[number, number]} */ ([(left[0] + right[0]) / 2, (left[1] + right[1]) / 2]);
    if (feet(curve, middle)[0].t < 0.5) left = middle;
    else right = middle;
  }
  element.q = left;
}
