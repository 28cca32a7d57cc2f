// Rational curves as JavaScript sees them: closed forms of conic sections, forms of arguments, JSON, SVG. Their other numbers are
// those of Rust (parity.test.js).
import assert from "node:assert/strict";
import { test } from "node:test";
import { inspect } from "node:util";
import * as complete from "casteljau";
import { Curve, RationalCurve, Spline } from "casteljau/nurbs";
import { near, owned, recorder, refused, refusedAll, untyped } from "./reference.js";

const HALF = Math.SQRT1_2;
const quarter = new RationalCurve(
  [
    [1, 0],
    [1, 1],
    [0, 1],
  ],
  [1, HALF, 1],
);
/** A quarter of the unit circle in the plane x = z, raised to y = 2. */
const space = new RationalCurve(
  [
    [HALF, 2, HALF],
    [HALF, 3, HALF],
    [0, 3, 0],
  ],
  [1, HALF, 1],
);
const cubic = new RationalCurve([0, 0, 1, 3, 4, -1, 5, 2], [1, 2, 0.5, 3]);
const STEPS = Array.from({ length: 101 }, (_, i) => i / 100);

test("rational curves: points of a circle", () => {
  for (const t of STEPS) {
    const { x, y } = quarter.eval(t);
    assert.ok(Math.abs(Math.hypot(x, y) - 1) <= 4 * Number.EPSILON, `${t}`);
    near(quarter.curvature(t), 1, 1e-13);
    near(quarter.normal(t), { x: -x, y: -y }, 1e-14);
  }
  assert.deepEqual(
    [quarter.eval(0), quarter.eval(1)],
    [
      { x: 1, y: 0 },
      { x: 0, y: 1 },
    ],
  );
  near(quarter.length(), Math.PI / 2, 1e-14);
  near(quarter.area(), Math.PI / 4, 1e-14);
  near(quarter.pointAtLength(Math.PI / 6).point, { x: Math.cos(Math.PI / 6), y: 0.5 });
  near(quarter.nearest([3, 4]).point, { x: 0.6, y: 0.8 });
});

test("rational curves: a circle in space", () => {
  for (const t of STEPS) {
    const { x, y, z } = space.eval(t);
    assert.ok(x === z && Math.abs(x * x + z * z + (y - 2) ** 2 - 1) < 1e-14);
    near(space.curvature(t), 1, 1e-13);
  }
  assert.deepEqual([space.degree, space.dimension, space.points()[1]], [2, 3, { x: HALF, y: 3, z: HALF }]);
  near(space.length(), Math.PI / 2, 1e-14);
});

test("rational curves: a conic section touches its legs, and its center point divides the median by the weight", () => {
  for (const w of [0.01, 0.5, 1, 7]) {
    const conic = RationalCurve.conic([0, 0], [2, 3], [4, 0], w);
    near(conic.eval(0.5), { x: 2, y: (3 * w) / (1 + w) });
    near(conic.tangent(0), { x: 2 / Math.hypot(2, 3), y: 3 / Math.hypot(2, 3) });
  }
  assert.deepEqual(RationalCurve.conic({ x: 0, y: 0, z: 1 }, [1, 2, 3], [4, 0, 0], 2).dimension, 3);
});

test("rational curves: points of a cubic by the definition, in and out of [0, 1]", () => {
  const [points, weights] = [cubic.points(), cubic.weights()];
  for (const t of [...STEPS, -0.05, 1.1]) {
    const b = Curve.bernstein(3, t).map((x, i) => x * weights[i]);
    const w = b.reduce((sum, x) => sum + x, 0);
    const sum = (key) => b.reduce((total, x, i) => total + x * points[i][key], 0) / w;
    near(cubic.eval(t), { x: sum("x"), y: sum("y") }, 1e-14);
    assert.deepEqual([...cubic.evalAt([t])], Object.values(cubic.eval(t)));
  }
  assert.deepEqual([...cubic.sample(4)], [...cubic.evalAt([0, 0.25, 0.5, 0.75, 1])]);
  const into = new Float64Array(12);
  assert.ok(cubic.sample(2, { into }) === into && cubic.evalAt([0.5], { into }) === into);
});

test("rational curves: where the denominator is not above 0 there is no point", () => {
  const arc = RationalCurve.conic([0, 0], [1, 1], [2, 0], 9);
  const message = /^t: expected a parameter at which the denominator of the curve is above 0, got 2$/;
  const calls = ["eval", "derivativeAt", "tangent", "normal", "curvature"];
  for (const name of calls) refused(() => untyped(arc)[name](2), RangeError, message, name);
  refused(() => arc.evalAt([0.5, 2]), RangeError, /^ts\[1\]: expected a parameter .*got 2$/);
  refused(() => arc.split(2), RangeError, /^weights\[2\]: expected a number above 0/);
  assert.ok(calls.every((name) => untyped(arc)[name](1.05) !== undefined));
});

test("rational curves: parts, degree and standard form keep the curve", () => {
  const [left, right] = cubic.split(0.3);
  assert.deepEqual(left.eval(1), right.eval(0));
  near(left.eval(0.5), cubic.eval(0.15));
  near(right.eval(0.5), cubic.eval(0.65));
  assert.ok(cubic.halve()[0].equals(cubic.split(0.5)[0]));
  assert.deepEqual(
    cubic.split([0.75, 0.25]).map((part) => part.degree),
    [3, 3, 3],
  );
  near(cubic.subsegment(0.8, 0.2).eval(0.25), cubic.eval(0.65));
  near(cubic.reverse().eval(0.3), cubic.eval(0.7));
  assert.equal(cubic.elevate(2).degree, 5);
  near(cubic.elevate(2).eval(0.3), cubic.eval(0.3));
  const standard = cubic.reparametrize();
  assert.deepEqual([standard.weights()[0], standard.weights()[3]], [1, 1]);
  near(standard.nearest(cubic.eval(0.4)).distance, 0);
});

test("rational curves: affine and projective maps", () => {
  const moved = quarter.transform("translate(5 6) rotate(30)");
  assert.deepEqual(moved.weights(), quarter.weights());
  near(moved.eval(0.3), new Curve([quarter.eval(0.3), [0, 0]]).transform("translate(5 6) rotate(30)").eval(0));
  // (x, y) becomes (x, y) / (1 + x/4 + y/10), column by column.
  const plane = [1, 0, 0.25, 0, 1, 0.1, 0, 0, 1];
  const inSpace = [1, 0, 0, 0.25, 0, 1, 0, 0.1, 0, 0, 1, 0, 0, 0, 0, 1];
  for (const matrix of [plane, { elements: plane }, inSpace, { elements: inSpace }, plane.map((x) => -3 * x)]) {
    const image = quarter.transform(matrix);
    for (const t of STEPS) {
      const { x, y } = quarter.eval(t);
      const v = 1 + x / 4 + y / 10;
      near(image.eval(t), { x: x / v, y: y / v }, 1e-14);
    }
  }
  const affine = [2, 0, 0, 0, 3, 0, 5, 6, 1];
  near(quarter.transform(affine).controlPoints(), quarter.transform([2, 0, 0, 3, 5, 6]).controlPoints());
  near(space.transform(inSpace).eval(0.5).x, space.eval(0.5).x / (1 + space.eval(0.5).x / 4 + space.eval(0.5).y / 10));
  refusedAll(RangeError, [
    [
      () => quarter.transform([1, 0, -2, 0, 1, 0, 0, 0, 1]),
      /^projected weights\[2\]: expected a number above 0 \(split/,
    ],
    [() => space.transform(plane), /^matrix: expected 6 or 16 numbers for a curve in space, got 9$/],
    [() => quarter.transform([1, 2, 3]), /^matrix: expected 6 or 9 or 16 numbers, got 3$/],
  ]);
});

test("rational curves: boxes, extrema, inflections and polylines", () => {
  const half = quarter.transform("rotate(45)");
  near(half.bounds().max.y, 1, 1e-15);
  near(half.extrema().y, [0.5]);
  assert.deepEqual(quarter.controlBounds(), { min: { x: 0, y: 0 }, max: { x: 1, y: 1 } });
  assert.deepEqual([space.extrema().z?.length, quarter.inflections().length, cubic.inflections().length], [0, 0, 1]);
  const { points, ts } = quarter.flatten(1e-3);
  assert.equal(points.length, 2 * ts.length);
  for (const array of [points, ts, quarter.weights(), quarter.controlPoints(), quarter.sample(3)]) owned(array);
  for (let k = 2; k < points.length; k += 2) {
    const middle = Math.hypot(points[k] + points[k - 2], points[k + 1] + points[k - 1]) / 2;
    assert.ok(middle <= 1 && middle >= 1 - 1e-3);
  }
});

test("rational curves: splines within the tolerance", () => {
  const counts = [1e-3, 1e-4, 1e-6].map((tolerance) => quarter.toSpline({ tolerance }).segmentCount);
  assert.deepEqual(counts, [1, 2, 4]);
  for (const tolerance of [undefined, 1e-3, 1e-6]) {
    const spline = quarter.toSpline({ tolerance });
    assert.ok(spline instanceof Spline);
    for (const t of STEPS) {
      const { x, y } = spline.eval(t * spline.segmentCount);
      assert.ok(Math.abs(Math.hypot(x, y) - 1) <= (tolerance ?? 1e-4 * Math.SQRT2));
    }
  }
  const equal = new RationalCurve(cubic.points(), [2, 2, 2, 2]);
  assert.deepEqual(equal.toSpline().controlPoints(), cubic.controlPoints());
  const point = new RationalCurve([0, 0, 0, 0, 0, 0], [1, 2, 3]);
  assert.deepEqual([point.toSpline().length(), point.length()], [0, 0]);
});

test("rational curves: arcs of ellipses are arcs in SVG, and are read as the same curve", () => {
  assert.equal(String(quarter), "M1,0 A1,1 0 0 1 0,1");
  assert.equal(quarter.toSVG({ precision: 2 }), "M1 0A1 1 0 0 1 0 1");
  assert.equal(quarter.transform("scale(2 1)").reverse().toSVG(), "M0,1 A2,1 0 0 0 2,0");
  const arcs = [quarter.transform("rotate(17) scale(30 10)"), RationalCurve.conic([0, 0], [0, 50], [100, 80], 0.1)];
  for (const arc of arcs) {
    for (const precision of [undefined, 3, 1]) {
      const text = arc.toSVG({ precision });
      assert.match(text, /^M[-\d., ]*A[^C]*$/);
      const [read] = complete.Path.fromSVG(text, { tolerance: 1e-6 }).subpaths;
      const max = precision === undefined ? 1e-6 : 2 * 10 ** -precision;
      for (const t of STEPS) assert.ok(read.nearest(arc.eval(t)).distance <= max, `${text} at ${t}`);
    }
  }
  const onLine = RationalCurve.conic([20, 70], [67, 70], [114, 70], 0.5);
  assert.doesNotMatch(onLine.toSVG({ precision: 2 }), /-/, "no negative radius");
  // A parabola, a hyperbola, other degrees, and half an ellipse but for a rounding.
  const others = [RationalCurve.conic([0, 0], [1, 1], [2, 0], 1), RationalCurve.conic([0, 0], [1, 1], [2, 0], 5)];
  for (const curve of [...others, cubic, quarter.elevate()]) assert.doesNotMatch(curve.toSVG({ precision: 3 }), /A/);
  assert.equal(JSON.stringify(space), String(space));
});

test("rational curves: drawing on a canvas", () => {
  const target = recorder();
  quarter.trace(untyped(target), { tolerance: 1e-3 });
  assert.match(JSON.stringify(target), /moveTo.*bezierCurveTo/);
});

test("rational curves: JSON, equality and what Node shows", () => {
  for (const curve of [quarter, space, cubic]) {
    const read = RationalCurve.fromJSON(JSON.parse(JSON.stringify(curve)));
    assert.ok(read.equals(curve) && curve.equals(read));
  }
  const scaled = new RationalCurve(
    quarter.points(),
    quarter.weights().map((w) => 8 * w),
  );
  assert.ok(quarter.equals(scaled) && scaled.equals(quarter));
  assert.ok(!quarter.equals(new RationalCurve(quarter.points(), [1, 0.7, 1])));
  assert.ok(quarter.equals(new RationalCurve(quarter.points(), [1, 0.7, 1]), 0.01));
  assert.ok(!quarter.equals(space) && !quarter.equals(quarter.reverse()) && !quarter.equals(cubic));
  assert.equal(
    inspect(new RationalCurve([0, 0, 1, 1], [1, 2])),
    "RationalCurve { points: [ [ 0, 0 ], [ 1, 1 ] ], weights: [ 1, 2 ] }",
  );
});

test("rational curves: values of all entry points", () => {
  for (const Other of [complete.Curve, Curve]) {
    const curve = new Other([0, 0, 1, 2, 3, 0]);
    const rational = RationalCurve.from(curve);
    assert.deepEqual([...rational.weights()], [1, 1, 1]);
    near(rational.eval(0.3), curve.eval(0.3), 1e-15);
  }
  assert.ok(RationalCurve.from(quarter).equals(quarter));
  near(complete.Spline.fromCurves(quarter.toSpline({ tolerance: 1e-9 }).segments()).length(), Math.PI / 2, 1e-8);
  refusedAll(TypeError, [
    [
      () => RationalCurve.from(untyped(new Spline([0, 0, 1, 1], { degree: 1 }))),
      /^curve: expected a Curve, got a Spline/,
    ],
    [() => new complete.Curve([0, 0, 1, 1]).equals(untyped(quarter)), /^other: expected a Curve, got a RationalCurve$/],
    [() => quarter.equals(untyped(new Curve([0, 0, 1, 1]))), /^other: expected a RationalCurve, got a Curve$/],
  ]);
});
