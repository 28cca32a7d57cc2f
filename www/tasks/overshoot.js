import { easing } from "casteljau";
import { verdict } from "./utils/curves.js";

/** The four numbers of a cubic-bezier(). @param {string} value */
const numbersOf = (value) => [...value.matchAll(/-?\d*\.?\d+(?:e[-+]?\d+)?/gi)].map(Number).slice(0, 4);

/** @param {unknown} _figure @param {{ value: string }} element */
export function check(_figure, { value }) {
  const [x1, y1, x2, y2] = numbersOf(value);
  const ease = easing(x1, y1, x2, y2);
  const most = Math.max(...Array.from({ length: 101 }, (_, i) => ease(i / 100)));
  const past = Math.max(0, most - 1) * 100;
  const done = past >= 10 && past <= 20;
  return verdict(
    done,
    `It goes ${past.toFixed(1)} % past its final place.${done ? "" : past > 20 ? " That is too much." : " That is not enough."}`,
  );
}

/** @param {{ value: string }} element */
export const reveal = (element) => {
  element.value = "cubic-bezier(0.34, 1.6, 0.64, 1)";
};
