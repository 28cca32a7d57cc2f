import { px, verdict } from "./utils/curves.js";
import { movedPoints } from "./utils/moved.js";

/** The error that is allowed, and the pieces that are enough for it. */
const ALLOWED = 0.5;
const ENOUGH = 48;

/** The control points as the page places them. @type {[number, number][]} */
export const POINTS = [
  [60, 300],
  [60, 20],
  [620, 20],
  [600, 300],
];

export const predict = {
  options: ["It equals the tolerance", "It is less than the tolerance", "It is greater than the tolerance"],
  answer: 2,
  because:
    "For short pieces D1 − D2 is much smaller than the distance between the curve and the line. D1 − D2 is no bound for that distance.",
};

/** @param {{ points: [number, number][], tree: { segments: number, error: number } | null }} figure */
export function check(figure) {
  const moved = movedPoints(figure.points, POINTS);
  if (moved) return moved;
  const { tree } = figure;
  if (!tree) return verdict(false, "Show the tree first.");
  const words = `${tree.segments} pieces, measured error ${px(tree.error)}.`;
  if (tree.error >= ALLOWED) return verdict(false, `${words} The error is too large.`);
  return verdict(
    tree.segments <= ENOUGH,
    tree.segments <= ENOUGH ? words : `${words} Too many pieces: use a larger tolerance.`,
  );
}

/** @param {{ points: [number, number][], tolerance: number }} element */
export function reveal(element) {
  element.points = POINTS;
  element.tolerance = 0.0625;
}
