// Meshes without cracks and topology through the package's door: options, shapes, reuse, refusals. Figures as in
// tests/watertight, of the teapot's listing.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Mesh, Patch, Surface } from "casteljau";
import { near, pointsOf } from "./reference.js";

const teapot = Surface.teapot();
/** @type {any} any arguments, also wrong ones */
const tessellate = (/** @type {any} */ options) => teapot.tessellate(options);
const square = new Patch(pointsOf("0,0,0 1,0,0 0,1,0 1,1,1"), { degreeU: 1, degreeV: 1 });

test("counts of even segments", () => {
  const welded = tessellate({ segments: 16, weld: "position" });
  assert.ok(welded instanceof Mesh);
  const lengths = [welded.positions, welded.normals, welded.indices].map((array) => array.length / 3);
  assert.deepEqual(lengths, [8257, 8257, 16256]);
  assert.equal(tessellate({ segments: 16, weld: "none" }).positions.length, 3 * 9248);
  assert.ok(tessellate({ segments: 45, weld: "position" }).indices instanceof Uint16Array);
  assert.ok(tessellate({ segments: 46, weld: "position" }).indices instanceof Uint32Array);
  // Sides that meet with 5 and with 2 segments have the samples of both: more vertices than 32·6·3.
  const mixed = tessellate({ segments: { u: 5, v: 2 }, weld: "none" });
  assert.ok(mixed.positions.length / 3 >= 32 * 6 * 3);
  assert.deepEqual([...new Set(mixed.patchIds)], [...Array(32).keys()]);
});

test("uvs and patch numbers belong to patches of their own", () => {
  for (const weld of ["position", "normal", undefined]) {
    const { uvs, patchIds, patchRanges, indices } = tessellate({ tolerance: 0.02, weld });
    assert.deepEqual([uvs, patchIds, patchRanges.length], [null, null, 32]);
    assert.ok(patchRanges.every(({ vertices }) => vertices === 0));
    assert.equal(patchRanges[31].firstIndex + patchRanges[31].indices, indices.length);
  }
  const mesh = tessellate({ tolerance: 0.02, weld: "none" });
  const count = mesh.positions.length / 3;
  assert.deepEqual([mesh.uvs?.length, mesh.patchIds?.length], [2 * count, count]);
  for (let i = 0; i < count; i += 7) {
    const point = teapot.patch(mesh.patchIds[i]).eval(mesh.uvs[2 * i], mesh.uvs[2 * i + 1]);
    near(mesh.positions.subarray(3 * i, 3 * i + 3), point, 4e-7);
  }
});

test("vertices are shared by normals by default, and weld decides how many there are", () => {
  const meshes = ["none", "normal", "position"].map((weld) => tessellate({ segments: 4, weld }));
  const copy = meshes[2].positions.slice();
  assert.deepEqual(tessellate({ segments: 4 }), meshes[1]);
  assert.deepEqual(meshes[2].positions, copy, "two meshes do not share memory");
  const [none, normal, position] = meshes.map(({ positions }) => positions.length);
  assert.ok(none > normal && normal > position, `${[none, normal, position]}`);
});

test("f64 on demand", () => {
  const precise = tessellate({ segments: 8, weld: "position", precision: "f64" });
  const plain = tessellate({ segments: 8, weld: "position" });
  assert.ok(precise.positions instanceof Float64Array && precise.normals instanceof Float64Array);
  assert.ok(plain.positions instanceof Float32Array && plain.normals instanceof Float32Array);
  assert.deepEqual(new Float32Array(precise.positions), plain.positions);
  assert.deepEqual(precise.indices, plain.indices);
  assert.ok(precise.positions.some((x, i) => x !== plain.positions[i]));
  const least = 2 ** -21;
  assert.throws(() => square.tessellate({ tolerance: least * 0.9 }), RangeError);
  assert.ok(square.tessellate({ tolerance: least * 0.9, precision: "f64" }).indices.length > 0);
});

test("an earlier mesh is filled again", () => {
  const mesh = tessellate({ tolerance: 0.005, weld: "none" });
  const { positions, normals, uvs, patchIds, indices } = mesh;
  assert.equal(tessellate({ tolerance: 0.005, weld: "none", into: mesh }), mesh);
  assert.ok(mesh.positions === positions && mesh.normals === normals && mesh.uvs === uvs);
  assert.ok(mesh.patchIds === patchIds && mesh.indices === indices);
  // Fewer numbers: the same memory.
  tessellate({ tolerance: 0.05, weld: "none", into: mesh });
  assert.deepEqual({ ...mesh }, { ...tessellate({ tolerance: 0.05, weld: "none" }) });
  assert.ok(mesh.positions.buffer === positions.buffer && mesh.indices.buffer === indices.buffer);
});

test("an earlier mesh of any kind will do", () => {
  const kinds = [
    [{ segments: 3 }, { weld: "none" }],
    [{ segments: 9 }, { precision: "f64" }],
    [{ tolerance: 0.1 }, { weld: "position" }],
    [{ segments: 46 }, { weld: "none" }],
    [{ segments: 2 }, { weld: "none", precision: "f64" }],
    [{ tolerance: 0.01 }, undefined],
    [{ segments: 1 }, { weld: "normal" }],
    [{ segments: 5 }, { weld: "none" }],
  ];
  const mesh = teapot.grid({ segments: 4, quads: true });
  for (const [fineness, options] of kinds) {
    const other = tessellate({ ...fineness, ...options, into: mesh });
    assert.equal(other, mesh);
    assert.deepEqual({ ...mesh }, { ...tessellate({ ...fineness, ...options }) });
  }
  const empty = new Surface({ vertices: [], patches: [] }).tessellate({ segments: 2, into: mesh });
  assert.equal(empty.positions.length + empty.indices.length + empty.patchRanges.length, 0);
  const again = teapot.grid({ segments: 4, quads: true, into: mesh });
  assert.deepEqual({ ...again }, { ...teapot.grid({ segments: 4, quads: true }) });
});

test("topology of the teapot", () => {
  const { shared, nonManifold, open, collapsed, components } = teapot.topology();
  assert.deepEqual([shared.length, nonManifold.length, open.length, collapsed.length], [52, 0, 16, 8]);
  const sizes = components.map((patches) => patches.length);
  assert.deepEqual(sizes, [16, 4, 4, 8]);
  const sides = [...shared.flat(), ...open, ...collapsed].map(({ patch, edge }) => `${patch} ${edge}`);
  assert.equal(new Set(sides).size, 128);
  assert.ok(sides.every((side) => /^\d+ [uv][01]$/.test(side)));
  assert.ok(shared.every((pair) => pair.length === 2 && pair[0].reversed === false));
});

test("three patches on one side, one of them backwards", () => {
  const vertices = pointsOf("0,0,0 0,1,0 1,0,0 1,1,0 -1,0,1 -1,1,1 0,0,2 0,1,2");
  const patches = pointsOf("0,1,2,3 0,1,4,5 1,0,7,6");
  const fins = new Surface({ vertices, patches }, { degreeU: 1, degreeV: 1 });
  const { shared, nonManifold, open, components } = fins.topology();
  const sides = [false, false, true].map((reversed, patch) => ({ patch, edge: "v0", reversed }));
  assert.deepEqual(nonManifold, [sides]);
  assert.deepEqual([shared.length, open.length, components], [0, 9, [[0, 1, 2]]]);
});

test("what was joined stays joined, and nothing else becomes so", () => {
  const before = teapot.topology();
  const point = (/** @type {number} */ k) => [...teapot.vertices.subarray(3 * k, 3 * k + 3)];
  for (const [index, ...to] of [...pointsOf("0,9,9,9"), [5, ...point(6)]]) {
    const moved = teapot.movePoint(index, to);
    const back = moved.movePoint(index, point(index));
    for (const each of [moved, back, moved.transform([1, 0, 0, 1, 5, 0])]) assert.deepEqual(each.topology(), before);
    assert.deepEqual(back.tessellate({ segments: 2 }), teapot.tessellate({ segments: 2 }));
  }
});

test("nothing gives an empty mesh", () => {
  const point = new Surface({ vertices: [[1, 2, 3]], patches: [new Array(16).fill(0)] });
  for (const surface of [new Surface({ vertices: [], patches: [] }), point]) {
    for (const weld of ["position", "normal", "none"]) {
      const mesh = surface.tessellate({ tolerance: 0.1, weld: /** @type {any} */ (weld) });
      assert.equal(mesh.positions.length + mesh.normals.length + mesh.indices.length, 0);
      assert.equal(mesh.uvs?.length ?? 0, 0);
    }
  }
  assert.deepEqual(point.topology().components, [[0]]);
  assert.equal(point.topology().collapsed.length, 4);
});
