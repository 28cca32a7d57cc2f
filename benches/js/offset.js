// Offset curves, compared with bezier-js, whose pieces may have gaps and have no tolerance; ours are within 0.1.
import { Bezier } from "bezier-js";
import { Curve } from "casteljau";
import { cubics } from "./inputs.js";

const DISTANCE = 10;
const OPTIONS = { tolerance: 0.1 };
const inputs = cubics(64);
const theirs = inputs.map((numbers) => new Bezier(numbers));
const ours = inputs.map((numbers) => new Curve(numbers));

/**
 * bezier-js omits pieces that it cannot scale, so ends may be missing, and gaps are up to 56 units wide. In most cases
 * its first piece is at the start of the curve; then both starts must be equal.
 */
function check() {
  const same = inputs.filter((_, k) => {
    const [{ x, y }] = theirs[k].offset(DISTANCE)[0].points;
    const points = ours[k].offset(DISTANCE, OPTIONS).controlPoints();
    return Math.hypot(x - points[0], y - points[1]) < 1e-6;
  });
  if (same.length < inputs.length / 2) throw new Error(`offset: only ${same.length} of ${inputs.length} starts agree`);
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
