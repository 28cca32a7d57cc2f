// Tests of the files of a mesh.
import assert from "node:assert/strict";
import { test } from "node:test";
import validator from "gltf-validator";
import * as THREE from "three";

/** No error and no warning; what the file holds. */
export async function valid(glb) {
  const { issues, info } = await validator.validateBytes(glb);
  const serious = issues.messages.filter(({ severity }) => severity < 2);
  assert.deepEqual(serious, []);
  return info;
}

/** Defines tests that the files of a mesh are valid and contain the mesh. @param {string} name @param {import("casteljau").Mesh} mesh */
export function testFiles(name, mesh) {
  test(`glb is valid: ${name}`, async () => {
    const info = await valid(mesh.toGLB());
    assert.equal(info.totalTriangleCount, mesh.indices.length / 3);
    if (mesh.indices.length) assert.equal(info.totalVertexCount, mesh.positions.length / 3);
  });

  test(`stl reads back: ${name}`, () => {
    const bytes = mesh.toSTL();
    const view = new DataView(bytes.buffer);
    const count = view.getUint32(80, true);
    assert.equal(count, mesh.indices.length / 3);
    assert.equal(bytes.length, 84 + 50 * count);
    assert.notEqual(new TextDecoder().decode(bytes.subarray(0, 5)), "solid");
    for (let k = 0; k < count; k += Math.ceil(count / 500)) {
      const [normal, a, b, c] = [0, 1, 2, 3].map((v) =>
        [0, 1, 2].map((axis) => view.getFloat32(84 + 50 * k + 12 * v + 4 * axis, true)),
      );
      [a, b, c].forEach((corner, i) => {
        const at = 3 * mesh.indices[3 * k + i];
        assert.deepEqual(corner, [...mesh.positions.subarray(at, at + 3)].map(Math.fround));
      });
      const [along, across] = [b, c].map((p) => new THREE.Vector3(...p).sub(new THREE.Vector3(...a)));
      const cross = along.cross(across);
      const expected = cross.length() > 0 ? cross.normalize() : new THREE.Vector3();
      assert.ok(expected.distanceTo(new THREE.Vector3(...normal)) < 1e-6);
    }
  });

  test(`obj reads back: ${name}`, () => {
    const text = mesh.toOBJ();
    const of = (word) => [...text.matchAll(new RegExp(`^${word} (.*)$`, "gm"))].flatMap(([, rest]) => rest.split(" "));
    const numbers = (word, Type) => Type.from(of(word).map(Number));
    const { constructor: Real } = mesh.positions;
    assert.deepEqual(numbers("v", Real), mesh.positions);
    assert.deepEqual(numbers("vn", Real), mesh.normals);
    assert.deepEqual(numbers("vt", Float32Array), mesh.uvs ?? new Float32Array());
    const faces = mesh.quads ?? mesh.indices;
    const corners = of("f").map((corner) => corner.split("/"));
    const vertices = corners.map(([vertex]) => Number(vertex) - 1);
    assert.deepEqual(vertices, [...faces]);
    assert.ok(corners.every(([v, vt, vn]) => vn === v && vt === (mesh.uvs ? v : "")));
  });
}
