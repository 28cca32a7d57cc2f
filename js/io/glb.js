// Meshes as binary glTF 2.0; src/io/glb.rs makes the same bytes. Source: Khronos, glTF 2.0 specification, §3 and
// §4.
import { checkMesh, inFloats, newFile } from "./mesh-file.js";

/**
 * @import { Mesh } from "../geometry/mesh.js"
 */

const MAGIC = 0x46546c67; // "glTF"
const VERSION = 2;
const JSON_CHUNK = 0x4e4f534a; // "JSON"
const BINARY_CHUNK = 0x004e4942; // "BIN"
const HEADER_BYTES = 12;
const CHUNK_HEADER_BYTES = 8;

const FLOAT = 5126;
const UNSIGNED_SHORT = 5123;
const UNSIGNED_INT = 5125;
const ARRAY_BUFFER = 34962;
const ELEMENT_ARRAY_BUFFER = 34963;

/** The greatest vertex number of 16 bits; glTF keeps 65,535 for itself. */
const GREATEST_SHORT = 0xfffe;

/** @param {number} length */
const padded = (length) => Math.ceil(length / 4) * 4;

/**
 * A piece of the binary chunk and how it is described.
 *
 * @typedef {{ array: Float32Array | Uint16Array | Uint32Array, accessor: Record<string, unknown>, target: number }} Piece
 */

/**
 * @internal
 * @param {Mesh} mesh
 * @returns {Uint8Array<ArrayBuffer>}
 */
export function meshToGLB(mesh) {
  checkMesh(mesh, mesh.indices, 3);
  const pieces = mesh.indices.length ? piecesOf(mesh) : [];
  const length = pieces.reduce((sum, { array }) => sum + padded(array.byteLength), 0);
  const json = new TextEncoder().encode(JSON.stringify(description(pieces, length)));
  const binary = length ? CHUNK_HEADER_BYTES + length : 0;
  const bytes = newFile(HEADER_BYTES + CHUNK_HEADER_BYTES + padded(json.length) + binary);
  const view = new DataView(bytes.buffer);
  const words = (/** @type {number} */ at, /** @type {number[]} */ ...list) =>
    list.forEach((word, k) => view.setUint32(at + 4 * k, word, true));
  words(0, MAGIC, VERSION, bytes.length, padded(json.length), JSON_CHUNK);
  let at = HEADER_BYTES + CHUNK_HEADER_BYTES;
  bytes.fill(0x20, at, at + padded(json.length)).set(json, at);
  at += padded(json.length);
  if (length) words(at, length, BINARY_CHUNK);
  at += CHUNK_HEADER_BYTES;
  for (const { array } of pieces) {
    bytes.set(littleEndian(array), at);
    at += padded(array.byteLength);
  }
  return bytes;
}

/**
 * @param {Mesh} mesh with triangles
 * @returns {Piece[]} POSITION, NORMAL, TEXCOORD_0 if there is one, indices
 */
function piecesOf(mesh) {
  const positions = inFloats(mesh.positions, "positions");
  const count = positions.length / 3;
  const floats = (/** @type {Float32Array} */ array, /** @type {string} */ type, bounds = {}) => ({
    array,
    accessor: { componentType: FLOAT, count, type, ...bounds },
    target: ARRAY_BUFFER,
  });
  const indices = count - 1 > GREATEST_SHORT ? Uint32Array.from(mesh.indices) : Uint16Array.from(mesh.indices);
  const componentType = indices instanceof Uint16Array ? UNSIGNED_SHORT : UNSIGNED_INT;
  return [
    floats(positions, "VEC3", bounds(positions)),
    floats(unitNormals(inFloats(mesh.normals, "normals")), "VEC3"),
    ...(mesh.uvs ? [floats(mesh.uvs, "VEC2")] : []),
    {
      array: indices,
      accessor: { componentType, count: indices.length, type: "SCALAR" },
      target: ELEMENT_ARRAY_BUFFER,
    },
  ];
}

/** @param {Float32Array} positions */
function bounds(positions) {
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  positions.forEach((x, k) => {
    min[k % 3] = Math.min(min[k % 3], x);
    max[k % 3] = Math.max(max[k % 3], x);
  });
  // No −0, of which JSON is not sure.
  return { min: min.map((x) => x + 0), max: max.map((x) => x + 0) };
}

/**
 * glTF knows no zero normals: those of a patch that is a curve become +z.
 *
 * @param {Float32Array} normals
 */
function unitNormals(normals) {
  const zero = (/** @type {number} */ k) => !normals[k] && !normals[k + 1] && !normals[k + 2];
  return normals.map((x, k) => (k % 3 === 2 && zero(k - 2) ? 1 : x));
}

/**
 * The JSON chunk: one mesh in one node, both sides visible, as surfaces are open; an empty scene for an empty mesh.
 *
 * @param {Piece[]} pieces
 * @param {number} byteLength
 */
function description(pieces, byteLength) {
  const asset = { version: "2.0", generator: "casteljau" };
  if (!pieces.length) return { asset, scene: 0, scenes: [{}] };
  const names = pieces.length === 4 ? ["POSITION", "NORMAL", "TEXCOORD_0"] : ["POSITION", "NORMAL"];
  let byteOffset = 0;
  const bufferViews = pieces.map(({ array, target }) => {
    const view = { buffer: 0, byteOffset, byteLength: array.byteLength, target };
    byteOffset += padded(array.byteLength);
    return view;
  });
  const attributes = Object.fromEntries(names.map((name, k) => [name, k]));
  return {
    asset,
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes, indices: names.length, material: 0 }] }],
    materials: [{ doubleSided: true }],
    accessors: pieces.map(({ accessor }, k) => ({ bufferView: k, ...accessor })),
    bufferViews,
    buffers: [{ byteLength }],
  };
}

/**
 * The bytes of an array in the order of files.
 *
 * @param {Float32Array | Uint16Array | Uint32Array} array
 * @returns {Uint8Array}
 */
function littleEndian(array) {
  const bytes = new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
  if (new Uint8Array(Uint16Array.of(1).buffer)[0] === 1) return bytes;
  const width = array.BYTES_PER_ELEMENT;
  return bytes.map((_, k) => bytes[k - (k % width) + (width - 1 - (k % width))]);
}
