// Splits, subsegments and hulls of splines.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Spline } from "casteljau";
import { near, pairs, pointsOf, refused, SEVEN } from "./reference.js";

const CORNER = pointsOf("0,0 2,0 2,2");
/** A line, a quadratic, a cubic. */
const MIXED = Spline.fromCurves([
  new Curve([0, 0, 1, 1]),
  new Curve([1, 1, 3, 1, 3, 4]),
  new Curve([3, 4, 4, 4, 5, 0, 8, -1]),
]);
const points = (spline) => pairs(spline.controlPoints(), spline.dimension);

/** Whether part(u) = whole(t) where u runs over the part as t over [from, to]; both are piecewise linear in each other. */
function sameCurve(part, whole, from, to, toPart) {
  for (let i = 0; i <= 40; i++) {
    const t = from + ((to - from) * i) / 40;
    near(part.eval(toPart(t)), whole.eval(t), 1e-12);
  }
}

test("split: inside of a segment, the others keep their control points, both parts start at 0", () => {
  const [left, right] = MIXED.split(1.25);
  assert.deepEqual([left.degrees, right.degrees], pointsOf("1,2 2,3"));
  assert.deepEqual([left.closed, right.closed], [false, false]);
  assert.deepEqual(points(left).slice(0, 2), points(MIXED).slice(0, 2));
  assert.deepEqual(points(right).slice(-3), points(MIXED).slice(-3));
  sameCurve(left, MIXED, 0, 1, (t) => t);
  sameCurve(left, MIXED, 1, 1.25, (t) => 1 + (t - 1) / 0.25);
  sameCurve(right, MIXED, 1.25, 2, (t) => (t - 1.25) / 0.75);
  sameCurve(right, MIXED, 2, 3, (t) => t - 1);
});

test("split: at a joint no segment is split; at an end one part is a point", () => {
  const spline = new Spline(CORNER, { degree: 1 });
  assert.deepEqual(spline.split(1).map(points), [CORNER.slice(0, 2), CORNER.slice(1)]);
  assert.deepEqual(spline.split(0).map(points), [[CORNER[0], CORNER[0]], CORNER]);
  assert.deepEqual(spline.split(2).map(points), [CORNER, [CORNER[2], CORNER[2]]]);
  assert.deepEqual(spline.split(3).map(points), [pointsOf("0,0 2,0 2,4"), pointsOf("2,4 2,2")]);
});

test("split: a closed spline is also divided at its start", () => {
  const [left, right] = new Spline(CORNER, { degree: 1, closed: true }).split(2.5);
  assert.deepEqual(points(left), [...CORNER, [1, 1]]);
  assert.deepEqual(points(right), pointsOf("1,1 0,0"));
  assert.deepEqual([left.closed, right.closed], [false, false]);
});

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

test("subsegment: across joints, within a segment, reversed, of a single point", () => {
  const part = MIXED.subsegment(0.5, 2.5);
  assert.deepEqual(part.degrees, [1, 2, 3]);
  sameCurve(part, MIXED, 0.5, 1, (t) => 2 * (t - 0.5));
  sameCurve(part, MIXED, 1, 2, (t) => t);
  sameCurve(part, MIXED, 2, 2.5, (t) => 2 + 2 * (t - 2));
  assert.ok(MIXED.subsegment(2.5, 0.5).equals(part.reverse()));
  assert.deepEqual(MIXED.subsegment(1.25, 1.75).degrees, [2]);
  sameCurve(MIXED.subsegment(1.25, 1.75), MIXED, 1.25, 1.75, (t) => 2 * (t - 1.25));
  assert.deepEqual(points(MIXED.subsegment(0.5, 0.5)), pointsOf("0.5,0.5 0.5,0.5"));
});

test("subsegment: whole segments keep their control points, and ends on joints add none", () => {
  assert.deepEqual(points(MIXED.subsegment(1, 3)), points(MIXED).slice(1));
  assert.deepEqual(points(MIXED.subsegment(0, 2)), points(MIXED).slice(0, 4));
  assert.deepEqual(points(MIXED.subsegment(0, 3)), points(MIXED));
  const closed = new Spline(CORNER, { degree: 1, closed: true });
  assert.deepEqual(points(closed.subsegment(1, 3)), [CORNER[1], CORNER[2], CORNER[0]]);
  refused(() => closed.subsegment(0, Infinity), RangeError, /^t1: /);
  refused(() => closed.subsegment(/** @type {any} */ ("0"), 1), TypeError, /^t0: /);
});

test("parts in 3D keep their dimension", () => {
  const spline = new Spline([0, 0, 0, 1, 1, 1, 2, 0, 5], { degree: 1, dimension: 3 });
  const [left, right] = spline.split(1.5);
  assert.deepEqual([left.dimension, right.dimension], [3, 3]);
  assert.deepEqual(points(right), pointsOf("1.5,0.5,3 2,0,5"));
});

test("hull: the corners counter-clockwise, of more points than a curve can have", () => {
  const square = [];
  for (let i = 49; i >= 0; i--) square.push([25, 25], [50, i], [50 - i, 50], [0, 50 - i], [i, 0]);
  const hull = pairs(new Spline(square, { degree: 1 }).hull());
  const smallest = hull.findIndex(([x, y]) => x === 0 && y === 0);
  assert.deepEqual([...hull.slice(smallest), ...hull.slice(0, smallest)], pointsOf("0,0 50,0 50,50 0,50"));
  refused(() => new Spline([0, 0, 0, 1, 1, 1], { degree: 1, dimension: 3 }).hull(), TypeError, /^hull: /);
  assert.ok(new Spline(SEVEN).hull().length >= 6);
});
