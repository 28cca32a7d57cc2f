// The point, the tangent and the normal at an arc length.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Spline } from "casteljau";
import { near, refused } from "./reference.js";

test("pointAtLength: on a line, and the ends for lengths outside", () => {
  const line = new Curve([
    [0, 0],
    [6, 8],
  ]);
  const { t, point, tangent, normal } = line.pointAtLength(2.5);
  near([t], [0.25]);
  near(point, [1.5, 2]);
  near(tangent, [0.6, 0.8]);
  near(normal, [-0.8, 0.6]);
  assert.deepEqual(line.pointAtLength(-1).point, { x: 0, y: 0 });
  assert.deepEqual([line.pointAtLength(11).t, line.pointAtLength(11).point], [1, { x: 6, y: 8 }]);
});

test("pointAtLength: at x on y = x² after ½x√(1 + 4x²) + ¼ asinh 2x", () => {
  const parabola = new Curve([
    [0, 0],
    [1, 0],
    [2, 4],
  ]);
  for (const x of [0.1, 0.7, 1.3, 1.9]) {
    const slope = Math.hypot(1, 2 * x);
    const { t, point, tangent } = parabola.pointAtLength(0.5 * x * slope + 0.25 * Math.asinh(2 * x));
    near([t], [x / 2], 1e-10);
    near(point, [x, x * x], 1e-10);
    near(tangent, [1 / slope, (2 * x) / slope], 1e-10);
  }
});

test("pointAtLength: on a spline across its joints, the next segment at a joint, closed and open", () => {
  const points = [
    [0, 0],
    [3, 0],
    [3, 4],
  ];
  const open = new Spline(points, { degree: 1 });
  assert.deepEqual(open.pointAtLength(1.5), {
    t: 0.5,
    point: { x: 1.5, y: 0 },
    tangent: { x: 1, y: 0 },
    normal: { x: 0, y: 1 },
  });
  assert.deepEqual(open.pointAtLength(3).tangent, { x: 0, y: 1 });
  assert.deepEqual([open.pointAtLength(7).t, open.pointAtLength(70).t, open.pointAtLength(-1).t], [2, 2, 0]);
  const closed = new Spline(points, { degree: 1, closed: true });
  const { t, point, tangent } = closed.pointAtLength(9.5);
  near([t], [2.5]);
  near(point, [1.5, 2]);
  near(tangent, [-0.6, -0.8]);
});

test("pointAtLength: z in 3D, zero directions on a point", () => {
  const space = new Curve([
    [0, 0, 0],
    [1, 2, 2],
  ]);
  const { point, tangent, normal } = space.pointAtLength(1.5);
  near(point, [0.5, 1, 1]);
  near(tangent, [1 / 3, 2 / 3, 2 / 3]);
  assert.deepEqual(normal, { x: 0, y: 0, z: 0 });
  const still = new Spline([4, 4, 4, 4], { degree: 1 }).pointAtLength(1);
  near(still.point, [4, 4], 0);
  near([...Object.values(still.tangent), ...Object.values(still.normal)], [0, 0, 0, 0], 0);
});

test("pointAtLength refuses what is not a finite number", () => {
  for (const value of [new Curve([0, 0, 1, 1]), new Spline([0, 0, 1, 1], { degree: 1 })]) {
    refused(() => value.pointAtLength(Infinity), RangeError, /^s: /);
    refused(() => value.pointAtLength("1"), TypeError, /^s: /);
  }
});
