import { Curve } from "casteljau";
import { PRECISION_PX, apart, firstCurve, px, verdict } from "./utils/curves.js";

/** The quadratic that the cubic must become; the page shows it dashed. */
export const QUADRATIC = /** @type {[number, number][]} */ ([
  [80, 390],
  [335, 30],
  [590, 390],
]);

export const predict = {
  options: ["half-way to the corner of the old polygon", "two thirds of the way to the corner", "all the way"],
  answer: 1,
  because:
    "A cubic leaves P0 with 3(P1 − P0), a quadratic with 2(Q1 − P0): equal when P1 is two thirds of the way to Q1.",
};

/** @param {{ pieces: { curve: any }[] }} figure */
export function check(figure) {
  const gap = apart(firstCurve(figure), new Curve(QUADRATIC));
  return verdict(
    gap <= PRECISION_PX / 2,
    gap <= PRECISION_PX / 2
      ? "The cubic runs like the quadratic, at the same speed."
      : `Still up to ${px(gap)} apart at the same t.`,
  );
}

/** @param {{ points: [number, number][] }} element */
export function reveal(element) {
  const [p0, q1, p2] = QUADRATIC;
  const third = (/** @type {[number, number]} */ end) =>
    /** @type {[number, number]} */ ([end[0] / 3 + (2 * q1[0]) / 3, end[1] / 3 + (2 * q1[1]) / 3]);
  element.points = [p0, third(p0), third(p2), p2];
}
