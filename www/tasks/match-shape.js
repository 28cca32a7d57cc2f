import { Curve } from "casteljau";
import { PRECISION_PX, apart, firstCurve, px, verdict } from "./utils/curves.js";

/** The curve to be found; the page shows it dashed. */
export const TARGET = /** @type {[number, number][]} */ ([
  [110, 370],
  [30, 40],
  [520, 30],
  [560, 330],
]);

/** @param {{ pieces: { curve: any }[] }} figure */
export function check(figure) {
  const gap = apart(firstCurve(figure), new Curve(TARGET));
  return verdict(
    gap <= PRECISION_PX,
    gap <= PRECISION_PX ? `The greatest distance is ${px(gap)}.` : `The greatest distance is still ${px(gap)}.`,
  );
}

/** @param {{ points: [number, number][] }} element */
export const reveal = (element) => {
  element.points = TARGET;
};
