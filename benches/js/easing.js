// Timing functions, compared with bezier-easing.
import bezier from "bezier-easing";
import { easing } from "casteljau";
import { assertSame } from "./harness.js";
import { parameters } from "./inputs.js";

/** The error of bezier-easing where the derivative of x is not small. */
const TOLERANCE = 1e-7;
const CALLS = 1000;

/** The keywords of CSS and other common curves. @type {[number, number, number, number][]} */
const HANDLES = [
  [0.25, 0.1, 0.25, 1],
  [0.42, 0, 1, 1],
  [0, 0, 0.58, 1],
  [0.42, 0, 0.58, 1],
  [0.68, -0.55, 0.265, 1.55],
  [0.9, 0.1, 0.1, 0.9],
  [0.1, 0.7, 0.3, 0.2],
  [0.19, 1, 0.22, 1],
];
const theirs = HANDLES.map((handles) => bezier(...handles));
const ours = HANDLES.map((handles) => easing(...handles));
const xs = parameters(CALLS);

function check() {
  theirs.forEach((their, k) =>
    assertSame(`easing ${HANDLES[k]}`, Array.from(xs, their), Array.from(xs, ours[k]), TOLERANCE),
  );
}

/** @param {((x: number) => number)[]} functions */
const total = (functions) => {
  let sum = 0;
  for (let i = 0; i < CALLS; i++) sum += functions[i & 7](xs[i]);
  return sum;
};

/** @type {import("./harness.js").Row[]} */
export const rows = [
  {
    id: "easing",
    work: "CSS easing, one call",
    peer: "bezier-easing",
    items: CALLS,
    check,
    theirs: () => total(theirs),
    ours: () => total(ours),
  },
];
