import { verdict } from "./utils/surfaces.js";

const POINTS = 16;

export const predict = {
  options: ["Four", "Eight", "Sixteen"],
  answer: 1,
  because: "Four patches of the lid meet in the tip of the knob, and four patches of the bottom meet in its centre.",
};

/** @param {{ model: string, patch: number | null, surface: { patches: ArrayLike<number>[] } }} figure */
export function check({ model, patch, surface }) {
  if (model !== "teapot") return verdict(false, "Show the teapot again.");
  if (patch === null) return verdict(false, "Choose a patch with the slider of the table.");
  const points = new Set(Array.from(surface.patches[patch])).size;
  return verdict(
    points < POINTS,
    points < POINTS
      ? `Patch ${patch} has ${points} different control points: one of its sides is a single point.`
      : `Patch ${patch} has sixteen different control points.`,
  );
}

/** @param {any} element */
export const reveal = (element) => void Object.assign(element, { model: "teapot", parts: null, patch: 20 });
