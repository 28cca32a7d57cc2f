import { lengthOf, formatNumber, verdict } from "./utils/surfaces.js";

export const predict = {
  options: ["No: where a derivative vanishes, there is no normal", "Yes: the limit from inside the patch"],
  answer: 1,
  because: "The surface is smooth there, only the parameters are not: all u lead to the same point.",
};

/** Of the longer derivative: less is no length. */
const NOTHING = 1e-6;

/** @param {{ surface: any, patch: number | null, u: number, v: number, place: { normal: number[] } | null }} figure */
export function check({ surface, patch, u, v, place }) {
  if (patch === null || !place) return verdict(false, "Click a patch of the lid first.");
  const partials = surface.patch(patch).partials(u, v);
  const [along, across] = [lengthOf(partials.u), lengthOf(partials.v)];
  if (along > NOTHING * across) return verdict(false, `Here the derivative along u is ${formatNumber(along)} long.`);
  return verdict(
    true,
    `Here it has no length, and the normal is (${place.normal.map((x) => formatNumber(x + 0)).join(", ")}).`,
  );
}

/** @param {any} element */
export const reveal = (element) => void Object.assign(element, { patch: 0, v: 0 });
