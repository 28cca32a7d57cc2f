import { verdict } from "./utils/surfaces.js";

const ALLOWED = 0.003;

export const predict = {
  options: ["w = ½", "w = √½ ≈ 0.71", "w = 1, without weights"],
  answer: 1,
  because:
    "The profile and the circles are quarters of a circle. Both need the weight cos 45° = √½ in their middle, and the point in the middle of the net has the product, ½.",
};

/** @param {unknown} _figure @param {{ weight: number, error: number }} element the site's figure of the patch */
export function check(_figure, { weight, error }) {
  const side = weight < Math.SQRT1_2 ? "flatter" : "more pointed";
  const words = `w = ${weight.toFixed(2)}: up to ${error.toFixed(4)} from the sphere`;
  return error <= ALLOWED ? verdict(true, `${words}.`) : verdict(false, `${words}, the patch is ${side}.`);
}

/** @param {{ weight: number }} element */
export const reveal = (element) => void Object.assign(element, { weight: 0.71 });
