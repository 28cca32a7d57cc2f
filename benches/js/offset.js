// Parallel curves, against bezier-js. Its pieces may leave gaps and keep no tolerance; ours are within 0.1.
import { Bezier } from "bezier-js";
import { Curve } from "../../js/index.js";
import { assertSame } from "./harness.js";
import { cubics } from "./inputs.js";

const DISTANCE = 10;
const OPTIONS = { tolerance: 0.1 };
const inputs = cubics(64);
const theirs = inputs.map((numbers) => new Bezier(numbers));
const ours = inputs.map((numbers) => new Curve(numbers));

/** Both start and end beside the ends of the curve. */
function check() {
  inputs.forEach((_, k) => {
    const pieces = theirs[k].offset(DISTANCE);
    const [first, last] = [pieces[0].points[0], pieces[pieces.length - 1].points[3]];
    const points = ours[k].offset(DISTANCE, OPTIONS).controlPoints();
    assertSame("start", [first.x, first.y], points.subarray(0, 2), 1e-6);
    assertSame("end", [last.x, last.y], points.subarray(-2), 1e-6);
  });
}

/** @type {import("./harness.js").Row[]} */
export const rows = [
  {
    id: "offset",
    work: "offset by 10 to tolerance 0.1",
    peer: "bezier-js offset",
    items: inputs.length,
    check,
    theirs: () => theirs.reduce((sum, curve) => sum + curve.offset(DISTANCE).length, 0),
    ours: () => ours.reduce((sum, curve) => sum + curve.offset(DISTANCE, OPTIONS).segmentCount, 0),
  },
];
