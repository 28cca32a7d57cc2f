// Offsets, reduction, interpolation and fitting of curves and splines; tests/offset in Rust compares many with references.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Path, Spline } from "#js/index.js";
import { near, pointsOf } from "./reference.js";

const ARCH = new Curve([0, 0, 0, 100, 200, 100, 200, 0]);

test("a parallel keeps its distance and its ends", () => {
  const offset = ARCH.offset(10, { tolerance: 0.01 });
  assert.ok(offset instanceof Spline);
  near([offset.eval(0), offset.eval(offset.segmentCount)].flatMap(Object.values), [-10, 0, 210, 0], 0);
  const between = offset.evalAt(Array.from({ length: 50 }, (_, i) => ((i + 0.3) * offset.segmentCount) / 50));
  for (let i = 0; i < between.length; i += 2) {
    const { distance } = ARCH.nearest([between[i], between[i + 1]]);
    assert.ok(Math.abs(distance - 10) < 0.0105, `${distance}`);
  }
  assert.ok(ARCH.offset(10, { tolerance: 1e-6 }).segmentCount > offset.segmentCount);
});

test("lines stay lines, turn-backs are rounded, points come back", () => {
  assert.deepEqual(new Curve([0, 0, 4, 3]).offset(5).toJSON().points, pointsOf("-3,4 1,7"));
  const back = new Curve([0, 0, 2, 0, 0, 0]).offset(1);
  near([back.eval(0), back.eval(back.segmentCount)].flatMap(Object.values), [0, 1, 0, -1], 0);
  near(back.bounds().max.x, 2, 1e-3);
  assert.deepEqual([...new Curve([1, 2, 1, 2]).offset(5).controlPoints()], [1, 2, 1, 2]);
});

test("each join means the same for offset curves, regions and strokes", () => {
  const outline = new Spline([0, 0, 10, 0, 10, 10, 0, 10], { degree: 1, closed: true });
  const square = new Path([outline]);
  const angle = Path.polygon([0, 0, 10, 0, 10, 10], { closed: false });
  /** @type {["round" | "miter" | "bevel", number][]} */
  const corners = [
    ["round", Math.PI / 4],
    ["miter", 1],
    ["bevel", 1 / 2],
  ];
  for (const [join, corner] of corners) {
    const areas = [
      new Path([outline.offset(-1, { join, tolerance: 1e-6 })]).area() - 140,
      square.offset(1, { join, tolerance: 1e-6 }).area() - 140,
      4 * (angle.stroke(2, { join, tolerance: 1e-6 }).area() - 39),
    ];
    near(areas, Array(3).fill(4 * corner), 1e-4);
    assert.ok(angle.strokeContains([10.7, -0.7], 2, { join }) === (join !== "bevel"));
  }
});

test("corners of a spline are joined", () => {
  const square = new Spline([0, 0, 4, 0, 4, 4, 0, 4], { degree: 1, closed: true });
  const round = square.offset(-1, { tolerance: 1e-6 });
  assert.ok(round.closed && square.offset(-1).equals(square.offset(-1, { join: "round" })));
  assert.deepEqual(round.bounds(), { min: { x: -1, y: -1 }, max: { x: 5, y: 5 } });
  const miter = square.offset(-1, { join: "miter" });
  assert.deepEqual(miter.degrees, new Array(12).fill(1));
  assert.ok(miter.toJSON().points.some(([x, y]) => x === 5 && y === 5));
  assert.deepEqual(square.offset(-1, { join: "bevel" }).degrees, new Array(8).fill(1));
  const [coarse, fine] = [0.1, 1e-6].map((tolerance) => Spline.fromCurves([ARCH]).offset(10, { tolerance }));
  assert.ok(coarse.segmentCount < fine.segmentCount);
});

test("reduce gives the closest curve, and how close", () => {
  const { curve, error } = new Curve([0, 0, 2, 0, 3, 1, 3, 3]).reduce();
  near([...curve.controlPoints(), error], [0, 0, 3, 0, 3, 3, 0]);
  near(new Curve([0, 0, 1, 2, 2, 0]).reduce().error, 1);
});

test("a curve through points", () => {
  const points = pointsOf("0,0 1,2 3,1 4,4");
  const ts = [0, 0.25, 0.5, 1];
  near(Curve.interpolate(points, ts).evalAt(ts), points.flat());
  assert.equal(Curve.interpolate(pointsOf("0,0,1 1,2,3 3,1,0")).dimension, 3);
});

test("a spline along a stroke, and with fewer segments", () => {
  const points = Array.from({ length: 500 }, (_, k) => [k / 50, Math.sin(k / 50)]);
  const fitted = Spline.fit(points, { tolerance: 1e-3 });
  assert.ok(fitted.segmentCount < 12);
  for (const point of points) assert.ok(fitted.nearest(point).distance < 1.1e-3);
  const corner = pointsOf("0,0 1,0 2,0 2,1 2,2");
  const [sharp, smooth] = [undefined, 3].map((cornerAngle) => Spline.fit(corner, { tolerance: 0.01, cornerAngle }));
  assert.deepEqual([sharp.segmentCount, sharp.continuity(1).g1], [2, false]);
  for (let k = 1; k < smooth.segmentCount; k++) assert.ok(smooth.continuity(k).g1);
  assert.ok(Spline.fit([0, 0, 1, 0, 1, 1], { tolerance: 0.01, closed: true }).closed);
  assert.equal(Spline.fit([0, 0, 0, 1, 1, 1], { tolerance: 0.1, dimension: 3 }).dimension, 3);
  const cut = fitted.insert(0.3).insert(0.5).insert(2.5);
  assert.ok(cut.simplify(1e-3).segmentCount < cut.segmentCount);
});

test("simplified: joints at the extrema, rounded control points, the closest fit", () => {
  const circle = Path.circle([3.1, 7.3], 50).transform("rotate(30)");
  const four = circle.simplify(0.05, { extrema: true });
  assert.equal(four.subpaths[0].segmentCount, 4);
  assert.ok(
    four.subpaths[0].segments().every((curve) => Object.values(curve.extrema()).every(({ length }) => length === 0)),
  );
  const whole = circle.simplify(0.75, { precision: 0, extrema: true });
  assert.ok(whole.subpaths[0].controlPoints().every(Number.isInteger));
  const points = Array.from({ length: 200 }, (_, k) => [k / 20, Math.sin(k / 20)]);
  /** @param {Spline} spline */
  const farthest = (spline) => Math.max(...points.map((point) => spline.nearest(point).distance));
  /** @type {("fast" | "best")[]} */
  const efforts = ["fast", "best"];
  const [fast, best] = efforts.map((effort) => Spline.fit(points, { tolerance: 0.01, effort }));
  assert.ok(best.segmentCount <= fast.segmentCount && farthest(best) < farthest(fast));
  const line = new Spline(points.flat(), { degree: 1 });
  const [plain, closest] = efforts.map((effort) => line.simplify(0.01, { effort }));
  assert.ok(closest.segmentCount <= plain.segmentCount && farthest(closest) < farthest(plain));
});
