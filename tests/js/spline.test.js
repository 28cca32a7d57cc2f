// Splines as JavaScript sees them: parts, forms of joints, options of fits, JSON. Their numbers are those of Rust (parity.test.js).
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Path, Spline } from "casteljau";
import { near, owned, pairs, pointsOf, SEVEN } from "./reference.js";

const seven = new Spline(SEVEN);
const RING = pointsOf("1,0 1,1 0,1 -1,1 -1,0 -1,-1 0,-1 1,-1");
const ring = new Spline(RING, { degree: 2, closed: true });
const mixed = Spline.fromCurves([new Curve(pointsOf("0,0,0 1,0,0")), new Curve(pointsOf("1,0,0 2,0,1 2,1,1"))]);
/** In the plane and in space. */
const [FOUR, FIVE] = [pointsOf("0,0 1,1 3,1 4,0"), pointsOf("0,0,0 1,2,3 3,3,-1 4,0,2 5,5,5")];
const netOf = (spline) => pairs(spline.controlPoints(), spline.dimension);

test("seven points are two cubics; a closed spline has n · degree points", () => {
  assert.deepEqual([seven.segmentCount, seven.degrees, seven.closed, seven.dimension], [2, [3, 3], false, 2]);
  assert.deepEqual([ring.segmentCount, ring.degrees, ring.closed], [4, [2, 2, 2, 2], true]);
  assert.deepEqual(netOf(seven), SEVEN);
  const nets = seven.segments().map((curve) => pairs(curve.controlPoints()));
  assert.deepEqual(nets, [SEVEN.slice(0, 4), SEVEN.slice(3)]);
  assert.deepEqual(pairs(ring.segments()[3].controlPoints()), pointsOf("0,-1 1,-1 1,0"));
  assert.deepEqual([mixed.degrees, mixed.dimension], [[1, 2], 3]);
});

test("fromCurves keeps degrees and closes", () => {
  assert.ok(Spline.fromCurves(seven.segments()).equals(seven));
  assert.ok(Spline.fromCurves(ring.segments(), { closed: true }).equals(ring));
  const open = Spline.fromCurves(ring.segments());
  assert.deepEqual([open.closed, open.controlPoints().length], [false, 18]);
});

test("flatten has a vertex at each joint", () => {
  const { points, ts } = ring.flatten(0.01);
  [points, ts].forEach(owned);
  assert.ok([0, 1, 2, 3, 4].every((t) => ts.includes(t)));
  near(points, ring.evalAt(ts));
  // The ring is no farther than 1/√2 … 1 from the middle; so are its chords, but for the tolerance.
  for (const [x, y] of pairs(points)) assert.ok(Math.hypot(x, y) <= 1.0607 && Math.hypot(x, y) >= 0.99);
});

test("movePoint puts the point at the given position and keeps the joint", () => {
  const at = (index, to, mode) => netOf(seven.movePoint(index, to, mode && { joints: { 1: mode } }));
  assert.deepEqual(at(2, [5, 0], "g1").slice(2, 5), pointsOf("5,0 2,0 -2,0"));
  assert.deepEqual(at(2, { x: 5, y: 0 }, "c1").slice(2, 5), pointsOf("5,0 2,0 -1,0"));
  assert.deepEqual(at(2, [5, 0], "free").slice(2, 5), pointsOf("5,0 2,0 2,-4"));
  assert.deepEqual(at(2, [5, 0]).slice(2, 5), pointsOf("5,0 2,0 2,-4"));
  assert.deepEqual(at(3, [3, 1], "g1").slice(2, 5), pointsOf("3,3 3,1 3,-3"));
  assert.deepEqual(at(4, Float32Array.of(5, 0), "c1").slice(2, 5), pointsOf("-1,0 2,0 5,0"));
  assert.deepEqual(netOf(seven), SEVEN);
});

test("joints as an array, with holes, and at the seam of a closed spline", () => {
  const joints = [];
  joints[1] = "g1";
  assert.deepEqual(netOf(seven.movePoint(2, [5, 0], { joints }))[4], [-2, 0]);
  const moved = ring.movePoint(1, [2, 1], { joints: ["c1", "c1", "c1", "c1"] });
  assert.deepEqual([netOf(moved)[1], netOf(moved)[7], netOf(moved)[3]], pointsOf("2,1 0,-1 -2,1"));
  const ends = seven.movePoint(2, [1, 2], { joints: ["free", "c1", undefined, undefined] });
  assert.ok(ends.equals(seven.movePoint(2, [1, 2], { joints: { 1: "c1" } })));
});

test("default values of options", () => {
  assert.ok(Spline.interpolate(FOUR).equals(Spline.interpolate(FOUR, { kind: "natural" })));
  const rounded = Spline.interpolate(FIVE, { kind: "catmull-rom" });
  assert.ok(rounded.equals(Spline.interpolate(FIVE, { kind: "catmull-rom", alpha: 0.5 })));
  assert.ok(Spline.fromBSpline(FIVE).equals(Spline.fromBSpline(FIVE, { degree: 3, closed: false })));
  assert.ok(seven.offset(1).equals(seven.offset(1, { join: "round" })));
});

test("equals, toJSON, fromJSON", () => {
  for (const spline of [seven, ring, mixed]) {
    const again = Spline.fromJSON(JSON.parse(JSON.stringify(spline)));
    assert.ok(again.equals(spline));
    assert.deepEqual(again.toJSON(), spline.toJSON());
  }
  assert.deepEqual(seven.toJSON(), { points: SEVEN, degrees: [3, 3], closed: false });
  assert.ok(!seven.equals(seven.reverse()) && !ring.equals(new Spline(RING.slice(0, 7), { degree: 2 }), 100));
  assert.ok(seven.equals(seven.movePoint(0, [0, 0.5]), 0.5) && !seven.equals(seven.movePoint(0, [0, 0.5]), 0.4));
});

test("long chains go through in one piece", () => {
  const points = Float64Array.from({ length: 2 * 300_001 }, (_, i) => i % 101);
  const spline = new Spline(points, { degree: 1 });
  assert.equal(spline.segmentCount, 300_000);
  const joints = new Array(300_000).fill("g1");
  assert.deepEqual(spline.movePoint(150_000, [7, 7], { joints }).eval(150_000), { x: 7, y: 7 });
  assert.ok(Spline.fromCurves(spline.segments()).equals(spline));
  assert.ok(Spline.fromJSON(spline.toJSON()).equals(spline));
  assert.equal(spline.sample(4).length, 2 * 1_200_001);
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

test("toBSpline and back gives the same spline", () => {
  const several = [
    Spline.interpolate(FOUR),
    Spline.interpolate(FIVE, { closed: true }),
    new Spline(FOUR, { degree: 1 }),
    new Spline(FOUR, { degree: 2, closed: true }),
    Spline.fromBSpline(FIVE, { degree: 4, closed: true }),
  ];
  for (const spline of several) {
    const { points, ...options } = spline.toBSpline();
    [points, options.knots].forEach(owned);
    assert.ok(Spline.fromBSpline(points, options).equals(spline));
  }
  const { knots, degree, closed } = Spline.interpolate(FOUR.slice(1)).toBSpline();
  assert.deepEqual([[...knots], degree, closed], [[0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2], 3, false]);
});

test("a million points", () => {
  const numbers = Float64Array.from({ length: 2e6 }, (_, i) => (i * 7919) % 1009);
  for (const spline of [
    Spline.interpolate(numbers),
    Spline.interpolate(numbers, { kind: "catmull-rom", closed: true }),
    Spline.fromBSpline(numbers),
  ]) {
    assert.ok(spline.segmentCount > 999_990);
    assert.ok(spline.controlPoints().every(Number.isFinite));
  }
});
