// Meshes as text and as bytes of files; src/io/mesh_export.rs and glb.rs make the same.
import * as check from "./check.js";
import { written } from "./written.js";

/**
 * @import { Mesh } from "./mesh.js"
 */

/** The most bytes of a file: 1 GiB. */
const MAX_BYTES = 2 ** 30;

const STL_HEADER_BYTES = 80;
/** A normal and three corners of three f32, and two bytes that mean nothing. */
const STL_TRIANGLE_BYTES = 50;

/**
 * @internal
 * @param {Mesh} mesh
 * @param {{ quads?: boolean }} [options]
 * @returns {string}
 */
export function meshToOBJ(mesh, options) {
  const { quads = mesh.quads !== undefined } = check.options(options);
  if (quads && !mesh.quads) throw new RangeError("quads: expected a mesh with quads, got one without");
  const [faces, corners] = quads && mesh.quads ? [mesh.quads, 4] : [mesh.indices, 3];
  checkMesh(mesh, faces, corners);
  const { positions, normals, uvs } = mesh;
  const lines = [`# ${positions.length / 3} vertices, ${faces.length / corners} faces`];
  addLines(lines, "v", positions, 3);
  if (uvs) addLines(lines, "vt", uvs, 2);
  addLines(lines, "vn", normals, 3);
  for (let i = 0; i < faces.length; i += corners) {
    let line = "f";
    for (let k = i; k < i + corners; k++) {
      const number = faces[k] + 1;
      line += uvs ? ` ${number}/${number}/${number}` : ` ${number}//${number}`;
    }
    lines.push(line);
  }
  return `${lines.join("\n")}\n`;
}

/**
 * @param {string[]} lines
 * @param {string} word
 * @param {Float32Array | Float64Array} numbers
 * @param {number} count in a line
 */
function addLines(lines, word, numbers, count) {
  for (let i = 0; i < numbers.length; i += count) {
    let line = word;
    for (let k = i; k < i + count; k++) line += ` ${written(numbers, k)}`;
    lines.push(line);
  }
}

/**
 * @internal
 * @param {Mesh} mesh
 * @returns {Uint8Array<ArrayBuffer>}
 */
export function meshToSTL(mesh) {
  const { indices } = mesh;
  checkMesh(mesh, indices, 3);
  const positions = inFloats(mesh.positions, "positions");
  const bytes = newFile(STL_HEADER_BYTES + 4 + (indices.length / 3) * STL_TRIANGLE_BYTES);
  const view = new DataView(bytes.buffer);
  // Not "solid", with which the text form begins.
  new TextEncoder().encodeInto("binary STL", bytes);
  view.setUint32(STL_HEADER_BYTES, indices.length / 3, true);
  let at = STL_HEADER_BYTES + 4;
  for (let i = 0; i < indices.length; i += 3, at += STL_TRIANGLE_BYTES) {
    const corners = [3 * indices[i], 3 * indices[i + 1], 3 * indices[i + 2]];
    faceNormal(positions, corners).forEach((x, axis) => view.setFloat32(at + 4 * axis, x, true));
    for (let k = 0; k < 9; k++) view.setFloat32(at + 12 + 4 * k, positions[corners[Math.floor(k / 3)] + (k % 3)], true);
  }
  return bytes;
}

/**
 * The unit normal of a triangle by the right-hand rule, zero where it is degenerate.
 *
 * @param {Float32Array} p
 * @param {number[]} corners where they start in `p`
 * @returns {number[]}
 */
function faceNormal(p, [a, b, c]) {
  const along = [0, 1, 2].map((axis) => p[b + axis] - p[a + axis]);
  const across = [0, 1, 2].map((axis) => p[c + axis] - p[a + axis]);
  const cross = [
    along[1] * across[2] - along[2] * across[1],
    along[2] * across[0] - along[0] * across[2],
    along[0] * across[1] - along[1] * across[0],
  ];
  const length = Math.sqrt(cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2]);
  return cross.map((x) => (length > 0 ? x / length : 0));
}

/**
 * Zeros for a file, unless it is too long.
 *
 * @internal
 * @param {number} length
 * @returns {Uint8Array<ArrayBuffer>}
 */
export function newFile(length) {
  if (length > MAX_BYTES) throw new RangeError(`bytes: expected at most ${MAX_BYTES}, this needs ${length}`);
  return new Uint8Array(length);
}

/**
 * Numbers of 32 bits; the very array where it holds such.
 *
 * @internal
 * @param {Float32Array | Float64Array} numbers
 * @param {string} name
 * @returns {Float32Array}
 */
export function inFloats(numbers, name) {
  if (numbers instanceof Float32Array) return numbers;
  const floats = Float32Array.from(numbers);
  const bad = floats.findIndex((x) => !Number.isFinite(x));
  if (bad < 0) return floats;
  throw new RangeError(`${name}: expected numbers that 32 bits can hold, got ${numbers[bad]}`);
}

/**
 * Meshes are open to their users: refuses one whose arrays do not belong together.
 *
 * @internal
 * @param {Mesh} mesh
 * @param {Uint16Array | Uint32Array} faces
 * @param {number} corners of each
 */
export function checkMesh({ positions, normals, uvs }, faces, corners) {
  const vertices = positions.length / 3;
  checkCount("positions", "3 numbers for each vertex", positions, 3 * Math.floor(vertices));
  checkCount("normals", "3 numbers for each vertex", normals, positions.length);
  if (uvs) checkCount("uvs", "2 numbers for each vertex", uvs, 2 * vertices);
  checkCount("indices", `${corners} vertex numbers for each face`, faces, corners * Math.floor(faces.length / corners));
  for (const [name, list] of Object.entries({ positions, normals, uvs: uvs ?? [] })) {
    const bad = list.findIndex((/** @type {number} */ x) => !Number.isFinite(x));
    if (bad >= 0) throw new RangeError(`${name}[${bad}]: expected a finite number, got ${list[bad]}`);
  }
  const past = faces.findIndex((vertex) => vertex >= vertices);
  if (past >= 0)
    throw new RangeError(`indices: expected an index from 0 to ${Math.max(0, vertices - 1)}, got ${faces[past]}`);
}

/**
 * @param {string} name
 * @param {string} expected
 * @param {ArrayLike<number>} list
 * @param {number} length
 */
function checkCount(name, expected, list, length) {
  if (list.length !== length) throw new RangeError(`${name}: expected ${expected}, got ${list.length}`);
}
