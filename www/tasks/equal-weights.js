import { Curve } from "casteljau";
import { verdict } from "./utils/curves.js";

export const predict = {
  options: ["at t = ½", "at t = ⅔", "at t = ¾"],
  answer: 2,
  because: "Divide 3(1 − t)t² = t³ by t²: 3(1 − t) = t, so t = ¾. At t = ⅔ the weight of P2 has its maximum.",
};

/** @param {{ t: number }} figure */
export function check({ t }) {
  const [, , w2, w3] = Curve.bernstein(3, t);
  return verdict(
    t > 0.5 && Math.abs(w2 - w3) < 0.02,
    `At t = ${t.toFixed(2)} P2 has the weight ${w2.toFixed(2)} and P3 has ${w3.toFixed(2)}.`,
  );
}

/** @param {{ t: number }} element */
export const reveal = (element) => {
  element.t = 0.75;
};
