import { verdict } from "./utils/curves.js";
import { movedPoints } from "./utils/moved.js";

/** The places of the points of the site's figure. @type {[number, number][]} */
const PLACES = [
  [8, 64],
  [37, 16],
  [76, 28],
  [92, 51],
];

export const predict = {
  options: ["two", "four", "eight"],
  answer: 1,
  because:
    "Only the diagonals AC and BD cross. The first leg is one of them, the last leg is the other: 8 of the 24 orders, so 4 of the 12 shapes. Only two of these four curves cross themselves.",
};

/** @param {unknown} _figure @param {{ places: [number, number][], chosen: number, curve(order: number): any }} element the site's figure of all orders */
export function check(_figure, element) {
  const moved = movedPoints(element.places, PLACES, (figure) => (figure.places = PLACES));
  if (moved) return moved;
  const [place] = element.curve(element.chosen).selfIntersections();
  if (!place) return verdict(false, "The selected curve does not cross itself.");
  return verdict(
    true,
    `The selected curve crosses itself: t = ${place.t.toFixed(2)} and t = ${place.u.toFixed(2)} give the same point.`,
  );
}

/** @param {{ places: [number, number][], chosen: number, curve(order: number): any }} element */
export function reveal(element) {
  element.places = PLACES;
  for (let order = 0; order < 24; order++) {
    if (element.curve(order).selfIntersections().length === 0) continue;
    element.chosen = order;
    return;
  }
}
