import { px, verdict } from "./utils/curves.js";

/** The error that is allowed, and the pieces that are enough for it. */
const ALLOWED = 0.5;
const ENOUGH = 32;

export const predict = {
  options: ["The tolerance itself", "Less than the tolerance", "More than the tolerance"],
  answer: 2,
  because:
    "For small pieces the length that is missing is far smaller than the distance: D1 − D2 is no bound for what the eye sees.",
};

/** @param {{ tree: { segments: number, error: number } | null }} figure */
export function check({ tree }) {
  if (!tree) return verdict(false, "Show the tree first.");
  const words = `${tree.segments} pieces, measured error ${px(tree.error)}.`;
  if (tree.error >= ALLOWED) return verdict(false, `${words} Not close enough.`);
  return verdict(
    tree.segments <= ENOUGH,
    tree.segments <= ENOUGH ? words : `${words} Too many: a larger tolerance will do.`,
  );
}

/** @param {{ tolerance: string }} element */
export function reveal(element) {
  element.tolerance = "0.0625";
}
