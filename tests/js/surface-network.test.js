// Surfaces from patches and from JSON.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Patch, Surface } from "casteljau";

/** A flat bicubic patch over the square with the corner (x, 0). */
const squareAt = (x) => new Patch(Array.from({ length: 16 }, (_, k) => [x + (k % 4) / 3, (k >> 2) / 3, 0]));

test("fromPatches: neighbours share their control points", () => {
  const halves = new Patch(Array.from({ length: 16 }, (_, k) => [k % 4, k >> 2, (k * k) % 7])).splitU(0.3);
  const surface = Surface.fromPatches(halves);
  assert.equal(surface.vertices.length / 3, 32 - 4);
  assert.equal(surface.topology().shared.length, 1);
  halves.forEach((half, k) => assert.deepEqual(surface.patch(k).controlPoints(), half.controlPoints()));
});

test("fromPatches: patches that do not touch, of different degrees, and none", () => {
  const surface = Surface.fromPatches([squareAt(0), squareAt(5).elevate()]);
  assert.equal(surface.vertices.length / 3, 16 + 25);
  assert.equal(surface.topology().components.length, 2);
  assert.equal(surface.patch(1).degreeU, 4);
  assert.equal(Surface.fromPatches([]).patchCount, 0);
});

test("fromPatches: the teapot from its patches", () => {
  const teapot = Surface.teapot();
  const copy = Surface.fromPatches(Array.from({ length: 32 }, (_, k) => teapot.patch(k)));
  assert.deepEqual(copy.topology(), teapot.topology());
  for (const detail of [{ segments: 3 }, { tolerance: 0.1 }]) {
    assert.deepEqual(copy.tessellate(detail).positions, teapot.tessellate(detail).positions);
  }
});

test("toJSON and fromJSON keep every bit", () => {
  const mixed = Surface.fromPatches([squareAt(0), squareAt(1).elevate()]);
  for (const surface of [Surface.teacup(), mixed, Surface.fromPatches([])]) {
    const copy = Surface.fromJSON(JSON.parse(JSON.stringify(surface)));
    assert.deepEqual(copy.vertices, surface.vertices);
    assert.deepEqual(copy.patches, surface.patches);
    assert.deepEqual(copy.toJSON(), surface.toJSON());
    assert.equal(copy.toText(), surface.toText());
  }
});

test("fromJSON: bicubic without degrees", () => {
  const json = Surface.fromPatches([squareAt(0)]).toJSON();
  assert.deepEqual(json.degrees, [[3, 3]]);
  assert.deepEqual(Surface.fromJSON({ ...json, degrees: undefined }).toJSON(), json);
});

test("one patch: its meshes have uvs by default", () => {
  for (const detail of [{ segments: 2 }, { tolerance: 0.1 }]) {
    const { uvs, patchIds, positions } = squareAt(0).tessellate(detail);
    assert.equal(uvs?.length, (2 * positions.length) / 3);
    assert.equal(patchIds?.length, positions.length / 3);
    // On this patch x = u and y = v.
    uvs?.forEach((value, k) => assert.ok(Math.abs(value - positions[3 * (k >> 1) + (k % 2)]) < 1e-6));
  }
  assert.equal(squareAt(0).tessellate({ segments: 2, weld: "normal" }).uvs, null);
  assert.equal(Surface.fromPatches([squareAt(0)]).tessellate({ segments: 2 }).uvs, null);
});
