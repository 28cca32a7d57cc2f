import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Spline } from "../../js/index.js";
import { pointsOf } from "./reference.js";

test("a parallel keeps its distance and its ends", () => {
  const curve = new Curve([0, 0, 0, 100, 200, 100, 200, 0]);
  const offset = curve.offset(10, { tolerance: 0.01 });
  assert.ok(offset instanceof Spline);
  assert.deepEqual(offset.eval(0), { x: -10, y: 0 });
  assert.deepEqual(offset.eval(offset.segmentCount), { x: 210, y: 0 });
  const points = curve.sample(4000);
  for (const { x, y } of offset.segments().flatMap((piece) => [0.1, 0.3, 0.5, 0.7, 0.9].map((t) => piece.eval(t)))) {
    let nearest = Infinity;
    for (let i = 0; i < points.length; i += 2)
      nearest = Math.min(nearest, Math.hypot(points[i] - x, points[i + 1] - y));
    assert.ok(Math.abs(nearest - 10) < 0.0105, `${nearest}`);
  }
});

test("lines stay lines, turn-backs are rounded, points come back", () => {
  assert.deepEqual(new Curve([0, 0, 4, 3]).offset(5).toJSON().points, pointsOf("-3,4 1,7"));
  const back = new Curve([0, 0, 2, 0, 0, 0]).offset(1);
  assert.deepEqual(
    [back.eval(0), back.eval(back.segmentCount)],
    [
      { x: 0, y: 1 },
      { x: 0, y: -1 },
    ],
  );
  assert.ok(Math.abs(back.bounds().max.x - 2) < 1e-3);
  assert.deepEqual([...new Curve([1, 2, 1, 2]).offset(5).controlPoints()], [1, 2, 1, 2]);
  assert.deepEqual([...new Curve([0, 0, 1, 2, 3, 0]).offset(0).controlPoints()], [0, 0, 1, 2, 3, 0]);
});

test("what cannot be done is refused", () => {
  const curve = new Curve([0, 0, 0, 100, 200, 100, 200, 0]);
  assert.throws(() => curve.offset(NaN), {
    name: "RangeError",
    message: /^distance: expected a finite number, got NaN/,
  });
  assert.throws(() => curve.offset(/** @type {any} */ ("1")), { name: "TypeError", message: /^distance: / });
  assert.throws(() => curve.offset(1, { tolerance: 0 }), { name: "RangeError", message: /^tolerance: / });
  assert.throws(() => curve.offset(1, { tolerance: 1e-20 }), {
    name: "RangeError",
    message: /^tolerance: expected at least /,
  });
  assert.throws(() => curve.offset(1e308), { name: "RangeError", message: /^distance: / });
  assert.throws(() => new Curve([0, 0, 0, 1, 1, 1], { dimension: 3 }).offset(1), TypeError);
});

test("corners of a spline are joined", () => {
  const square = new Spline([0, 0, 4, 0, 4, 4, 0, 4], { degree: 1, closed: true });
  const round = square.offset(-1, { tolerance: 1e-6 });
  assert.ok(round.closed);
  assert.deepEqual(round.bounds(), { min: { x: -1, y: -1 }, max: { x: 5, y: 5 } });
  const miter = square.offset(-1, { join: "miter" });
  assert.deepEqual(miter.degrees, new Array(12).fill(1));
  assert.ok(miter.toJSON().points.some(([x, y]) => x === 5 && y === 5));
  assert.deepEqual(square.offset(-1, { join: "bevel" }).degrees, new Array(8).fill(1));
  assert.throws(() => square.offset(1, { join: /** @type {any} */ ("sharp") }), {
    name: "RangeError",
    message: /^join: /,
  });
});

test("reduce gives the closest curve, and how close", () => {
  const { curve, error } = new Curve([0, 0, 2, 0, 3, 1, 3, 3]).reduce();
  assert.ok(error < 1e-15);
  assert.ok(curve.equals(new Curve([0, 0, 3, 0, 3, 3]), 1e-14));
  assert.ok(Math.abs(new Curve([0, 0, 1, 2, 2, 0]).reduce().error - 1) < 1e-15);
});

test("a curve through points", () => {
  const points = pointsOf("0,0 1,2 3,1 4,4");
  const curve = Curve.interpolate(points, [0, 0.25, 0.5, 1]);
  [0, 0.25, 0.5, 1].forEach((t, i) => {
    const { x, y } = curve.eval(t);
    assert.ok(Math.hypot(x - points[i][0], y - points[i][1]) < 1e-14);
  });
  assert.equal(Curve.interpolate(pointsOf("0,0,1 1,2,3 3,1,0")).dimension, 3);
  assert.throws(() => Curve.interpolate(points, [0, 1, 1, 2]), {
    name: "RangeError",
    message: /^ts: expected parameters that differ/,
  });
  assert.throws(() => Curve.interpolate(points, [0, 1]), { name: "RangeError", message: /^ts: / });
  assert.throws(() => Curve.interpolate([[0, 0]]), { name: "RangeError", message: /^points: / });
});

test("a spline along a stroke, and with fewer segments", () => {
  const points = Array.from({ length: 500 }, (_, k) => [k / 50, Math.sin(k / 50)]);
  const fitted = Spline.fit(points, { tolerance: 1e-3 });
  assert.ok(fitted.segmentCount < 12);
  const line = fitted.flatten(1e-4).points;
  for (const [x, y] of points) {
    let nearest = Infinity;
    for (let i = 0; i + 3 < line.length; i += 2)
      nearest = Math.min(nearest, fromSegment(x, y, [...line.subarray(i, i + 4)]));
    assert.ok(nearest < 1.2e-3, `${nearest}`);
  }
  const corner = Spline.fit(pointsOf("0,0 1,0 2,0 2,1 2,2"), { tolerance: 0.01 });
  assert.equal(corner.segmentCount, 2);
  assert.ok(Spline.fit(pointsOf("0,0 1,0 1,1"), { tolerance: 0.01, closed: true }).closed);
  assert.equal(Spline.fit([0, 0, 0, 1, 1, 1], { tolerance: 0.1, dimension: 3 }).dimension, 3);
  const cut = fitted.insert(0.3).insert(0.5).insert(2.5);
  assert.ok(cut.simplify(1e-3).segmentCount < cut.segmentCount);
  assert.throws(() => Spline.fit([[0, 0]], { tolerance: 1 }), { name: "RangeError", message: /^points: / });
  assert.throws(() => Spline.fit(pointsOf("0,0 1,1"), { tolerance: 0 }), {
    name: "RangeError",
    message: /^tolerance: /,
  });
  assert.throws(() => cut.simplify(-1), { name: "RangeError", message: /^tolerance: / });
});

function fromSegment(x, y, /** @type {number[]} */ [ax, ay, bx, by]) {
  const [dx, dy] = [bx - ax, by - ay];
  const s = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1)));
  return Math.hypot(ax + s * dx - x, ay + s * dy - y);
}
