import { Curve } from "casteljau";
import { verdict } from "./utils/curves.js";

export const predict = {
  options: ["at t = ¼", "at t = ⅓", "at t = ½"],
  answer: 0,
  because: "(1 − t)³ = 3(1 − t)²t means 1 − t = 3t. At ⅓ the weight of P1 is at its greatest.",
};

/** @param {{ t: number }} figure */
export function check({ t }) {
  const [w0, w1] = Curve.bernstein(3, t);
  return verdict(
    Math.abs(w0 - w1) < 0.02,
    `At t = ${t.toFixed(2)} P0 weighs ${w0.toFixed(2)} and P1 ${w1.toFixed(2)}.`,
  );
}

/** @param {{ t: number }} element */
export const reveal = (element) => {
  element.t = 0.25;
};
