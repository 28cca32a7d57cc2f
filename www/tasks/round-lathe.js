import { verdict } from "./utils/surfaces.js";

/** In parts of the radius. */
const ALLOWED = 0.0003;

export const predict = {
  options: ["With a smaller κ", "With a larger κ", "With no κ: it has to be a polygon"],
  answer: 0,
  because:
    "With κ = 0.56 the middle of each quarter is outside of the circle. κ = 4(√2 − 1)/3 ≈ 0.5523 puts it on the circle; between it and the ends the curve is still up to 0.027 % outside.",
};

/** @param {unknown} _figure @param {{ handle: number, error: number }} element the site's lathe */
export function check(_figure, { handle, error }) {
  const words = `κ = ${handle.toFixed(4)}: the difference is up to ${(100 * error).toFixed(3)} % of the radius.`;
  return verdict(error <= ALLOWED, words);
}

/** @param {{ handle: number }} element */
export const reveal = (element) => void Object.assign(element, { handle: 0.5521 });
