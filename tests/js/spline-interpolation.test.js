// Splines through points, and B-splines.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Spline } from "casteljau";
import { coordinates, near, owned, pairs, pointsOf } from "./reference.js";

const FOUR = pointsOf("0,0 1,1 3,1 4,0");
const SPACE = pointsOf("0,0,0 1,2,3 3,3,-1 4,0,2 5,5,5");
const joints = (spline) =>
  Array.from({ length: spline.segmentCount + (spline.closed ? 0 : 1) }, (_, k) => coordinates(spline.eval(k)));

test("interpolate: natural by default, C2 at the joints, which are the points", () => {
  for (const closed of [false, true]) {
    for (const points of [FOUR, SPACE, SPACE.slice(0, 3)]) {
      const spline = Spline.interpolate(points, { closed });
      assert.deepEqual(joints(spline), points);
      assert.ok(spline.equals(Spline.interpolate(points, { kind: "natural", closed })));
      for (let k = closed ? 0 : 1; k < spline.segmentCount; k++) assert.ok(spline.continuity(k).c2, `${k}`);
    }
  }
  const line = [0, 3].map((x) => ({ x, y: 0 }));
  assert.deepEqual(Spline.interpolate(line).degrees, [3]);
  assert.equal(Spline.interpolate([0, 0, 0, 1, 1, 1], { dimension: 3 }).dimension, 3);
});

test("interpolate: Catmull-Rom splines, centripetal by default", () => {
  const spline = (alpha) => Spline.interpolate(SPACE, { kind: "catmull-rom", alpha });
  const uniform = spline(0).segments()[1].controlPoints();
  near(uniform, Curve.fromBasis("catmull-rom", SPACE.slice(0, 4)).controlPoints());
  assert.ok(spline(undefined).equals(spline(0.5)) && !spline(0.5).equals(spline(1), 0.01));
  // The handles at an inner point are aligned, and their lengths are as those of the chords to the power alpha.
  for (const alpha of [0.5, 1, 0.3]) {
    const [, , before, at, after] = pairs(spline(alpha).controlPoints(), 3);
    const chords = [0, 1].map((k) => Math.hypot(...SPACE[k].map((x, i) => SPACE[k + 1][i] - x)) ** alpha);
    const scaled = [at.map((x, i) => (x - before[i]) / chords[0]), after.map((x, i) => (x - at[i]) / chords[1])];
    near(scaled[0], scaled[1]);
  }
});

test("fromBSpline: uniform, with knots, closed", () => {
  near(Spline.fromBSpline(FOUR).controlPoints(), Curve.fromBasis("b-spline", FOUR).controlPoints());
  const options = { degree: 2, knots: [0, 0, 0, 1, 2, 2, 2] };
  const quadratic = Spline.fromBSpline([0, 0, 1, 2, 3, 2, 4, 0], options);
  assert.deepEqual(quadratic.degrees, [2, 2]);
  near(quadratic.evalAt([0, 0.5, 2]), [0, 0, 1, 1.5, 4, 0]);
  const ring = Spline.fromBSpline(SPACE, { closed: true });
  assert.deepEqual([ring.segmentCount, ring.closed, ring.dimension], [5, true, 3]);
  for (let k = 0; k < 5; k++) assert.ok(ring.continuity(k).c2);
});

test("toBSpline and back gives the same spline", () => {
  const several = [
    Spline.interpolate(FOUR),
    Spline.interpolate(SPACE, { closed: true }),
    new Spline(FOUR, { degree: 1 }),
    new Spline(FOUR, { degree: 2, closed: true }),
    Spline.fromBSpline(SPACE, { degree: 4, closed: true }),
  ];
  for (const spline of several) {
    const { points, ...options } = spline.toBSpline();
    [points, options.knots].forEach(owned);
    assert.ok(Spline.fromBSpline(points, options).equals(spline));
  }
  const { knots, degree, closed } = Spline.interpolate(FOUR.slice(1)).toBSpline();
  assert.deepEqual([[...knots], degree, closed], [[0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2], 3, false]);
});

test("a million points", () => {
  const numbers = Float64Array.from({ length: 2e6 }, (_, i) => (i * 7919) % 1009);
  for (const spline of [
    Spline.interpolate(numbers),
    Spline.interpolate(numbers, { kind: "catmull-rom", closed: true }),
    Spline.fromBSpline(numbers),
  ]) {
    assert.ok(spline.segmentCount > 999_990);
    assert.ok(spline.controlPoints().every(Number.isFinite));
  }
});
