import { distance, verdict } from "./utils/curves.js";

const WANTED = 2;
const ALLOWED = 0.05;

export const predict = {
  options: ["an ellipse", "a parabola", "a hyperbola"],
  answer: 2,
  because: "S divides the segment from M to P1 in the ratio w : 1, so w = 2. All weights above 1 give hyperbolas.",
};

/** @param {unknown} _figure @param {{ points: readonly [number, number][], middle: [number, number] }} element the site's figure of the conic */
export function check(_figure, { points: [p0, p1, p2], middle }) {
  const ratio = distance([(p0[0] + p2[0]) / 2, (p0[1] + p2[1]) / 2], middle) / distance(middle, p1);
  if (!Number.isFinite(ratio)) return verdict(false, "P1 lies at M: move it away from there.");
  return verdict(Math.abs(ratio - WANTED) <= ALLOWED, `S is ${ratio.toFixed(2)} times as far from M as from P1.`);
}

/** @param {{ weight: number }} element */
export const reveal = (element) => {
  element.weight = WANTED;
};
