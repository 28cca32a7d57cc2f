import { verdict } from "./utils/curves.js";

/** The noise of the points as the page has it, the most cubics, and the greatest distance of a point. */
const [NOISE, MAX_CUBICS, MAX_ERROR] = [1.5, 6, 2];

export const predict = {
  options: ["about 6", "about 15", "about 60"],
  answer: 2,
  because:
    "A tolerance below the noise makes the spline follow the noise: nearly every point gets a cubic of its own. As soon as the tolerance is greater than the noise, a few cubics are enough.",
};

/** @param {unknown} _figure @param {{ noise: number, fit: { cubics: number, error: number } }} element */
export function check(_figure, { noise, fit: { cubics, error } }) {
  if (noise !== NOISE)
    return {
      done: false,
      words: `The answer is asked for the noise ${NOISE}.`,
      restore: (/** @type {{ noise: number }} */ element) => (element.noise = NOISE),
    };
  const words = `${cubics} cubics, and the farthest point is ${error.toFixed(2)} away.`;
  return verdict(cubics <= MAX_CUBICS && error <= MAX_ERROR, words);
}

/** @param {{ noise: number, exponent: number }} element */
export const reveal = (element) => void Object.assign(element, { noise: NOISE, exponent: 1 });
