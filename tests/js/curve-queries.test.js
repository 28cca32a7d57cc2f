// Queries of curves: forms of points, keys, names of kinds. Their numbers are those of Rust (parity.test.js).
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve } from "casteljau";
import { CUBIC, near, pointsOf } from "./reference.js";

const arch = new Curve(CUBIC); // (24t² − 16t³, 24t − 24t²)

test("nearest: parameter, point and distance, ends included, in the plane and in space", () => {
  const parabola = new Curve([0, 0, 100, 0, 100, 100]);
  assert.deepEqual(parabola.nearest({ x: 80, y: 20 }), { t: 0.5, point: { x: 75, y: 25 }, distance: Math.hypot(5, 5) });
  assert.deepEqual(arch.nearest([-3, -4]), { t: 0, point: { x: 0, y: 0 }, distance: 5 });
  assert.deepEqual(arch.nearest([11, -4]), { t: 1, point: { x: 8, y: 0 }, distance: 5 });
  const line = new Curve(pointsOf("0,0,0 0,0,10"));
  assert.deepEqual(line.nearest([3, 4, 5]), { t: 0.5, point: { x: 0, y: 0, z: 5 }, distance: 5 });
  for (const scale of [1, 1e149, 1e-300]) {
    const curve = new Curve(CUBIC.map(([x, y]) => [x * scale, y * scale]));
    const { t, point, distance } = curve.nearest([4 * scale, 9 * scale]);
    near([t, point.x / scale, point.y / scale, distance / scale], [0.5, 4, 6, 3]);
  }
});

test("extrema: inside only, where the derivative changes its sign", () => {
  assert.deepEqual(arch.extrema(), { x: new Float64Array(0), y: Float64Array.of(0.5) });
  const space = new Curve(pointsOf("0,0,0 1,2,-1 2,-2,3 3,0,0")).extrema();
  assert.deepEqual(Object.keys(space), ["x", "y", "z"]);
  near(space.y, [0.5 - Math.sqrt(1 / 12), 0.5 + Math.sqrt(1 / 12)]);
});

test("inflections, cusps, classify, tangentsFrom", () => {
  near(new Curve([0, 0, 1, 0.25, 0, 1, 1, 0]).inflections(), [0.5, 0.8]);
  const cusp = new Curve([0, 0, 1, 1, 0, 1, 1, 0]);
  near(cusp.cusps(), [0.5]);
  assert.equal(cusp.inflections().length, 0);
  const classes = {
    point: "2,2 2,2",
    line: "0,0 2,2 1,1",
    quadratic: "0,0 2,2 4,0",
    arch: "0,0 0,8 8,8 8,0",
    serpentine: "0,0 1,2 2,-2 3,0",
    loop: "0,0 4,2 -2,2 2,0",
    cusp: "0,0 1,1 0,1 1,0",
    twisted: "0,0,0 1,0,0 1,1,0 1,1,1",
  };
  for (const [name, points] of Object.entries(classes)) {
    assert.equal(new Curve(pointsOf(points)).classify(), name);
    assert.equal(new Curve(pointsOf(points).map(([x, y, z = x + y]) => [x, z, y])).classify(), name);
  }
  near(arch.tangentsFrom([10, 6]), [0.5]);
  near(new Curve([0, 0, 1, 1]).tangentsFrom({ x: 3, y: 3 }), [0, 1]);
});
