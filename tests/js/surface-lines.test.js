// The lines that <bezier-surface> draws for de Casteljau's algorithm, step by step.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Patch } from "casteljau";
import { casteljau } from "#js/elements/surface/lines.js";

const net = Array.from({ length: 16 }, (_, k) => /** @type {const} */ ([k % 4, Math.floor(k / 4), (k * 7) % 5]));
const patch = new Patch(net);
const [U, V] = [0.3, 0.6];
const step = (n) => casteljau(patch, U, V, n);

test("step 1 has the first row and its point, step 2 all rows", () => {
  const [first, all] = [step(1), step(2)];
  assert.equal(all.rowCurves.length, 4 * first.rowCurves.length);
  assert.equal(all.rowLines.length, 4 * first.rowLines.length);
  assert.deepEqual([first.rowPoints.length, all.rowPoints.length], [3, 12]);
  const { x, y, z = 0 } = patch.eval(U, 0);
  assert.deepEqual([...first.rowPoints], [...Float32Array.of(x, y, z)], "row 0 is the side v = 0");
  assert.deepEqual([...first.columnCurve, ...all.columnCurve, ...all.point], []);
});

test("step 3 adds the curve across the rows, step 4 its point", () => {
  const [third, fourth] = [step(3), step(4)];
  assert.deepEqual([...third.rowPoints], [...step(2).rowPoints]);
  assert.ok(third.columnCurve.length > 0);
  assert.equal(third.point.length, 0);
  const { x, y, z = 0 } = patch.eval(U, V);
  assert.deepEqual([...fourth.point], [...Float32Array.of(x, y, z)]);
  assert.ok(fourth.columnLines.length > third.columnLines.length);
});
