// NURBS curves as JavaScript sees them: closed forms of circles and ellipses, knots, forms of arguments, JSON, SVG.
import assert from "node:assert/strict";
import { test } from "node:test";
import * as complete from "casteljau";
import { Curve, NurbsCurve, RationalCurve, Spline } from "casteljau/nurbs";
import { near, owned, recorder, refused, refusedAll, untyped } from "./reference.js";

const POINTS = [
  [0, 0],
  [1, 2],
  [3, 2],
  [4, 0],
];
const KNOTS = [0, 0, 0, 1, 2, 2, 2];
const curve = new NurbsCurve({ degree: 2, points: POINTS, weights: [1, 2, 2, 1], knots: KNOTS });
const circle = NurbsCurve.circle([1, 2], 3);
const closed = new NurbsCurve({ degree: 3, points: [0, 0, 2, 0, 2, 2, 0, 2], knots: [0, 1, 2, 3, 4], closed: true });
const STEPS = Array.from({ length: 101 }, (_, i) => i / 100);

/** B-splines by the formula of de Boor and Cox: the values of N of a degree at t. */
function basis(knots, degree, t) {
  const last = knots.findLastIndex((u, i) => u < knots[i + 1]);
  const span = Math.min(
    knots.findLastIndex((u) => u <= t),
    last,
  );
  let n = knots.slice(1).map((_, i) => Number(i === span));
  const ratio = (a, b) => (b === 0 ? 0 : a / b);
  for (let p = 1; p <= degree; p++)
    n = n
      .slice(1)
      .map(
        (_, i) =>
          ratio((t - knots[i]) * n[i], knots[i + p] - knots[i]) +
          ratio((knots[i + p + 1] - t) * n[i + 1], knots[i + p + 1] - knots[i + 1]),
      );
  return n;
}

test("NURBS curves: points by the definition", () => {
  for (const t of STEPS.map((s) => 2 * s)) {
    const b = basis(KNOTS, 2, t).map((x, i) => x * curve.weights()[i]);
    const w = b.reduce((sum, x) => sum + x, 0);
    const sum = (axis) => b.reduce((total, x, i) => total + x * POINTS[i][axis], 0) / w;
    near(curve.eval(t), { x: sum(0), y: sum(1) }, 1e-14, `${t}`);
  }
  assert.deepEqual([curve.eval(0), curve.eval(2), curve.domain], [{ x: 0, y: 0 }, { x: 4, y: 0 }, [0, 2]]);
  assert.deepEqual([...curve.sample(2)], [...curve.evalAt([0, 1, 2])]);
  assert.deepEqual([...curve.joints()], [0, 1, 2]);
  assert.ok(curve.segments().every((segment) => segment instanceof RationalCurve && segment.degree === 2));
});

test("NURBS curves: circles, arcs and ellipses", () => {
  for (const t of STEPS) {
    const { x, y } = circle.eval(t);
    assert.ok(Math.abs(Math.hypot(x - 1, y - 2) - 3) <= 16 * Number.EPSILON, `${t}`);
    near(circle.curvature(t), 1 / 3, 1e-13);
  }
  near(circle.length(), 6 * Math.PI, 1e-14);
  near(circle.area(), 9 * Math.PI, 1e-14);
  const { min, max } = circle.bounds();
  near([min.x, min.y, max.x, max.y], [-2, -1, 4, 5]);
  near(circle.nearest([5, 5]).distance, 2);
  near(circle.timeAtLength(1.5 * Math.PI), 0.25);
  const arc = NurbsCurve.arc([0, 0], 2, Math.PI / 6, -Math.PI / 2);
  near(arc.eval(1), { x: 0, y: -2 });
  near(arc.length(), (4 * Math.PI) / 3);
  const ellipse = NurbsCurve.ellipse([1, 0], 5, 3, Math.PI / 2);
  assert.deepEqual(
    [ellipse.eval(0), ellipse.eval(0.25)],
    [
      { x: 1, y: 5 },
      { x: -2, y: 0 },
    ],
  );
  near(ellipse.area(), 15 * Math.PI, 1e-14);
  near(ellipse.length(), perimeter(5, 3), 1e-12);
  const inSpace = NurbsCurve.arc([1, 2, 3], 2, 0, 2 * Math.PI, { normal: [1, 1, 1] });
  for (const t of STEPS) {
    const { x, y, z } = inSpace.eval(t);
    near(Math.hypot(x - 1, y - 2, /** @type {number} */ (z) - 3), 2, 1e-14);
    near(x + y + /** @type {number} */ (z), 6, 1e-14);
  }
  assert.deepEqual(NurbsCurve.arc([0, 0, 0], 1, 0, Math.PI / 2, { normal: [1, 0, 0] }).eval(1), { x: 0, y: 0, z: 1 });
});

/** The perimeter of an ellipse by the arithmetic-geometric mean. */
function perimeter(a, b) {
  let [x, y, sum] = [a, b, (a * a + b * b) / 2];
  for (let power = 1; Math.abs(x - y) > 1e-15 * x; power *= 2) {
    sum -= power * ((x - y) / 2) ** 2;
    [x, y] = [(x + y) / 2, Math.sqrt(x * y)];
  }
  return (2 * Math.PI * sum) / x;
}

test("NURBS curves: knots can be inserted and removed", () => {
  const finer = curve.insertKnot(0.5).refine([1.5, 0.25]);
  assert.deepEqual([...finer.knots()], [0, 0, 0, 0.25, 0.5, 1, 1.5, 2, 2, 2]);
  for (const t of STEPS.map((s) => 2 * s)) near(finer.eval(t), curve.eval(t), 1e-14);
  const { curve: coarser, error } = finer.removeKnot(1.5);
  assert.ok(error < 1e-15 && coarser.knots().length === 9);
  const { error: bound } = curve.removeKnot(1);
  assert.ok(bound > 0.1);
  const kept = curve.removeKnot(1, { tolerance: 0.1 });
  assert.deepEqual([kept.curve === curve, kept.error], [true, bound]);
  assert.equal(curve.removeKnot(1, { tolerance: bound }).curve.knots().length, 6);
  assert.equal(curve.elevate(2).degree, 4);
  near(curve.elevate(2).eval(0.7), curve.eval(0.7), 1e-14);
  near(curve.greville(), [0, 0.5, 1.5, 2]);
});

test("NURBS curves: parts, directions and maps", () => {
  const [left, right] = curve.split(0.7);
  assert.deepEqual(
    [left.domain, right.domain],
    [
      [0, 0.7],
      [0.7, 2],
    ],
  );
  near(right.eval(1.2), curve.eval(1.2), 1e-14);
  near(curve.subsegment(1.5, 0.5).eval(0.5), curve.eval(1.5), 1e-14);
  near(curve.reverse().eval(0.3), curve.eval(1.7), 1e-14);
  near(curve.transform("scale(2)").eval(0.3).x, 2 * curve.eval(0.3).x);
  const image = curve.transform([1, 0, 0.1, 0, 1, 0, 0, 0, 1]);
  for (const t of STEPS) near(image.eval(t).x, curve.eval(t).x / (1 + curve.eval(t).x / 10), 1e-14);
  near(closed.eval(4), closed.eval(0), 1e-15);
  near(closed.reverse().area(), -closed.area());
  near(closed.derivativeAt(0), closed.derivativeAt(4), 1e-14);
});

test("NURBS curves: derivatives are by t", () => {
  for (const t of [0.3, 1.2]) {
    const h = 1e-6;
    const [a, b] = [curve.eval(t - h), curve.eval(t + h)];
    near(curve.derivativeAt(t), { x: (b.x - a.x) / (2 * h), y: (b.y - a.y) / (2 * h) }, 1e-8);
  }
  near(circle.tangent(0.25), { x: -1, y: 0 });
  near(circle.normal(0.25), { x: 0, y: -1 });
});

test("NURBS curves: splines, polylines, SVG and canvas", () => {
  const spline = circle.toSpline({ tolerance: 1e-6 });
  assert.ok(spline instanceof Spline && spline.closed && spline.segmentCount <= 32);
  for (const t of STEPS) {
    const { x, y } = spline.eval(t * spline.segmentCount);
    assert.ok(Math.abs(Math.hypot(x - 1, y - 2) - 3) <= 1e-6);
  }
  assert.equal(circle.toSVG({ precision: 1 }), "M4 2A3 3 0 0 1 1 5 3 3 0 0 1-2 2 3 3 0 0 1 1-1 3 3 0 0 1 4 2Z");
  assert.doesNotMatch(curve.toSVG(), /[AZ]/);
  const { points, ts } = curve.flatten(0.01);
  for (const array of [points, ts, curve.knots(), curve.weights(), curve.joints(), curve.sample(3)]) owned(array);
  const target = recorder();
  circle.trace(untyped(target));
  assert.match(JSON.stringify(target), /moveTo.*bezierCurveTo.*closePath/);
});

test("NURBS curves: other curves as NURBS curves", () => {
  const cubic = new complete.Curve([0, 0, 1, 3, 4, -1, 5, 2]);
  near(NurbsCurve.from(cubic).eval(0.3), cubic.eval(0.3), 1e-15);
  const conic = RationalCurve.conic([1, 0], [1, 1], [0, 1], Math.SQRT1_2);
  assert.deepEqual(NurbsCurve.from(conic).eval(0.3), conic.eval(0.3));
  const path = complete.Path.fromSVG("M0 0H2V1Q3 3 4 0C5 1 6 1 7 0");
  const nurbs = NurbsCurve.from(untyped(path));
  assert.deepEqual([nurbs.degree, ...nurbs.joints()], [3, 0, 1, 2, 3, 4]);
  near(nurbs.eval(2.3), path.subpaths[0].eval(2.3), 1e-15);
  near(NurbsCurve.from(untyped(complete.Path.rect([0, 0], 2, 1))).area(), 2);
  assert.ok(NurbsCurve.from(curve).equals(curve));
  const through = [0, 0, 1, 2, 3, 1, 5, 4, 6, 0];
  const fitted = NurbsCurve.interpolate(through);
  for (let k = 0; k < 10; k += 2) near(fitted.nearest(through.slice(k, k + 2)).distance, 0);
  assert.equal(NurbsCurve.interpolate(through, { degree: 1 }).degree, 1);
});

test("NURBS curves: JSON and equality", () => {
  for (const each of [curve, circle, closed]) {
    const read = NurbsCurve.fromJSON(JSON.parse(JSON.stringify(each)));
    assert.ok(read.equals(each) && each.equals(read));
  }
  assert.ok(!curve.equals(curve.reverse()) && !curve.equals(curve.elevate()) && !circle.equals(closed));
  assert.ok(curve.equals(curve.insertKnot(1, 0)));
  assert.equal(untyped(new complete.Curve([0, 0, 1, 1])).dimension, 2);
});

test("NURBS curves: what is refused", () => {
  const points = POINTS;
  refusedAll(RangeError, [
    [() => new NurbsCurve({ degree: 2, points, knots: [0, 0, 1, 2, 2] }), /^knots: expected .*rhino3dm.*got 5$/],
    [() => new NurbsCurve({ degree: 2, points, knots: [0, 0, 0, 2, 1, 2, 2] }), /^knots\[4\]: expected .*got 1$/],
    [
      () => new NurbsCurve({ degree: 2, points, knots: KNOTS, weights: [1, 2, 3] }),
      /^weights: expected 4 numbers.*got 3$/,
    ],
    [
      () => new NurbsCurve({ degree: 2, points, knots: KNOTS, weights: [1, 2, 3, 0] }),
      /^weights\[3\]: expected a number above 0/,
    ],
    [() => curve.split(2), /^t: expected a number inside of the domain, 0 to 2, got 2$/],
    [() => curve.subsegment(0, 3), /^t1: expected .*got 3$/],
    [() => curve.insertKnot(1, 3), /^t(imes)?: expected .*got [13]$/],
    [() => curve.removeKnot(0.5), /^t: expected a knot .*got 0.5$/],
    [() => NurbsCurve.circle([0, 0], -1), /^radius: expected a number from 0, got -1$/],
    [() => NurbsCurve.arc([0, 0], 1, 0, 9), /^end: expected at most a full turn/],
    [() => NurbsCurve.arc([0, 0, 0], 1, 0, 1, { normal: [0, 0, 0] }), /^normal: expected a vector/],
    [() => NurbsCurve.from(untyped(complete.Path.fromSVG("M0 0H1M2 2H3"))), /^shape: expected a path of one subpath/],
  ]);
  refusedAll(TypeError, [
    [() => new NurbsCurve(untyped({ points, knots: KNOTS })), /^degree: expected a whole number, got undefined$/],
    [
      () => NurbsCurve.from(untyped(3)),
      /^shape: expected a Curve, a RationalCurve, a NurbsCurve, a Spline or a Path, got 3$/,
    ],
    [() => NurbsCurve.arc([0, 0], 1, 0, 1, { normal: [0, 0, 1] }), /^normal: expected none with a 2D center/],
  ]);
  refused(
    () => new RationalCurve([0, 0, 1, 1], untyped(curve)),
    TypeError,
    /^weights: expected an array of numbers, got a NurbsCurve$/,
  );
  assert.ok(new Curve([0, 0, 1, 1]).length() > 1);
});
