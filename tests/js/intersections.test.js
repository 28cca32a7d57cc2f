// Intersections between any two of curve, spline and path: the same points, and each position in its own form.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Path, Spline } from "casteljau";
import { near, pointsOf, untyped } from "./reference.js";

const arch = new Curve([0, 0, 0, 4, 4, 4, 4, 0]);
/** Two lines, the second one of two segments; both cross the arch. */
const lines = Path.fromSVG("M0 1H4 M0 0.5H2H4");
const square = new Spline([0, 0, 2, 0, 2, 2, 0, 2], { degree: 1, closed: true });

test("splines: t and u count segments, a joint is one intersection, a shared piece across joints is one", () => {
  const diagonal = new Curve([-1, -1, 3, 3]);
  assert.deepEqual(square.intersections(diagonal), [
    { t: 0, u: 0.25, point: { x: 0, y: 0 }, kind: "cross" },
    { t: 2, u: 0.75, point: { x: 2, y: 2 }, kind: "cross" },
  ]);
  const opposite = diagonal.intersections(square).map(({ t, u }) => [t, u]);
  assert.deepEqual(opposite, pointsOf("0.25,0 0.75,2"));
  const overlaps = square.intersections(new Spline([-1, 0, 1, 0, 1.5, 0, 3, 0], { degree: 1 }));
  assert.deepEqual(overlaps, [{ t: 0, u: 0.5, point: { x: 0, y: 0 }, kind: "overlap", tEnd: 1, uEnd: 2 + 1 / 3 }]);
});

test("each of curve, spline and path with a path: numbers and locations", () => {
  // The arch has the height y at these times, first on the upper line, then on the lower one.
  const expected = [1, 0.5].flatMap((y, subpath) =>
    [...arch.timesAtCoordinate({ y })].map((t) => [t, subpath, (arch.eval(t).x * [1, 2][subpath]) / 4]),
  );
  for (const shape of [arch, Spline.fromCurves([arch])]) {
    const found = /** @type {any[]} */ (shape.intersections(lines));
    assert.ok(found.every(({ kind }) => kind === "cross"));
    const places = found.flatMap(({ u }) => Object.values(lines.eval(u)));
    const points = found.flatMap(({ point }) => [point.x, point.y]);
    near(places, points, 1e-10);
    const times = found.flatMap(({ t, u }) => [t, u.subpath, u.t]);
    near(times, expected.flat(), 1e-10);
    const opposite = /** @type {any[]} */ (lines.intersections(shape));
    const others = opposite.flatMap(({ t, u }) => [u, t.subpath, t.t]);
    near(others, expected.flat(), 1e-10);
  }
  const both = lines.intersections(new Path([arch])).map(({ t, u }) => [t.subpath, u.subpath]);
  assert.deepEqual(both, pointsOf("0,0 0,0 1,0 1,0"));
});

test("a shared end point and a joint are reported once", () => {
  const corner = Path.fromSVG("M0 0L2 2L4 0");
  for (const other of [new Curve([2, 2, 2, 5]), new Spline([2, 2, 2, 5], { degree: 1 }), Path.fromSVG("M2 2V5")]) {
    const [found, ...more] = corner.intersections(other);
    assert.deepEqual([found.t, found.point, more], [{ subpath: 0, t: 1 }, { x: 2, y: 2 }, []]);
  }
  const places = (points, path) =>
    untyped(new Curve(points).intersections(path)).map(({ t, u }) => [t, u.subpath, u.t]);
  assert.deepEqual(places([4, 0, 9, 1], corner), [[0, 0, 2]]);
  assert.deepEqual(places([-1, -1, 0, 0], Path.fromSVG("M0 0H4V4H0Z")), [[1, 0, 0]]);
  // A point on two subpaths is one intersection with each.
  assert.deepEqual(places([1, -1, 1, 3], Path.fromSVG("M0 0L1 1 M1 1L2 0")), pointsOf("0.5,0,1 0.5,1,0"));
});

test("overlaps with a path have an end in the same form as their start", () => {
  const [piece, path] = [new Curve([1, 4, 3, 4]), Path.fromSVG("M9 9H8 M0 0H4V4H0Z")];
  const [overlap, ...more] = /** @type {any[]} */ (piece.intersections(path));
  assert.deepEqual([overlap.kind, more, overlap.u.subpath, overlap.uEnd.subpath], ["overlap", [], 1, 1]);
  near([overlap.t, overlap.tEnd, overlap.u.t, overlap.uEnd.t], [0, 1, 2.75, 2.25]);
  const [opposite] = /** @type {any[]} */ (path.intersections(piece));
  assert.deepEqual([opposite.point, opposite.t.subpath, opposite.tEnd.subpath], [{ x: 3, y: 4 }, 1, 1]);
  near([opposite.t.t, opposite.tEnd.t, opposite.u, opposite.uEnd], [2.25, 2.75, 1, 0]);
});

test("long paths: 4,000 segments each cross where they should", () => {
  // Two zigzags along the x-axis whose teeth cross exactly twice per tooth; all pairs of segments would be 16 million.
  const count = 4000;
  const points = (shift) => Array.from({ length: count + 1 }, (_, k) => [k, (k % 2) + shift]);
  const zigzag = (shift) => Path.polygon(points(shift), { closed: false });
  const found = zigzag(0).intersections(zigzag(0.5).transform([1, 0, 0, -1, 0, 1.5]));
  assert.equal(found.length, count);
  for (const [k, { t, u }] of found.entries())
    assert.ok(t.subpath === 0 && Math.floor(t.t) === k && Math.floor(u.t) === k, `${t.t} ${u.t}`);
});

test("empty paths", () => {
  const empty = new Path([]);
  assert.deepEqual([arch.intersections(empty), empty.intersections(arch), empty.intersections(empty)], [[], [], []]);
});

test("coordinates up to the limit have answers, and larger ones are refused", () => {
  const triangle = (x) => Path.fromSVG(`M0,${x}L${x},-${x}L-${x},-${x}Z`);
  assert.deepEqual(triangle(2 ** 500).selfIntersections(), []);
  for (const [act, message] of /** @type {[() => Path, RegExp][]} */ ([
    [() => triangle(Number.MAX_VALUE), /from -2\^500 to 2\^500/],
    [() => triangle(1).transform([1e308, 0, 0, 1e308, 0, 0]), /^image\[0\]: expected a coordinate from -2\^500/],
    [() => triangle(2).transform([1e308, 0, 0, 1e308, 0, 0]), /^image\[0\]: .* got Infinity$/],
  ]))
    assert.throws(act, { name: "RangeError", message });
});
