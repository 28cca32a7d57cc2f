// Points by length. Lengths, even steps, areas and frames are those of Rust (parity.test.js).
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Spline } from "casteljau";
import { near, pointsOf } from "./reference.js";

const line = new Curve([0, 0, 3, 4]);

test("pointAtLength: y = x² after ½x√(1 + 4x²) + ¼ asinh 2x, and the ends for lengths outside", () => {
  const parabola = new Curve([0, 0, 1, 0, 2, 4]);
  for (const x of [0.1, 0.7, 1.9]) {
    const slope = Math.hypot(1, 2 * x);
    const { t, point, tangent, normal } = parabola.pointAtLength(0.5 * x * slope + 0.25 * Math.asinh(2 * x));
    near([t, point.x, point.y], [x / 2, x, x * x], 1e-10);
    near([tangent.x, tangent.y, normal.x, normal.y], [1 / slope, (2 * x) / slope, (-2 * x) / slope, 1 / slope], 1e-10);
  }
  const ends = [-1, 11].map((s) => line.pointAtLength(s)).map(({ t, point }) => [t, point.x, point.y]);
  assert.deepEqual(ends.flat(), [0, 0, 0, 1, 3, 4]);
  const { point, tangent, normal } = new Curve(pointsOf("0,0,0 1,2,2")).pointAtLength(1.5);
  near(point, [0.5, 1, 1]);
  near(tangent, [1 / 3, 2 / 3, 2 / 3]);
  assert.deepEqual(normal, { x: 0, y: 0, z: 0 });
});

test("pointAtLength: on a spline across its joints, the next segment at a joint, closed and open", () => {
  const corner = [0, 0, 3, 0, 3, 4];
  const open = new Spline(corner, { degree: 1 });
  const [tangent, normal] = [pointsOf("1,0"), pointsOf("0,1")].map(([[x, y]]) => ({ x, y }));
  assert.deepEqual(open.pointAtLength(1.5), { t: 0.5, point: { x: 1.5, y: 0 }, tangent, normal });
  assert.deepEqual(open.pointAtLength(3).tangent, { x: 0, y: 1 });
  const ts = [7, 70, -1].map((s) => open.pointAtLength(s).t);
  assert.deepEqual(ts, [2, 2, 0]);
  const found = new Spline(corner, { degree: 1, closed: true }).pointAtLength(9.5);
  near([found.t, found.point.x, found.point.y, found.tangent.x, found.tangent.y], [2.5, 1.5, 2, -0.6, -0.8]);
  const still = new Spline([4, 4, 4, 4], { degree: 1 }).pointAtLength(1);
  assert.deepEqual([still.point, still.tangent, still.normal].flatMap(Object.values), [4, 4, 0, 0, 0, 0]);
});
