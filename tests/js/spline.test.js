// Every public method of Spline.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Spline } from "casteljau";
import { coordinates, deCasteljau, near, owned, pairs, pointsOf, refusedAll, SEVEN } from "./reference.js";

const seven = new Spline(SEVEN);
const RING = pointsOf("1,0 1,1 0,1 -1,1 -1,0 -1,-1 0,-1 1,-1");
const ring = new Spline(RING, { degree: 2, closed: true });
const mixed = Spline.fromCurves([new Curve(pointsOf("0,0,0 1,0,0")), new Curve(pointsOf("1,0,0 2,0,1 2,1,1"))]);
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

test("eval, evalAt and sample: segment k covers t from k to k + 1", () => {
  for (const t of [0, 0.25, 0.9, 1, 1.5, 2]) {
    const k = Math.min(1, Math.floor(t));
    near(seven.eval(t), deCasteljau(SEVEN.slice(3 * k, 3 * k + 4), t - k));
  }
  assert.deepEqual(seven.eval(1), { x: 2, y: 0 });
  assert.deepEqual(ring.eval(4), { x: 1, y: 0 });
  assert.deepEqual(mixed.eval(0.5), { x: 0.5, y: 0, z: 0 });
  const all = (spline, ts) => ts.flatMap((t) => coordinates(spline.eval(t)));
  near(seven.evalAt([0.5, 1.5]), all(seven, [0.5, 1.5]));
  near(ring.sample(2), all(ring, [0, 0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4]));
});

test("flatten has a vertex at each joint", () => {
  const { points, ts } = ring.flatten(0.01);
  [points, ts].forEach(owned);
  assert.ok([0, 1, 2, 3, 4].every((t) => ts.includes(t)));
  near(points, ring.evalAt(ts));
  // The ring is no farther than 1/√2 … 1 from the middle; so are its chords, but for the tolerance.
  for (const [x, y] of pairs(points)) assert.ok(Math.hypot(x, y) <= 1.0607 && Math.hypot(x, y) >= 0.99);
});

test("bounds and controlBounds", () => {
  assert.deepEqual(ring.bounds(), { min: { x: -1, y: -1 }, max: { x: 1, y: 1 } });
  assert.deepEqual(seven.controlBounds(), { min: { x: 0, y: -4 }, max: { x: 4, y: 2 } });
  assert.deepEqual(mixed.bounds().max, { x: 2, y: 1, z: 1 });
});

test("continuity of known joints", () => {
  const { angle, ...flags } = seven.continuity(1);
  assert.deepEqual(flags, { c0: true, g1: true, c1: false, g2: false, c2: false, gap: 0 });
  assert.equal(angle, 0);
  assert.ok(ring.continuity(0).c1 && ring.continuity(0).g2 && !ring.continuity(0).c2);
  const corner = new Spline([0, 0, 1, 0, 1, 1], { degree: 1 });
  near([corner.continuity(1).angle], [Math.PI / 2]);
  assert.ok(corner.continuity(1, 10).c1);
  const [left, right] = new Curve(SEVEN.slice(0, 4)).split(0.5);
  assert.ok(Spline.fromCurves([left, right]).continuity(1).c2);
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

test("setJoint keeps the handle before the joint", () => {
  assert.deepEqual(netOf(seven.setJoint(1, "c1"))[4], [2, -2]);
  const broken = seven.movePoint(4, [5, 4]);
  assert.deepEqual(netOf(broken.setJoint(1, "g1"))[4], [2, -5]);
  assert.ok(broken.setJoint(1, "free").equals(broken));
});

test("joints of second order and automatic ones", () => {
  const moved = netOf(seven.movePoint(2, [3, 1], { joints: { 1: "c2" } }));
  assert.deepEqual([moved[4], moved[5]], pointsOf("1,-1 -4,-2"));
  const bent = seven.movePoint(5, [-6, -2]).movePoint(2, [2, 1], { joints: { 1: "g2" } });
  assert.ok(bent.continuity(1).g2);
  assert.deepEqual(netOf(bent)[4], [2, -2]);
  // Joints on a line: so are the handles; at the free ends a third of the way.
  const straight = netOf(seven.movePoint(3, [3, 0], { joints: { 1: "auto" } }));
  near([straight[1], straight[5], straight[2].slice(1), straight[4].slice(1)].flat(), [1, 0, 11 / 3, 0, 0, 0]);
  assert.ok(seven.setJoint(1, "c2").continuity(1).c2);
  near(netOf(seven.setJoint(1, "auto")).slice(2, 5).flat(), [4 / 3, 0, 2, 0, 8 / 3, 0]);
  const space = new Spline(SEVEN.map(([x, y]) => [x, y, 1]));
  assert.ok(space.movePoint(2, [1, 1, 5], { joints: { 1: "c2" } }).continuity(1).c2);
  refusedAll(RangeError, [
    [() => space.setJoint(1, "g2"), /^mode: expected a 2D spline for "g2", got a 3D one$/],
    [() => space.movePoint(0, [0, 0, 0], { joints: { 1: "g2" } }), /^joints\[1\]: expected a 2D spline for "g2"/],
  ]);
});

test("insert keeps the curve, remove undoes it", () => {
  [1.25, 3.5, 0.5, 1.75].forEach((t, i) => {
    const spline = [seven, ring, mixed, mixed][i];
    const more = spline.insert(t);
    const k = Math.floor(t);
    assert.equal(more.segmentCount, spline.segmentCount + 1);
    near(more.eval(k + 1), spline.eval(t));
    near(more.eval(k + 0.5), spline.eval(k + (t - k) / 2));
    assert.ok(more.remove(k + 1).equals(spline, 1e-12));
  });
  assert.ok(seven.insert(1).equals(seven));
});

test("append goes on in the direction of arrival", () => {
  const longer = seven.append([7, 3]);
  assert.deepEqual([longer.segmentCount, longer.degrees], [3, [3, 3, 3]]);
  assert.deepEqual(longer.eval(3), { x: 7, y: 3 });
  assert.ok(longer.continuity(2).g1);
  assert.deepEqual(netOf(longer).slice(0, 7), SEVEN);
  assert.deepEqual(mixed.append({ x: 0, y: 5, z: 0 }).degrees, [1, 2, 2]);
});

test("reverse and transform", () => {
  for (const spline of [seven, ring, mixed]) {
    const back = spline.reverse();
    for (const t of [0, 0.3, 1, 1.6]) near(back.eval(spline.segmentCount - t), spline.eval(t));
    assert.ok(back.reverse().equals(spline));
  }
  const image = SEVEN.map(([x, y]) => [2 * x + 10, 5 - y]);
  assert.deepEqual(netOf(seven.transform([2, 0, 0, -1, 10, 5])), image);
  assert.deepEqual(mixed.transform([0, 1, -1, 0, 0, 0]).eval(2), { x: -1, y: 2, z: 1 });
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
