import { verdict } from "./utils/curves.js";

const WORDS = {
  bezier: "Bézier: it touches P0 and P3 only.",
  hermite: "Hermite: P0 and P3 again; the other two set the speed there.",
  "b-spline": "B-spline: it touches none of the four.",
  "catmull-rom": "Catmull–Rom: it runs from P1 to P2.",
};

export const predict = {
  options: ["Bézier", "Hermite", "B-spline", "Catmull–Rom"],
  answer: 3,
  because: "Its last row, which is all that counts at t = 0, is 0 1 0 0: the curve begins in P1.",
};

/** @param {{ basis: string }} figure */
export function check({ basis }) {
  return verdict(
    basis === "catmull-rom",
    WORDS[/** @type {keyof typeof WORDS} */ (basis)] ?? "That is another basis: choose one of the four.",
  );
}

/** @param {{ basis: string }} element */
export const reveal = (element) => {
  element.basis = "catmull-rom";
};
