// Splits of splines at a list of parameters.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Spline } from "casteljau";
import { pairs, pointsOf, refused } from "./reference.js";

const CORNER = pointsOf("0,0 2,0 2,2");
/** A line, a quadratic, a cubic. */
const MIXED = Spline.fromCurves([
  new Curve([0, 0, 1, 1]),
  new Curve([1, 1, 3, 1, 3, 4]),
  new Curve([3, 4, 4, 4, 5, 0, 8, -1]),
]);
const points = (spline) => pairs(spline.controlPoints(), spline.dimension);

test("split: a list gives the parts between its parameters in ascending order", () => {
  const parts = MIXED.split([2.5, 1, 1.25, 1]);
  assert.deepEqual(
    parts.map(({ degrees }) => degrees),
    [[1], [2], [2], [2, 3], [3]],
  );
  assert.ok(parts[1].equals(MIXED.subsegment(1, 1)));
  parts.slice(1).forEach((part, k) => assert.deepEqual(part.eval(0), parts[k].eval(parts[k].segmentCount)));
  assert.deepEqual(parts[3].eval(0), MIXED.eval(1.25));
  const closed = new Spline(CORNER, { degree: 1, closed: true });
  assert.deepEqual(closed.split([]).map(points), [[...CORNER, CORNER[0]]]);
  assert.deepEqual(closed.split([2.5, 1.5]).map(points), ["0,0 2,0 2,1", "2,1 2,2 1,1", "1,1 0,0"].map(pointsOf));
  // Parameters outside: from the extrapolated point back to the end, as a single parameter gives it.
  const line = new Spline(CORNER, { degree: 1 });
  assert.deepEqual(line.split([3]).map(points), line.split(3).map(points));
  assert.deepEqual(line.split(Float64Array.of(1, 3)).map(points), ["0,0 2,0", "2,0 2,4", "2,4 2,2"].map(pointsOf));
  refused(() => line.split([0.5, NaN]), RangeError, /^ts\[1\]: expected a finite number, got NaN/);
  refused(() => line.split(/** @type {any} */ (["0"])), TypeError, /^ts\[0\]: expected a number/);
});
