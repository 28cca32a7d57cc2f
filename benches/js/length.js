// Arc lengths, compared with bezier-js.
import { Bezier } from "bezier-js";
import { Curve } from "casteljau";
import { assertSame } from "./harness.js";
import { cubics } from "./inputs.js";

/**
 * The relative error of bezier-js near a cusp: it uses 24 nodes and does not estimate its error. Ours is below 10⁻¹²,
 * which the tests check.
 */
const THEIR_ERROR = 5e-3;

const inputs = cubics(64);
const theirs = inputs.map((numbers) => new Bezier(numbers));
const ours = inputs.map((numbers) => new Curve(numbers));

function check() {
  ours.forEach((curve, k) => {
    const length = curve.length();
    assertSame("length", [theirs[k].length()], [length], THEIR_ERROR * length);
    const [left, right] = curve.halve();
    assertSame("length of halves", [left.length() + right.length()], [length], 1e-12 * length);
  });
}

let current = 0;
function next() {
  current = (current + 1) & 63;
  return current;
}

/** @type {import("./harness.js").Row[]} */
export const rows = [
  {
    id: "length",
    work: "length of a cubic, to 1e-12",
    peer: "bezier-js length",
    items: 1,
    check,
    theirs: () => theirs[next()].length(),
    ours: () => ours[next()].length(),
  },
];
