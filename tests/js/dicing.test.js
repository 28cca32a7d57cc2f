// Splitting and dicing by the REYES algorithm: limits that are kept, and parts that make up the patch.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Patch, Surface } from "casteljau";
import { dice, gridSize, MAX_GRID, screenBounds, splitPatch } from "../../www/figures/lib/dicing.js";
import { pointsOf } from "./reference.js";

const SCALE = 80;
/** Seen along y. @type {import("../../www/figures/lib/dicing.js").Projection} */
const project = (p) => [SCALE * p[0], -SCALE * p[2], p[1]];
const teapot = Surface.teapot();
const patches = teapot.patches.map((_, k) => teapot.patch(k));
/** A square with sides of 1, in the plane of the picture. */
const square = new Patch(pointsOf("0,0,0 1,0,0 0,0,1 1,0,1"), { degreeU: 1, degreeV: 1 });

test("a flat square is diced into as many micropolygons as fit", () => {
  assert.deepEqual(gridSize(square, project, 10), [8, 8]);
  assert.deepEqual(gridSize(square, project, 11), [8, 8]);
  assert.equal(splitPatch(square, project, 10).length, 1);
  assert.equal(dice(square, project, 10).length, 64);
  assert.equal(splitPatch(square, project, 4).length, 4, "20 × 20 is too many for one grid");
  const corners = dice(square, project, 80).map(({ corners }) => corners);
  assert.deepEqual(corners, [pointsOf("0,-0,0 80,-0,0 80,-80,0 0,-80,0")]);
  const [{ normal }] = dice(square, project, 80);
  assert.ok(normal[0] === 0 && normal[2] === 0 && normal[1] < 0, `${normal} is at right angles to the square`);
});

test("no edge of the teapot's micropolygons is longer than the limit, and no grid is too large", () => {
  for (const maxEdge of [24, 12, 6]) {
    const parts = patches.flatMap((patch) => splitPatch(patch, project, maxEdge));
    for (const part of parts) {
      assert.ok(Math.max(...gridSize(part, project, maxEdge)) <= MAX_GRID);
      for (const { corners } of dice(part, project, maxEdge))
        corners.forEach(([x, y], k) => {
          const [x1, y1] = corners[(k + 1) % 4];
          assert.ok(Math.hypot(x1 - x, y1 - y) <= maxEdge * (1 + 1e-12));
        });
    }
  }
});

test("the parts of a patch have its area, and lie in its bounds", () => {
  const patch = patches[4];
  const parts = splitPatch(patch, project, 3);
  assert.ok(parts.length > 8);
  const area = parts.reduce((sum, part) => sum + part.area(), 0);
  assert.ok(Math.abs(area - patch.area()) < 1e-6 * area);
  const whole = screenBounds(patch, project);
  for (const part of parts) {
    const bounds = screenBounds(part, project);
    assert.ok(bounds.left >= whole.left - 1e-9 && bounds.right <= whole.right + 1e-9);
    assert.ok(bounds.top >= whole.top - 1e-9 && bounds.bottom <= whole.bottom + 1e-9);
  }
});

test("a patch that would need endless splitting ends", () => {
  const huge = square.transform([1e9, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
  assert.ok(splitPatch(huge, project, 10).length <= 2 ** 12);
});
