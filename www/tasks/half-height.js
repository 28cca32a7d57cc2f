import { verdict } from "./utils/curves.js";

export const predict = {
  options: ["at t = 0.5", "at t ≈ 0.71", "at t = 0.25"],
  answer: 1,
  because: "The height is t², and 0.71² ≈ 0.5. Equal steps of t do not give equal steps of height.",
};

/** @param {unknown} _figure @param {{ t: number }} element */
export function check(_figure, { t }) {
  const height = t * t;
  return verdict(
    t > 0 && Math.abs(height - 0.5) <= 0.0101,
    `At t = ${t.toFixed(2)} the height is ${height.toFixed(2)}.`,
  );
}

/** @param {{ t: number }} element */
export const reveal = (element) => {
  element.t = 0.71;
};
