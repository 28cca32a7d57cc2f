// Meshes as files and as geometry of three.js. The table was made by another program from the definitions of the
// formats; tests/surface/export.rs reads it, too.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import * as THREE from "three";
import { Mesh, Surface } from "casteljau";
import { testFiles, valid } from "./mesh-files.js";
import { refused, untyped } from "./reference.js";

const table = JSON.parse(readFileSync(new URL("../texts/meshes.json", import.meta.url), "utf8"));
const hex = (bytes) => Buffer.from(bytes).toString("hex");

/** @param {Record<string, any>} data arrays of numbers */
function meshOf({ precision = "f32", positions, normals, uvs = null, indices, quads }) {
  const Real = precision === "f64" ? Float64Array : Float32Array;
  return new Mesh({
    positions: Real.from(positions),
    normals: Real.from(normals),
    uvs: uvs && Float32Array.from(uvs),
    patchIds: null,
    indices: Uint16Array.from(indices),
    quads: quads ? Uint16Array.from(quads) : undefined,
    patchRanges: [],
  });
}

for (const entry of table) {
  test(`files: ${entry.name}`, async () => {
    const mesh = meshOf(entry);
    assert.equal(mesh.toOBJ(), entry.obj);
    assert.equal(hex(mesh.toSTL()), entry.stl);
    assert.equal(hex(mesh.toGLB()), entry.glb);
    await valid(mesh.toGLB());
  });
}

const square = { positions: [0, 0, 0, 1, 0, 0, 0, 1, 0], normals: [0, 0, 1, 0, 0, 1, 0, 0, 1], indices: [0, 1, 2] };
const empty = new Surface({ vertices: [], patches: [] });
const point = new Surface({ vertices: [[1, 2, 3]], patches: [new Array(16).fill(0)] });

/** Every way to a mesh. @type {[string, Mesh][]} */
const meshes = [
  ["a grid", Surface.teapot().grid({ segments: 8, quads: true })],
  ["32-bit indices", Surface.teapot().grid({ segments: 46 })],
  ["exactly 65,536 vertices", Surface.teapot().patch(0).grid({ segments: 255 })],
  ["tessellated", Surface.teapot().tessellate({ tolerance: 0.01 })],
  ["by position, 64 bits", Surface.teaspoon().tessellate({ tolerance: 0.001, weld: "position", precision: "f64" })],
  ["with parameters", Surface.teacup().tessellate({ segments: 5, weld: "none" })],
  ["no patches", empty.grid({ segments: 2 })],
  ["a patch that is a point", point.grid({ segments: 2 })],
  ["tubes", Surface.teaspoon().wireframe({ lines: 3, radius: 0.004 })],
  ["ribbons", Surface.teacup().wireframe({ lines: 3, width: 0.02 })],
];

for (const [name, mesh] of meshes) testFiles(name, mesh);

test("faces of an obj", () => {
  const mesh = Surface.teapot().grid({ segments: 2, quads: true });
  const faceLines = (options) => mesh.toOBJ(options).match(/^f.*$/gm) ?? [];
  const sizes = (options) => new Set(faceLines(options).map((line) => line.split(" ").length - 1));
  const faces = [sizes(), sizes({ quads: true }), sizes({ quads: false })];
  assert.deepEqual(faces, [new Set([4]), new Set([4]), new Set([3])]);
  const triangles = Surface.teapot().grid({ segments: 2 });
  refused(() => triangles.toOBJ({ quads: true }), RangeError, /^quads: expected a mesh with quads, got one without$/);
});

/** @param {Mesh} mesh @returns {any} three.js has no types of its own */
const threeGeometry = (mesh) => mesh.toThree(THREE);

test("three.js gets the mesh's own arrays", () => {
  const mesh = Surface.teapot({ up: "y" }).grid({ segments: 4 });
  const geometry = threeGeometry(mesh);
  assert.ok(geometry instanceof THREE.BufferGeometry);
  const { position, normal, uv } = geometry.attributes;
  assert.ok(position.array === mesh.positions && normal.array === mesh.normals);
  assert.ok(uv.array === mesh.uvs && geometry.index?.array === mesh.indices);
  geometry.computeBoundingBox();
  assert.ok(Math.abs((geometry.boundingBox?.max.y ?? 0) - 3.15) < 1e-6);

  const precise = threeGeometry(Surface.teapot().tessellate({ segments: 4, precision: "f64" }));
  assert.ok(precise.attributes.position.array instanceof Float32Array);
  assert.equal(precise.attributes.uv, undefined);
  assert.equal(threeGeometry(empty.grid({ segments: 1 })).index?.count, 0);
});

test("three.js is what the caller says", () => {
  const mesh = meshOf(square);
  const made = [];
  class BufferAttribute {
    constructor(array, size) {
      made.push([array, size]);
    }
  }
  class BufferGeometry {
    setAttribute() {}
    setIndex() {}
  }
  assert.ok(mesh.toThree({ BufferGeometry, BufferAttribute }) instanceof BufferGeometry);
  const expected = [mesh.positions, mesh.normals, mesh.indices].map((array, k) => [array, [3, 3, 1][k]]);
  assert.deepEqual(made, expected);
  for (const bad of [undefined, null, {}, "three", { BufferGeometry }]) {
    refused(() => mesh.toThree(untyped(bad)), TypeError, /^THREE: expected the namespace of three\.js, got /);
  }
});

test("meshes that do not belong together are refused", () => {
  const all = [(m) => m.toOBJ(), (m) => m.toSTL(), (m) => m.toGLB()];
  const wrong = (change, message) =>
    all.forEach((act) => refused(() => act(meshOf({ ...square, ...change })), RangeError, message));
  wrong({ indices: [0, 1, 3] }, /^indices: expected an index from 0 to 2, got 3$/);
  wrong({ indices: [0, 1] }, /^indices: expected 3 vertex numbers for each face, got 2$/);
  wrong({ positions: square.positions.slice(1) }, /^positions: expected 3 numbers for each vertex, got 8$/);
  wrong({ normals: [0, 0, 1] }, /^normals: expected 3 numbers for each vertex, got 3$/);
  wrong({ uvs: [0] }, /^uvs: expected 2 numbers for each vertex, got 1$/);
  wrong({ positions: [NaN, ...square.positions.slice(1)] }, /^positions\[0\]: expected a finite number, got NaN$/);
  const wide = meshOf({ ...square, precision: "f64", positions: [1e39, ...square.positions.slice(1)] });
  assert.match(wide.toOBJ(), /^v 1e\+39 0 0$/m);
  for (const act of all.slice(1))
    refused(() => act(wide), RangeError, /^positions: expected numbers that 32 bits can hold, got 1e\+39$/);
});
