// Intersections of curves and splines.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Spline } from "casteljau";

const line = new Curve([
  [0, 0],
  [4, 0],
]);

test("intersections are sorted and have a kind", () => {
  const wave = new Curve([
    [0, -1],
    [0, 3],
    [4, -3],
    [4, 1],
  ]);
  const places = wave.intersections(line);
  assert.equal(places.length, 3);
  assert.deepEqual(places[1], { t: 0.5, u: 0.5, point: { x: 2, y: 0 }, kind: "cross" });
  const arch = new Curve([
    [0, 1],
    [2, -1],
    [4, 1],
  ]);
  assert.deepEqual(arch.intersections(line), [{ t: 0.5, u: 0.5, point: { x: 2, y: 0 }, kind: "tangent" }]);
});

test("a shared piece is one overlap with both ends", () => {
  const piece = line.subsegment(0.75, 0.25);
  assert.deepEqual(line.intersections(piece), [
    { t: 0.25, u: 1, point: { x: 1, y: 0 }, kind: "overlap", tEnd: 0.75, uEnd: 0 },
  ]);
});

test("splines: t and u count segments, a joint is one intersection, a shared piece across joints is one", () => {
  const square = new Spline(
    [
      [0, 0],
      [2, 0],
      [2, 2],
      [0, 2],
    ],
    { degree: 1, closed: true },
  );
  const diagonal = new Curve([
    [-1, -1],
    [3, 3],
  ]);
  assert.deepEqual(square.intersections(diagonal), [
    { t: 0, u: 0.25, point: { x: 0, y: 0 }, kind: "cross" },
    { t: 2, u: 0.75, point: { x: 2, y: 2 }, kind: "cross" },
  ]);
  assert.deepEqual(
    diagonal.intersections(square).map(({ t, u }) => [t, u]),
    [
      [0.25, 0],
      [0.75, 2],
    ],
  );
  const long = new Spline(
    [
      [-1, 0],
      [1, 0],
      [1.5, 0],
      [3, 0],
    ],
    { degree: 1 },
  );
  assert.deepEqual(square.intersections(long), [
    { t: 0, u: 0.5, point: { x: 0, y: 0 }, kind: "overlap", tEnd: 1, uEnd: 2 + 1 / 3 },
  ]);
});

test("self-intersections of curves and splines", () => {
  const loop = new Curve([
    [0, 0],
    [3, 2],
    [-2, 2],
    [1, 0],
  ]);
  const [place] = loop.selfIntersections();
  assert.ok(place.t < place.u && Math.abs(place.point.x - 0.5) < 1e-15);
  const bow = new Spline(
    [
      [0, 0],
      [2, 2],
      [2, 0],
      [0, 2],
    ],
    { degree: 1, closed: true },
  );
  assert.deepEqual(bow.selfIntersections(), [{ t: 0.5, u: 2.5, point: { x: 1, y: 1 } }]);
});

test("only curves of the plane", () => {
  const space = new Curve([
    [0, 0, 0],
    [1, 1, 1],
  ]);
  assert.throws(() => space.intersections(line), {
    name: "TypeError",
    message: "intersections: expected a 2D curve, got a 3D one",
  });
  assert.throws(() => line.intersections(space), TypeError);
  const message = "other: expected a Curve, a Spline or a Path, got an array of 2";
  assert.throws(() => line.intersections(/** @type {any} */ ([0, 0])), { name: "TypeError", message });
  assert.throws(() => line.intersections(/** @type {any} */ (null)), TypeError);
  assert.throws(() => space.selfIntersections(), TypeError);
  const chain = new Spline(
    [
      [0, 0, 0],
      [1, 1, 1],
    ],
    { degree: 1 },
  );
  assert.throws(() => chain.intersections(line), {
    name: "TypeError",
    message: "intersections: expected a 2D spline, got a 3D one",
  });
  assert.throws(() => line.intersections(chain), TypeError);
  assert.throws(() => chain.selfIntersections(), TypeError);
});
