import { Curve } from "casteljau";
import { verdict } from "./utils/curves.js";

export const predict = {
  options: ["at t = ¼", "at t = ⅓", "at t = ½"],
  answer: 0,
  because: "Divide (1 − t)³ = 3(1 − t)²t by (1 − t)²: 1 − t = 3t, so t = ¼. At t = ⅓ the weight of P1 has its maximum.",
};

/** @param {{ t: number }} figure */
export function check({ t }) {
  const [w0, w1] = Curve.bernstein(3, t);
  return verdict(
    Math.abs(w0 - w1) < 0.02,
    `At t = ${t.toFixed(2)} P0 has the weight ${w0.toFixed(2)} and P1 has ${w1.toFixed(2)}.`,
  );
}

/** @param {{ t: number }} element */
export const reveal = (element) => {
  element.t = 0.25;
};
