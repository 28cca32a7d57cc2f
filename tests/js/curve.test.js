// Curves as JavaScript sees them: forms of arguments, default values, results as objects and arrays, JSON. Their numbers are those of
// Rust (parity.test.js).
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Spline } from "casteljau";
import { CUBIC, deCasteljau, near, owned, pairs, pointsOf, refused, SPACE, TWISTED } from "./reference.js";

const cubic = new Curve(CUBIC);
const space = new Curve(SPACE);

test("points come out as plain objects", () => {
  assert.deepEqual(cubic.eval(0.5), { x: 4, y: 6 });
  assert.deepEqual(space.eval(0), { x: 0, y: 0, z: 0 });
  assert.equal(Object.getPrototypeOf(cubic.eval(0.3)), Object.prototype);
});

test("degree and dimension, no parameters, and the first derivative by default", () => {
  assert.deepEqual([cubic.degree, cubic.dimension, space.degree, space.dimension], [3, 2, 3, 3]);
  assert.deepEqual(cubic.evalAt(new Float32Array(0)), new Float64Array(0));
  assert.deepEqual(cubic.derivativeAt(0.3), cubic.derivativeAt(0.3, 1));
});

test("a matrix of a basis in three forms", () => {
  const flat = Curve.basisMatrix("hermite");
  const rows = [0, 4, 8, 12].map((i) => [...flat.slice(i, i + 4)]);
  for (const matrix of [flat, [...flat], rows]) {
    assert.deepEqual(Curve.fromBasis(matrix, CUBIC).controlPoints(), Curve.fromBasis("hermite", CUBIC).controlPoints());
    assert.deepEqual(cubic.toBasis(matrix), cubic.toBasis("hermite"));
  }
});

test("a matrix of three.js", () => {
  const elements = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1];
  assert.deepEqual(space.transform({ elements }).eval(0), space.transform(elements).eval(0));
  assert.deepEqual(new Curve([0, 0, 1, 1]).transform({ elements }).eval(0), { x: 5, y: 6 });
});

test("arrays of results belong to the caller", () => {
  for (const curve of [cubic, space]) {
    const { points, ts } = curve.flatten(0.01);
    [points, ts, curve.sample(3), curve.evalAt([0, 1]), curve.controlPoints(), curve.equidistantTimes(7)].forEach(
      owned,
    );
    Object.values(curve.extrema()).forEach(owned);
  }
  Object.values(new Curve(TWISTED).frames(4)).forEach(owned);
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

test("deCasteljau gives every level of the triangle", () => {
  const levels = cubic.deCasteljau(0.5).map((level) => pairs(level));
  assert.deepEqual(levels, [CUBIC, pointsOf("0,4 4,8 8,4"), pointsOf("2,6 6,6"), [[4, 6]]]);
  const lengths = space.deCasteljau(0.5).map((level) => level.length);
  assert.deepEqual(lengths, [12, 9, 6, 3]);
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
