import { Curve } from "casteljau";
import { PRECISION_PX, apart, firstCurve, px, verdict } from "./utils/curves.js";

/** The quadratic that the cubic must become; the page shows it dashed. */
export const QUADRATIC = /** @type {[number, number][]} */ ([
  [80, 390],
  [335, 30],
  [590, 390],
]);

export const predict = {
  options: ["half of the way", "two thirds of the way", "all the way"],
  answer: 1,
  because:
    "Let Q1 be the middle point of the quadratic. The velocity of a cubic at P0 is 3(P1 − P0), that of a quadratic is 2(Q1 − P0). They are equal if P1 is two thirds of the way to Q1.",
};

/** @param {{ pieces: { curve: any }[] }} figure */
export function check(figure) {
  const gap = apart(firstCurve(figure), new Curve(QUADRATIC));
  return verdict(
    gap <= PRECISION_PX / 2,
    gap <= PRECISION_PX / 2
      ? "Both curves are equal at each t."
      : `At equal t the greatest distance is still ${px(gap)}.`,
  );
}

/** @param {{ points: [number, number][] }} element */
export function reveal(element) {
  const [p0, q1, p2] = QUADRATIC;
  const third = (/** @type {[number, number]} */ end) =>
    /** @type {[number, number]} */ ([end[0] / 3 + (2 * q1[0]) / 3, end[1] / 3 + (2 * q1[1]) / 3]);
  element.points = [p0, third(p0), third(p2), p2];
}
