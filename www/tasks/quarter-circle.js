import { maxRadialError } from "../figures/lib/circle.js";
import { verdict } from "./utils/curves.js";

const ARCS = 4;
/** Of the radius. */
const ALLOWED = 0.00025;
/** The handle with the smallest greatest error, to four places. */
const BEST = 0.5519;

export const predict = {
  options: ["about 0.3 mm", "about 3 mm", "about 3 cm"],
  answer: 0,
  because:
    "With h = 0.5523 the curve is never inside the circle and up to 0.027 % outside. A slightly smaller h makes it equally wrong on both sides: 0.020 %.",
};

/** @param {unknown} _figure @param {{ arcs: number, length: number }} element the site's figure of the circle */
export function check(_figure, { arcs, length }) {
  if (arcs !== ARCS) return verdict(false, "Choose four arcs.");
  const error = maxRadialError(arcs, length);
  return verdict(error < ALLOWED, `h = ${length.toFixed(4)}: the error is ${(100 * error).toFixed(4)} %.`);
}

/** @param {{ arcs: number, length: number }} element */
export const reveal = (element) => void Object.assign(element, { arcs: ARCS, length: BEST });
