// Every public method of Curve: values of closed forms and definitions come through in the plane and in space.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Spline } from "casteljau";
import { coordinates, CUBIC, deCasteljau, near, owned, pairs, pointsOf, refused, SPACE, TWISTED } from "./reference.js";

const cubic = new Curve(CUBIC);
const space = new Curve(SPACE);
const TS = [0, 0.1, 0.25, 0.5, 0.75, 0.999, 1, -0.5, 1.5];
const CURVES = [pointsOf("0,10 200,100"), pointsOf("3,5 14,3 19,14"), CUBIC, SPACE, pointsOf("0,0 0,1 1,1 1,2 2,2")];

test("eval, evalAt and sample are the points of de Casteljau's algorithm", () => {
  for (const points of CURVES) {
    const curve = new Curve(points);
    const all = (ts) => ts.flatMap((t) => deCasteljau(points, t));
    assert.deepEqual([curve.degree, curve.dimension], [points.length - 1, points[0].length]);
    for (const t of TS) near(curve.eval(t), deCasteljau(points, t));
    assert.deepEqual([curve.eval(0), curve.eval(1)].map(coordinates), [points[0], points.at(-1)]);
    near(curve.evalAt(TS), all(TS));
    near(curve.sample(5), all([0, 0.2, 0.4, 0.6, 0.8, 1]));
    assert.deepEqual(curve.evalAt(new Float32Array(0)), new Float64Array(0));
  }
});

test("points come out as plain objects", () => {
  assert.deepEqual(cubic.eval(0.5), { x: 4, y: 6 });
  assert.deepEqual(space.eval(0), { x: 0, y: 0, z: 0 });
  assert.equal(Object.getPrototypeOf(cubic.eval(0.3)), Object.prototype);
});

test("derivatives", () => {
  // B(t) = (24t² − 16t³, 24t − 24t²)
  for (const t of TS) {
    near(cubic.derivativeAt(t), [48 * t - 48 * t * t, 24 - 48 * t]);
    near(cubic.derivativeAt(t, 2), [48 - 96 * t, -48]);
    near(cubic.derivative().eval(t), cubic.derivativeAt(t));
  }
  assert.deepEqual(cubic.derivativeAt(0.3, 0), cubic.eval(0.3));
  assert.deepEqual(cubic.derivativeAt(0.3, 4), { x: 0, y: 0 });
  assert.deepEqual([...new Curve([1, 2, 4, 1]).derivative().controlPoints()], [3, -1, 3, -1]);
});

test("tangent, normal, curvature and torsion", () => {
  const parabola = new Curve([-1, 1, 0, -1, 1, 1]);
  for (const t of [0, 0.25, 1]) {
    const x = 2 * t - 1;
    const length = Math.hypot(1, 2 * x);
    near(parabola.tangent(t), [1 / length, (2 * x) / length]);
    near(parabola.normal(t), [(-2 * x) / length, 1 / length]);
    near([parabola.curvature(t), parabola.reverse().curvature(1 - t)], [2 / length ** 3, -2 / length ** 3]);
  }
  const stopping = new Curve([0, 0, 0, 0, 1, 1, 2, 0]);
  near(stopping.tangent(0), [Math.SQRT1_2, Math.SQRT1_2]);
  assert.equal(stopping.curvature(0), -Infinity);
  assert.deepEqual(new Curve([3, 3, 3, 3]).tangent(0.5), { x: 0, y: 0 });
  assert.equal(cubic.torsion(0.3), 0);
  const twisted = new Curve(TWISTED);
  for (const t of [0, 0.3, 1]) near([twisted.torsion(t)], [3 / (1 + 9 * t ** 2 + 9 * t ** 4)]);
  near(twisted.tangent(1), [1 / Math.sqrt(14), 2 / Math.sqrt(14), 3 / Math.sqrt(14)]);
  near(twisted.normal(0), [0, 1, 0]);
  near([twisted.curvature(0), twisted.reverse().curvature(1)], [2, 2]);
  assert.deepEqual(new Curve(pointsOf("0,0,0 1,2,3")).normal(0.5), { x: 0, y: 0, z: 0 });
});

test("parts far outside of the curve keep within the limit of coordinates", () => {
  const isWithin = (curve) => curve.controlPoints().every((x) => Math.abs(x) <= 2 ** 500);
  for (const dimension of /** @type {const} */ ([2, 3])) {
    for (const degree of [1, 2, 3, 4, 7]) {
      const coordinates = Array.from({ length: dimension * (degree + 1) }, (_, k) => 1e100 * Math.sin(k * k));
      const curve = new Curve(coordinates, { dimension });
      const spline = new Spline(coordinates, { dimension, degree });
      for (const t of [1e250, -1e250, 1e308]) {
        for (const part of [...curve.split(t), curve.subsegment(0, t), ...spline.split(t), spline.subsegment(t, 0.5)])
          assert.ok(isWithin(part), `${dimension}D, degree ${degree}, t = ${t}: ${part.controlPoints()}`);
      }
    }
  }
  const [before, after] = new Curve([0, 0, 1e100, 1e100]).split(1e250);
  assert.deepEqual(
    [...before.controlPoints(), ...after.controlPoints()],
    [0, 0, ...Array(4).fill(2 ** 500), 1e100, 1e100],
  );
});

test("split: a list gives the parts between its parameters in ascending order", () => {
  const curve = new Curve(CUBIC);
  const parts = curve.split([0.75, 0.25, 0.25]);
  const ends = [0, 0.25, 0.25, 0.75, 1];
  assert.equal(parts.length, 4);
  parts.forEach((part, k) => {
    assert.ok(part.equals(curve.subsegment(ends[k], ends[k + 1])));
    assert.deepEqual(part.eval(0), curve.eval(ends[k]));
    assert.deepEqual(part.eval(1), curve.eval(ends[k + 1]));
  });
  assert.ok(curve.split([])[0].equals(curve));
  const line = new Curve([0, 0, 4, 0]);
  assert.deepEqual(
    line.split([1.5, -1]).map((part) => [part.eval(0).x, part.eval(1).x]),
    [
      [0, -4],
      [-4, 6],
      [6, 4],
    ],
  );
  refused(() => line.split([0, Infinity]), RangeError, /^ts\[1\]: expected a finite number/);
});

test("split, halve, subsegment, reverse, elevate keep the curve", () => {
  for (const points of CURVES) {
    const curve = new Curve(points);
    const pieces = [curve.split(0.3), curve.halve(), curve.subsegment(0.2, 0.9), curve.subsegment(0.9, 0.2)].flat();
    pieces.push(curve.reverse(), curve.elevate());
    pointsOf("0,0.3 0.3,1 0,0.5 0.5,1 0.2,0.9 0.9,0.2 1,0 0,1").forEach(([t0, t1], k) => {
      for (const s of [0, 0.25, 0.5, 1]) near(pieces[k].eval(s), deCasteljau(points, t0 + (t1 - t0) * s));
    });
    assert.equal(curve.elevate().degree, curve.degree + 1);
  }
  const halves = cubic.halve().map((half) => pairs(half.controlPoints()));
  assert.deepEqual(halves, [pointsOf("0,0 0,4 2,6 4,6"), pointsOf("4,6 6,6 8,4 8,0")]);
});

test("deCasteljau gives every level of the triangle", () => {
  const levels = cubic.deCasteljau(0.5).map((level) => pairs(level));
  assert.deepEqual(levels, [CUBIC, pointsOf("0,4 4,8 8,4"), pointsOf("2,6 6,6"), [[4, 6]]]);
  const lengths = space.deCasteljau(0.5).map((level) => level.length);
  assert.deepEqual(lengths, [12, 9, 6, 3]);
});

test("bernstein and basisMatrix", () => {
  assert.deepEqual([...Curve.bernstein(3, 0.5)], [0.125, 0.375, 0.375, 0.125]);
  assert.deepEqual([...Curve.bernstein(0, 0.7)], [1]);
  const matrix = (name, factor) => Array.from(Curve.basisMatrix(name), (x) => Math.round(1e12 * x * factor) / 1e12 + 0);
  assert.deepEqual(matrix("bezier", 1), [-1, 3, -3, 1, 3, -6, 3, 0, -3, 3, 0, 0, 1, 0, 0, 0]);
  assert.deepEqual(matrix("hermite", 1), [2, -2, 1, 1, -3, 3, -2, -1, 0, 0, 1, 0, 1, 0, 0, 0]);
  assert.deepEqual(matrix("b-spline", 6), [-1, 3, -3, 1, 3, -6, 3, 0, -3, 0, 3, 0, 1, 4, 1, 0]);
  assert.deepEqual(matrix("catmull-rom", 2), [-1, 3, -3, 1, 2, -5, 4, -1, -1, 0, 1, 0, 0, 2, 0, 0]);
});

test("fromBasis and toBasis, by name and by matrix in three forms", () => {
  const control = (basis, points) => Curve.fromBasis(basis, pointsOf(points)).controlPoints();
  near(control("hermite", "0,0 9,3 3,6 6,0"), [0, 0, 1, 2, 7, 3, 9, 3]);
  near(control("catmull-rom", "0,0 1,1 3,1 4,0"), [1, 1, 1.5, 7 / 6, 2.5, 7 / 6, 3, 1]);
  near(control("b-spline", "0,6,0 6,0,0 0,0,6 6,6,6"), [4, 1, 1, 4, 0, 2, 2, 0, 4, 2, 1, 5]);
  const flat = Curve.basisMatrix("hermite");
  const rows = [0, 4, 8, 12].map((i) => [...flat.slice(i, i + 4)]);
  for (const matrix of [flat, [...flat], rows]) {
    assert.deepEqual(Curve.fromBasis(matrix, CUBIC).controlPoints(), Curve.fromBasis("hermite", CUBIC).controlPoints());
    near(cubic.toBasis(matrix), [0, 0, 8, 0, 0, 24, 0, -24]);
  }
  for (const basis of /** @type {const} */ (["bezier", "hermite", "b-spline", "catmull-rom"]))
    near(Curve.fromBasis(basis, cubic.toBasis(basis)).controlPoints(), CUBIC.flat());
  // The power basis, from high to low.
  const unit = Array.from({ length: 16 }, (_, i) => (i % 5 === 0 ? 1 : 0));
  near(cubic.toBasis(unit), [-16, 0, 24, -24, 0, 24, 0, 0]);
});

test("flatten: vertices, their parameters, and more of them for a finer tolerance", () => {
  for (const curve of [cubic, space]) {
    const counts = [1, 0.01, 0.0001].map((tolerance) => {
      const { points, ts } = curve.flatten(tolerance);
      [points, ts].forEach(owned);
      near(points, curve.evalAt(ts), 1e-14);
      assert.ok(ts.every((t, i) => i === 0 || t > ts[i - 1]) && ts[0] === 0 && ts.at(-1) === 1);
      ts.subarray(1).forEach((end, i) => {
        const chord = new Curve([curve.eval(ts[i]), curve.eval(end)]);
        assert.ok(chord.nearest(curve.eval((ts[i] + end) / 2)).distance <= tolerance);
      });
      return ts.length;
    });
    assert.ok(counts[0] < counts[1] && counts[1] < counts[2]);
  }
  assert.deepEqual([...new Curve([0, 0, 1, 1]).flatten(0.1).points], [0, 0, 1, 1]);
});

test("subdivide is a tree of halves that ends where D1 - D2 is below the tolerance", () => {
  let leaves = 0;
  const check = (node, t0, t1) => {
    assert.deepEqual([node.t0, node.t1], [t0, t1]);
    const points = pairs(node.curve.controlPoints());
    const lengths = points.slice(1).map((p, i) => Math.hypot(p[0] - points[i][0], p[1] - points[i][1]));
    near([node.polygonLength], [lengths.reduce((sum, x) => sum + x)]);
    near([node.chordLength], [Math.hypot(points[3][0] - points[0][0], points[3][1] - points[0][1])]);
    near([node.deviationBound], [0.5 * Math.sqrt(node.polygonLength ** 2 - node.chordLength ** 2)], 1e-7);
    near(node.curve.eval(0.5), deCasteljau(CUBIC, (t0 + t1) / 2));
    assert.equal(node.halves === null, node.polygonLength - node.chordLength < 0.1);
    if (!node.halves) leaves++;
    node.halves?.forEach((half, i) => check(half, i ? (t0 + t1) / 2 : t0, i ? t1 : (t0 + t1) / 2));
  };
  check(cubic.subdivide(0.1), 0, 1);
  assert.ok(leaves >= 4);
});

test("bounds, controlBounds, hull", () => {
  assert.deepEqual(cubic.bounds(), { min: { x: 0, y: 0 }, max: { x: 8, y: 6 } });
  assert.deepEqual(cubic.controlBounds(), { min: { x: 0, y: 0 }, max: { x: 8, y: 8 } });
  const { max } = new Curve(pointsOf("0,0,0 1,2,-1 2,-2,3 3,0,0")).bounds();
  near(max, [3, 1 / Math.sqrt(3), 1.1371134247365535]);
  assert.deepEqual([...new Curve([4, 4, 0, 0, 8, 0, 4, 1, 0, 8]).hull()], [0, 0, 8, 0, 0, 8]);
});

test("equals compares point by point, toJSON and fromJSON are each other's inverse", () => {
  const other = new Curve([0, 0, 0, 8, 8, 8, 8, 0.5]);
  const equal = [cubic.equals(new Curve(CUBIC)), ...[undefined, 0.5, 0.4].map((most) => cubic.equals(other, most))];
  assert.deepEqual(equal, [true, false, true, false]);
  assert.ok(!cubic.equals(cubic.elevate(), 100));
  for (const curve of [cubic, space, new Curve([0.1, 1e-300, 1 / 3, 1e150])]) {
    const again = Curve.fromJSON(JSON.parse(JSON.stringify(curve)));
    assert.ok(again.equals(curve));
    assert.equal(again.dimension, curve.dimension);
  }
  assert.deepEqual(cubic.toJSON(), { points: CUBIC });
});

test("a matrix of three.js", () => {
  const elements = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1];
  assert.deepEqual(space.transform({ elements }).eval(0), space.transform(elements).eval(0));
  assert.deepEqual(new Curve([0, 0, 1, 1]).transform({ elements }).eval(0), { x: 5, y: 6 });
});
