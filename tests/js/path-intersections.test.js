// Intersections between any two of curve, spline and path: the same points, and each position in its own form.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Path, Spline } from "casteljau";
import { near, refused } from "./reference.js";

/** Two lines, the second one of two segments; both cross the cubic below. */
const lines = Path.fromSVG("M0 1H4 M0 0.5H2H4");
const arch = new Curve([0, 0, 0, 4, 4, 4, 4, 0]);
const archSpline = new Spline([0, 0, 0, 4, 4, 4, 4, 0]);

test("each of curve, spline and path with a path: numbers and locations", () => {
  const expected = [1, 0.5].flatMap((y, subpath) =>
    [...arch.timesAtCoordinate({ y })].map((t) => ({
      t,
      point: arch.eval(t),
      subpath,
      u: (arch.eval(t).x * [1, 2][subpath]) / 4,
    })),
  );
  expected.sort((a, b) => a.subpath - b.subpath || a.t - b.t);
  for (const shape of [arch, archSpline]) {
    const found = shape.intersections(lines);
    assert.equal(found.length, 4);
    found.forEach(({ t, u, point, kind }, k) => {
      assert.equal(kind, "cross");
      assert.equal(u.subpath, expected[k].subpath);
      near([t, u.t, point.x, point.y], [expected[k].t, expected[k].u, expected[k].point.x, expected[k].point.y], 1e-10);
      near(lines.eval(u), point, 1e-10);
    });
    const opposite = lines.intersections(shape);
    assert.deepEqual(
      opposite.map(({ t }) => t.subpath),
      [0, 0, 1, 1],
    );
    near(
      opposite.map(({ u }) => u),
      expected.map(({ t }) => t),
      1e-10,
    );
    near(
      opposite.map(({ t }) => t.t),
      expected.map(({ u }) => u),
      1e-10,
    );
  }
  const both = lines.intersections(new Path([arch]));
  assert.deepEqual(
    both.map(({ t, u }) => [t.subpath, u.subpath]),
    [
      [0, 0],
      [0, 0],
      [1, 0],
      [1, 0],
    ],
  );
});

test("a shared end point and a joint are reported once", () => {
  const corner = Path.fromSVG("M0 0L2 2L4 0");
  for (const other of [new Curve([2, 2, 2, 5]), new Spline([2, 2, 2, 5], { degree: 1 }), Path.fromSVG("M2 2V5")]) {
    const [found, ...more] = corner.intersections(other);
    assert.deepEqual([found.t, found.point, more], [{ subpath: 0, t: 1 }, { x: 2, y: 2 }, []]);
  }
  const [found, ...more] = new Curve([4, 0, 9, 1]).intersections(corner);
  assert.deepEqual([found.t, found.u, more], [0, { subpath: 0, t: 2 }, []]);
  const square = Path.fromSVG("M0 0H4V4H0Z");
  assert.deepEqual(
    new Curve([-1, -1, 0, 0]).intersections(square).map(({ t, u }) => [t, u]),
    [[1, { subpath: 0, t: 0 }]],
  );
  // A point on two subpaths is one intersection with each.
  const touching = Path.fromSVG("M0 0L1 1 M1 1L2 0");
  assert.deepEqual(
    new Curve([1, -1, 1, 3]).intersections(touching).map(({ u }) => u),
    [
      { subpath: 0, t: 1 },
      { subpath: 1, t: 0 },
    ],
  );
});

test("overlaps have an end in the same form as their start", () => {
  const [overlap, ...more] = new Curve([1, 4, 3, 4]).intersections(Path.fromSVG("M9 9H8 M0 0H4V4H0Z"));
  assert.equal(more.length, 0);
  assert.equal(overlap.kind, "overlap");
  near([overlap.t, overlap.tEnd], [0, 1]);
  assert.deepEqual([overlap.u.subpath, overlap.uEnd.subpath], [1, 1]);
  near([overlap.u.t, overlap.uEnd.t], [2.75, 2.25]);
  const [opposite] = /** @type {any[]} */ (Path.fromSVG("M9 9H8 M0 0H4V4H0Z").intersections(new Curve([1, 4, 3, 4])));
  assert.deepEqual([opposite.t.subpath, opposite.tEnd.subpath], [1, 1]);
  near([opposite.u, opposite.uEnd], [1, 0]);
});

test("long paths: 4,000 segments each cross where they should", () => {
  // Two zigzags along the x-axis whose teeth cross exactly twice per tooth; all pairs of segments would be 16 million.
  const count = 4000;
  const zigzag = (shift) =>
    Path.polygon(
      Array.from({ length: count + 1 }, (_, k) => [k, (k % 2) + shift]),
      { closed: false },
    );
  const found = zigzag(0).intersections(zigzag(0.5).transform([1, 0, 0, -1, 0, 1.5]));
  assert.equal(found.length, count);
  for (const [k, { t, u }] of found.entries()) {
    assert.ok(t.subpath === 0 && Math.floor(t.t) === k && Math.floor(u.t) === k, `${t.t} ${u.t}`);
  }
});

test("empty paths, and what is not a shape", () => {
  const empty = new Path([]);
  assert.deepEqual([arch.intersections(empty), empty.intersections(arch), empty.intersections(empty)], [[], [], []]);
  for (const shape of [arch, archSpline])
    for (const bad of /** @type {any[]} */ ([undefined, null, "M0 0H4", {}, [[0, 0]]]))
      refused(() => shape.intersections(bad), TypeError, /^other: expected a Curve, a Spline or a Path, got/);
  const space = new Curve([
    [0, 0, 0],
    [1, 1, 1],
  ]);
  refused(() => space.intersections(lines), TypeError, /^intersections: expected a 2D curve, got a 3D one/);
  refused(() => lines.intersections(space), TypeError, /^other: expected a 2D one, got a 3D one/);
});

test("coordinates up to the limit have answers, and larger ones are refused", () => {
  const triangle = (x) => Path.fromSVG(`M0,${x}L${x},-${x}L-${x},-${x}Z`);
  assert.throws(() => triangle(Number.MAX_VALUE), { name: "RangeError", message: /from -2\^500 to 2\^500/ });
  assert.deepEqual(triangle(2 ** 500).selfIntersections(), []);
  const scaled = (x) => triangle(1).transform([x, 0, 0, x, 0, 0]);
  assert.throws(() => scaled(1e308), {
    name: "RangeError",
    message: /^image\[0\]: expected a coordinate from -2\^500/,
  });
  assert.throws(() => triangle(2).transform([1e308, 0, 0, 1e308, 0, 0]), { message: /^image\[0\]: .* got Infinity$/ });
});
