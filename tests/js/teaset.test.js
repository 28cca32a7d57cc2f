// Teacup and teaspoon through the package's door.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { Surface } from "casteljau";
import { pointsOf } from "./reference.js";

/** The listing's control points of each patch with v reversed. */
function listed(name, turn) {
  const data = JSON.parse(readFileSync(new URL(`../data/${name}.json`, import.meta.url), "utf8"));
  const rows = (patch) => [12, 8, 4, 0].flatMap((from) => patch.slice(from, from + 4));
  return data.patches.map((patch) => rows(patch).flatMap((index) => turn(data.vertices[index])));
}

const all = (surface) => Array.from({ length: surface.patchCount }, (_, k) => [...surface.patch(k).controlPoints()]);

/** @type {[string, () => Surface, (point: number[]) => number[]][]} */
const CASES = [
  ["teacup", () => Surface.teacup(), ([x, y, z]) => [x, 0 - z, y]],
  ["teacup", () => Surface.teacup({ up: "y" }), (p) => p],
  ["teaspoon", () => Surface.teaspoon({ up: "z" }), (p) => p],
  ["teaspoon", () => Surface.teaspoon({ up: "y" }), ([x, y, z]) => [x, z, 0 - y]],
];
for (const [name, make, turn] of CASES) {
  test(`${make} has the listing's figures`, () => assert.deepEqual(all(make()), listed(name, turn)));
}

test("coincident points are one vertex", () => {
  const counts = [Surface.teacup(), Surface.teaspoon()].map((s) => [s.patchCount, s.vertices.length / 3]);
  assert.deepEqual(counts, pointsOf("26,251 16,148"));
});
