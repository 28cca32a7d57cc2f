import { verdict } from "./utils/curves.js";

export const predict = {
  options: ["none", "two", "six"],
  answer: 1,
  because: "Two legs of the polygon may cross without the curve doing so: it only leans towards its corners.",
};

/** @param {unknown} _figure @param {{ chosen: number, curve(order: number): any }} element the site's figure of all orders */
export function check(_figure, element) {
  const [place] = element.curve(element.chosen).selfIntersections();
  if (!place) return verdict(false, "This one does not cross itself.");
  return verdict(true, `It passes the same place at t = ${place.t.toFixed(2)} and at t = ${place.u.toFixed(2)}.`);
}

/** @param {{ chosen: number, curve(order: number): any }} element */
export function reveal(element) {
  for (let order = 0; order < 24; order++) {
    if (element.curve(order).selfIntersections().length === 0) continue;
    element.chosen = order;
    return;
  }
}
