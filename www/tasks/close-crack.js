import { verdict } from "./utils/surfaces.js";

const LEFT = 4;
const NOTHING = 1e-9;

export const predict = {
  options: ["Right: 2, half as many", "Right: 4, the same", "Right: 8, twice as many"],
  answer: 1,
  because: "With twice or half as many, some vertices coincide, but the chords between them do not.",
};

/** @param {{ left: number, right: number, gap: number }} figure */
export function check({ left, gap }) {
  if (left !== LEFT) return verdict(false, `Set the left patch back to ${LEFT} segments.`);
  return verdict(gap < NOTHING, gap < NOTHING ? "Closed." : `Still ${gap.toFixed(1)} apart.`);
}

/** @param {any} element */
export const reveal = (element) => void Object.assign(element, { left: LEFT, right: LEFT });
