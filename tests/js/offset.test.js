import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Spline } from "../../js/index.js";

test("a parallel keeps its distance and its ends", () => {
  const curve = new Curve([0, 0, 0, 100, 200, 100, 200, 0]);
  const offset = curve.offset(10, { tolerance: 0.01 });
  assert.ok(offset instanceof Spline);
  assert.deepEqual(offset.eval(0), { x: -10, y: 0 });
  assert.deepEqual(offset.eval(offset.segmentCount), { x: 210, y: 0 });
  const points = curve.sample(4000);
  for (const { x, y } of offset.segments().flatMap((piece) => [0.1, 0.3, 0.5, 0.7, 0.9].map((t) => piece.eval(t)))) {
    let nearest = Infinity;
    for (let i = 0; i < points.length; i += 2) nearest = Math.min(nearest, Math.hypot(points[i] - x, points[i + 1] - y));
    assert.ok(Math.abs(nearest - 10) < 0.0105, `${nearest}`);
  }
});

test("lines stay lines, turn-backs are rounded, points come back", () => {
  assert.deepEqual(new Curve([0, 0, 4, 3]).offset(5).toJSON().points, [[-3, 4], [1, 7]]);
  const back = new Curve([0, 0, 2, 0, 0, 0]).offset(1);
  assert.deepEqual([back.eval(0), back.eval(back.segmentCount)], [{ x: 0, y: 1 }, { x: 0, y: -1 }]);
  assert.ok(Math.abs(back.bounds().max.x - 2) < 1e-3);
  assert.deepEqual([...new Curve([1, 2, 1, 2]).offset(5).controlPoints()], [1, 2, 1, 2]);
  assert.deepEqual([...new Curve([0, 0, 1, 2, 3, 0]).offset(0).controlPoints()], [0, 0, 1, 2, 3, 0]);
});

test("what cannot be done is refused", () => {
  const curve = new Curve([0, 0, 0, 100, 200, 100, 200, 0]);
  assert.throws(() => curve.offset(NaN), { name: "RangeError", message: /^distance: expected a finite number, got NaN/ });
  assert.throws(() => curve.offset(/** @type {any} */ ("1")), { name: "TypeError", message: /^distance: / });
  assert.throws(() => curve.offset(1, { tolerance: 0 }), { name: "RangeError", message: /^tolerance: / });
  assert.throws(() => curve.offset(1, { tolerance: 1e-20 }), { name: "RangeError", message: /^tolerance: expected at least / });
  assert.throws(() => curve.offset(1e308), { name: "RangeError", message: /^distance: / });
  assert.throws(() => new Curve([0, 0, 0, 1, 1, 1], { dimension: 3 }).offset(1), TypeError);
});
