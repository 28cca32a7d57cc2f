import { verdict } from "./utils/curves.js";

export const live = true;

export const predict = {
  options: ["none", "two", "six"],
  answer: 1,
  because:
    "The legs of the polygon cross more often, but a curve does not have to cross itself where its polygon does.",
};

/** @param {unknown} _figure @param {{ chosen: number, curve(order: number): any }} element the site's figure of all orders */
export function check(_figure, element) {
  const [place] = element.curve(element.chosen).selfIntersections();
  if (!place) return verdict(false, "The selected curve does not cross itself.");
  return verdict(
    true,
    `The selected curve crosses itself: t = ${place.t.toFixed(2)} and t = ${place.u.toFixed(2)} give the same point.`,
  );
}

/** @param {{ chosen: number, curve(order: number): any }} element */
export function reveal(element) {
  for (let order = 0; order < 24; order++) {
    if (element.curve(order).selfIntersections().length === 0) continue;
    element.chosen = order;
    return;
  }
}
