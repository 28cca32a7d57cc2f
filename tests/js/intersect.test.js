// Where curves meet, through the package.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve } from "casteljau";

const line = new Curve([[0, 0], [4, 0]]);

test("places are sorted and say how the curves meet", () => {
  const wave = new Curve([[0, -1], [0, 3], [4, -3], [4, 1]]);
  const places = wave.intersect(line);
  assert.equal(places.length, 3);
  assert.deepEqual(places[1], { t: 0.5, u: 0.5, point: { x: 2, y: 0 }, kind: "cross" });
  const arch = new Curve([[0, 1], [2, -1], [4, 1]]);
  assert.deepEqual(arch.intersect(line), [{ t: 0.5, u: 0.5, point: { x: 2, y: 0 }, kind: "tangent" }]);
});

test("a shared piece is one overlap with both ends", () => {
  const piece = line.subsegment(0.75, 0.25);
  assert.deepEqual(line.intersect(piece), [
    { t: 0.25, u: 1, point: { x: 1, y: 0 }, kind: "overlap", tEnd: 0.75, uEnd: 0 },
  ]);
});

test("only curves of the plane", () => {
  const space = new Curve([[0, 0, 0], [1, 1, 1]]);
  assert.throws(() => space.intersect(line), { name: "TypeError", message: "intersect: expected a 2D curve, got a 3D one" });
  assert.throws(() => line.intersect(space), TypeError);
  assert.throws(() => line.intersect(/** @type {any} */ ([0, 0])), TypeError);
});
