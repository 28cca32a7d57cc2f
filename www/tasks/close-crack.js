import { verdict } from "./utils/surfaces.js";

const LEFT = 4;
/** Wider gaps are cracks. */
const MAX_GAP = 1e-9;

export const predict = {
  options: ["Right: 2, half as many", "Right: 4, the same", "Right: 8, twice as many"],
  answer: 1,
  because: "With half or twice as many segments, some vertices coincide, but the segments between them do not.",
};

/** @param {{ left: number, right: number, gap: number }} figure */
export function check({ left, gap }) {
  if (left !== LEFT) return verdict(false, `Set the left patch back to ${LEFT} segments.`);
  return verdict(
    gap < MAX_GAP,
    gap < MAX_GAP ? "The crack is closed." : `The crack is still up to ${gap.toFixed(1)} units wide.`,
  );
}

/** @param {any} element */
export const reveal = (element) => void Object.assign(element, { left: LEFT, right: LEFT });
