import { lengthOf, formatNumber, verdict } from "./utils/surfaces.js";

export const predict = {
  options: ["For every u, at v = 0", "For every v, at u = 0", "Only at u = v = 0"],
  answer: 0,
  because: "Sᵤ is zero where a step in u does not move the point: on the side along which u runs. There v is constant.",
};

/** The limit that the task states, relative to the length of S_v. */
const MAX_RATIO = 1e-6;

/** @param {{ surface: any, patch: number | null, u: number, v: number, place: { normal: number[] } | null }} figure */
export function check({ surface, patch, u, v, place }) {
  if (patch === null || !place) return verdict(false, "Click a patch of the lid first.");
  const partials = surface.patch(patch).partials(u, v);
  const [along, across] = [lengthOf(partials.u), lengthOf(partials.v)];
  if (along > MAX_RATIO * across) return verdict(false, `Here the length of Sᵤ is ${formatNumber(along)}.`);
  return verdict(
    true,
    `Here the length of Sᵤ is zero, and the normal is (${place.normal.map((x) => formatNumber(x + 0)).join(", ")}).`,
  );
}

/** @param {any} element */
export const reveal = (element) => void Object.assign(element, { patch: 0, v: 0 });
