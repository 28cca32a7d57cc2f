// Surfaces as text. The table of texts, good and bad, is read by tests/surface/text.rs, too.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { Surface } from "casteljau";
import { pointsOf } from "./reference.js";

const table = JSON.parse(readFileSync(new URL("../texts/surfaces.json", import.meta.url), "utf8"));

for (const { name, text, error, vertices, degrees, indices } of table) {
  test(`text: ${name}`, () => {
    if (error) return assert.throws(() => Surface.parse(text), new RangeError(error));
    const surface = Surface.parse(text);
    assert.deepEqual([...surface.vertices], vertices);
    const nets = surface.patches.flatMap((net) => [...net]);
    assert.deepEqual(nets, indices);
    const patches = Array.from({ length: surface.patchCount }, (_, k) => surface.patch(k));
    const found = patches.flatMap(({ degreeU, degreeV }) => [degreeU, degreeV]);
    assert.deepEqual(found, degrees);
  });
}

/** Reads back what was written, bit for bit. */
function thereAndBack(surface) {
  const text = surface.toText();
  const again = Surface.parse(text);
  assert.deepEqual(new BigUint64Array(again.vertices.buffer), new BigUint64Array(surface.vertices.buffer));
  assert.deepEqual(again.patches, surface.patches);
  assert.equal(again.toText(), text);
}

test("text reads back", () => {
  [Surface.teapot(), Surface.teacup(), Surface.teaspoon()].forEach(thereAndBack);
  thereAndBack(Surface.teapot({ height: "original", up: "y" }));
  thereAndBack(new Surface({ vertices: [], patches: [] }));
  const wild = [0, -0, 5e-324, 2 ** -1022, 2 ** 500, 1e21, 1e-6, 1e-7, 0.1, 1e15, 1 / 3, -123456.789e-300];
  thereAndBack(new Surface({ vertices: Float64Array.from(wild), patches: [[3, 2, 1, 0]] }, { degreeU: 1, degreeV: 1 }));
});

test("the text is the documented one", () => {
  const square = { vertices: pointsOf("0,0,0 1,0,0 0,1,0 1,1,0.5"), patches: [[0, 1, 2, 3]] };
  const surface = new Surface(square, { degreeU: 1, degreeV: 1 });
  assert.equal(surface.toText(), "surface\nvertices 4\n0 0 0\n1 0 0\n0 1 0\n1 1 0.5\npatches 1\n1 1\n0 1\n2 3\n");
});

test("a moved point of a .bpt file moves all patches that share it", () => {
  const net = (x) => `1 1\n${x} 0 0\n${x + 1} 0 0\n${x} 1 0\n${x + 1} 1 0\n`;
  const moved = Surface.parse(`2\n${net(0)}${net(1)}`).movePoint(1, [1, 0, 5]);
  assert.deepEqual([moved.patch(0).eval(1, 0).z, moved.patch(1).eval(0, 0).z], [5, 5]);
});

test("large texts: time once, or a quick refusal", () => {
  const patch = `3 3\n${"0 0 0\n".repeat(14)}1.5 -2.25 1e-3\n4 5 6\n`;
  const surface = Surface.parse(`50000\n${patch.repeat(50_000)}`);
  assert.deepEqual([surface.patchCount, surface.vertices.length], [50_000, 9]);
  for (const bad of ["1 ", "\n", "9", "#"]) assert.throws(() => Surface.parse(bad.repeat(1 << 23)), RangeError);
  assert.throws(() => Surface.parse(`4294967295\n${patch}`), RangeError);
  assert.equal(Surface.teapot().patchCount, 32);
});
