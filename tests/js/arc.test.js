// Lengths, points by length, even steps, areas and frames of curves and splines, by closed forms. The integration is tested in Rust
// (tests/arc); here stands what JavaScript adds: options, splines, results, refusals.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Spline } from "casteljau";
import { CUBIC, near, owned, pointsOf, SEVEN, SPACE, TWISTED } from "./reference.js";

const line = new Curve([0, 0, 3, 4]);
const square = new Spline([0, 0, 2, 0, 2, 2, 0, 2], { degree: 1, closed: true });
const CURVES = [[0, 0, 3, 4], [0, 0, 1, 0, 0, 0], CUBIC, SPACE, [0, 0, 9, 1, -3, 4, 5, 5, 2, 0, 0, 7]];

test("length: closed forms in the plane and in space, of pieces, and within a tolerance", () => {
  assert.deepEqual([line.length(), new Curve(pointsOf("0,0,0 1,2,2")).length()], [5, 3]);
  near([new Curve([0, 0, 0.5, 1, 1, 0]).length()], [Math.sqrt(5) / 2 + Math.asinh(2) / 4], 1e-15);
  // (t², t³) from −1 to 1
  for (const size of [1, 1e-300, 1e149]) {
    const cusp = new Curve([1, -1, -1 / 3, 1, -1 / 3, -1, 1, 1].map((x) => x * size));
    near([cusp.length() / size], [(2 * (13 * Math.sqrt(13) - 8)) / 27]);
  }
  for (const points of CURVES) {
    const curve = new Curve(points);
    const [left, right] = curve.split(0.77);
    near([left.length() + right.length()], [curve.length()]);
    for (const tolerance of [1, 1e-3, 1e-6, 1e-9]) near([curve.length(tolerance)], [curve.length()], tolerance);
  }
});

test("area: swept from the origin", () => {
  near([new Curve([1, 0, 2 / 3, 1, 1 / 3, 1, 0, 1]).area()], [0.75], 1e-15);
  assert.deepEqual([new Curve([2, 0, 0, 3]).area(), new Curve([0, 3, 2, 0]).area()], [3, -3]);
});

test("timeAtLength and equidistantTimes: the length up to t is s", () => {
  for (const points of CURVES) {
    const curve = new Curve(points);
    const whole = curve.length();
    const upTo = (t) => curve.split(t)[0].length();
    near([upTo(curve.timeAtLength(0.25 * whole))], [0.25 * whole], 4e-12 * whole);
    near([upTo(curve.timeAtLength(0.3 * whole, 1e-3))], [0.3 * whole], 1e-3);
    const ends = [-1, 0, whole, 1e9].map((s) => curve.timeAtLength(s));
    assert.deepEqual(ends, [0, 0, 1, 1]);
    const ts = curve.equidistantTimes(7);
    owned(ts);
    assert.deepEqual([ts.length, ts[0], ts[7]], [8, 0, 1]);
    ts.forEach((t, i) => near([upTo(t)], [(i * whole) / 7], 4e-12 * whole));
  }
  assert.deepEqual([...line.equidistantTimes(4)], [0, 0.25, 0.5, 0.75, 1]);
  assert.deepEqual([...new Curve([1, 1, 1, 1]).equidistantTimes(2)], [0, 0.5, 1]);
});

test("splines: length, timeAtLength, equidistantTimes, area", () => {
  const open = new Spline(SEVEN);
  const lengths = open.segments().map((curve) => curve.length());
  near([open.length(), open.length(1e-3)], [lengths[0] + lengths[1], open.length()], 1e-3);
  near([open.length()], [lengths[0] + lengths[1]]);
  const times = [lengths[0], -1, open.length(), 1e9].map((s) => open.timeAtLength(s));
  assert.deepEqual(times, [1, 0, 2, 2]);
  const ts = open.equidistantTimes(10);
  owned(ts);
  assert.deepEqual([ts.length, ts[0], ts[10]], [11, 0, 2]);
  ts.slice(1, 10).forEach((t, i) => near([open.split(t)[0].length()], [((i + 1) * open.length()) / 10]));
  assert.deepEqual([square.length(), square.area(), square.reverse().area()], [8, 4, -4]);
  near([square.timeAtLength(5)], [2.5]);
  const space = new Spline([...SPACE, [5, 0, 0], [6, 1, 1], [7, 0, 2]]);
  near([space.length()], [space.segments().reduce((sum, curve) => sum + curve.length(), 0)]);
});

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

test("frames: orthonormal, as many as asked for, from the normal that is asked for", () => {
  const dot = (u, v) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  const at = (array, i) => [...array.slice(3 * i, 3 * i + 3)];
  const curve = new Curve(TWISTED);
  for (const target of [curve, new Spline(TWISTED), new Spline([...TWISTED, [2, 1, 4], [2, 0, 3], [1, 0, 3]])]) {
    const segments = target instanceof Spline ? target.segmentCount : 1;
    const even = Array.from({ length: 8 * segments + 1 }, (_, i) => i / 8);
    for (const ts of [even, [...target.equidistantTimes(10)], [0.1, 0.5, 0.2]]) {
      const frames = target.frames(ts === even ? 8 : ts);
      Object.values(frames).forEach(owned);
      near(frames.points, target.evalAt(ts));
      ts.forEach((_, i) => {
        const [u, v, w] = [frames.tangents, frames.normals, frames.binormals].map((array) => at(array, i));
        near([dot(u, u), dot(v, v), dot(w, w), dot(u, v), dot(v, w), dot(w, u)], [1, 1, 1, 0, 0, 0]);
        near([u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]], w);
      });
    }
  }
  near(at(curve.frames(1).normals, 1), at(curve.frames(1000).normals, 1000), 1e-9);
  near(at(curve.frames(1).normals, 0), [0, 1, 0]);
  // In a plane the given direction stays, also across the cusp.
  const cusp = new Curve(pointsOf("0,0,5 1,1,5 0,1,5 1,0,5"));
  const { normals } = cusp.frames(7, { normal: { x: 3, y: 0, z: 1 } });
  const up = cusp.frames(7, { normal: [0, 0, 2] });
  for (let i = 0; i <= 7; i++) near([...at(up.normals, i), normals[3 * i + 2]], [0, 0, 1, normals[2]], 1e-9);
});
