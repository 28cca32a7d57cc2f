// Splines through points, and B-splines.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Spline } from "casteljau";
import { coordinates, near, owned, pairs, pointsOf, refused, refusedAll, untyped } from "./reference.js";

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

test("interpolate: refusals", () => {
  function through(/** @type {any} */ options, points = FOUR) {
    return () => Spline.interpolate(points, options);
  }
  refusedAll(RangeError, [
    [through({}, [[0, 0]]), /^points: expected at least 2 points, got 1$/],
    [through({}, []), /^points: expected at least 2 points, got 0$/],
    [through({}, pointsOf("0,0 NaN,0")), /^points\[1\]\[0\]: expected a finite number, got NaN$/],
    [through({ kind: "akima" }), /^kind: expected one of "natural", "catmull-rom", got "akima"$/],
    [through({ kind: "catmull-rom", alpha: 1.5 }), /^alpha: expected a number from 0 to 1, got 1.5$/],
  ]);
  refusedAll(TypeError, [
    [through({ kind: "catmull-rom", alpha: "1" }), /^alpha: expected a number, got "1"$/],
    [through({}, untyped(5)), /^points: expected an array of points, got 5; did you mean \[\[x, y\], …\]\?$/],
  ]);
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

test("fromBSpline and toBSpline: refusals", () => {
  const bspline = (/** @type {any} */ options) => () => Spline.fromBSpline(FOUR, options);
  const mixed = Spline.fromCurves([new Curve([0, 0, 1, 0]), new Curve([1, 0, 2, 0, 3, 1])]);
  refusedAll(RangeError, [
    [bspline({ degree: 4 }), /^points: expected at least degree \+ 1 points .*, got 4$/],
    [bspline({ degree: 0 }), /^degree: expected a whole number from 1 to 64, got 0$/],
    [bspline({ knots: [0, 1] }), /^knots: expected points \+ degree \+ 1 knots .*, got 2$/],
    [bspline({ knots: [] }), /^knots: expected 8 .*, got 0$/],
    [bspline({ knots: [0, 1, 2, 3, 2.5, 5, 6, 7] }), /^knots\[4\]: expected a knot not below .* it, got 2.5$/],
    [bspline({ degree: 1, knots: [0, 1, 2, 2, 3, 4] }), /^knots\[3\]: expected at most degree times .*, got 2$/],
    [bspline({ knots: new Array(8).fill(0) }), /^knots\[4\]: expected a knot above that .* curve starts, got 0$/],
    [bspline({ knots: [0, 1, NaN, 3, 4, 5, 6, 7] }), /^knots\[2\]: expected a finite number, got NaN$/],
    [() => mixed.toBSpline(), /^degrees\[1\]: expected the degree of the first segment \(1\), got 2$/],
  ]);
  refused(bspline({ knots: "01234567" }), TypeError, /^knots: expected an array of numbers, got "01234567"$/);
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
