// Lengths, against bezier-js.
import { Bezier } from "bezier-js";
import { Curve } from "casteljau";
import { assertSame } from "./harness.js";
import { cubics } from "./inputs.js";

/**
 * bezier-js sums 24 nodes and does not look at the error: near a cusp it is that much off, of the length. Ours is right to
 * 10⁻¹², which the tests show.
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

let turn = 0;
const next = () => (turn = (turn + 1) & 63);

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
