// Meshes as binary glTF 2.0; src/io/glb.rs produces the same bytes. Source: Khronos, glTF 2.0 specification, §3 and §4.
import { checkMesh, toFloat32Array, newFile } from "./mesh-file.js";
import type { MeshArrays } from "./mesh-file.js";

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

/** The largest 16-bit vertex index; glTF reserves 65,535. */
const MAX_SHORT_INDEX = 0xfffe;

const paddedLength = (length: number) => Math.ceil(length / 4) * 4;

/** A buffer view of the binary chunk: its data, its accessor without the index of the view, its target. */
export type View = {
  array: Float32Array | Uint16Array | Uint32Array;
  accessor: Record<string, unknown>;
  target: number;
};

/**
 * See `Mesh.toGLB`.
 *
 * @internal
 */
export function meshToGLB(mesh: MeshArrays): Uint8Array<ArrayBuffer> {
  checkMesh(mesh, mesh.indices, 3);
  const views = mesh.indices.length ? viewsOf(mesh) : [];
  const length = views.reduce((sum, { array }) => sum + paddedLength(array.byteLength), 0);
  const json = new TextEncoder().encode(JSON.stringify(document(views, length)));
  const binary = length ? CHUNK_HEADER_BYTES + length : 0;
  const bytes = newFile(HEADER_BYTES + CHUNK_HEADER_BYTES + paddedLength(json.length) + binary);
  const view = new DataView(bytes.buffer);
  const writeWords = (at: number, ...list: number[]) =>
    list.forEach((word, k) => view.setUint32(at + 4 * k, word, true));
  writeWords(0, MAGIC, VERSION, bytes.length, paddedLength(json.length), JSON_CHUNK);
  let at = HEADER_BYTES + CHUNK_HEADER_BYTES;
  bytes.fill(0x20, at, at + paddedLength(json.length)).set(json, at);
  at += paddedLength(json.length);
  if (length) writeWords(at, length, BINARY_CHUNK);
  at += CHUNK_HEADER_BYTES;
  for (const { array } of views) {
    bytes.set(littleEndian(array), at);
    at += paddedLength(array.byteLength);
  }
  return bytes;
}

/**
 * @param mesh with at least one triangle
 * @returns POSITION, NORMAL, TEXCOORD_0 if there is one, indices
 */
function viewsOf(mesh: MeshArrays): View[] {
  const positions = toFloat32Array(mesh.positions, "positions");
  const count = positions.length / 3;
  const floats = (array: Float32Array, type: string, bounds = {}) => ({
    array,
    accessor: { componentType: FLOAT, count, type, ...bounds },
    target: ARRAY_BUFFER,
  });
  const indices = count - 1 > MAX_SHORT_INDEX ? Uint32Array.from(mesh.indices) : Uint16Array.from(mesh.indices);
  const componentType = indices instanceof Uint16Array ? UNSIGNED_SHORT : UNSIGNED_INT;
  return [
    floats(positions, "VEC3", bounds(positions)),
    floats(unitNormals(toFloat32Array(mesh.normals, "normals")), "VEC3"),
    ...(mesh.uvs ? [floats(mesh.uvs, "VEC2")] : []),
    {
      array: indices,
      accessor: { componentType, count: indices.length, type: "SCALAR" },
      target: ELEMENT_ARRAY_BUFFER,
    },
  ];
}

function bounds(positions: Float32Array) {
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  positions.forEach((x, k) => {
    min[k % 3] = Math.min(min[k % 3], x);
    max[k % 3] = Math.max(max[k % 3], x);
  });
  // JSON.stringify writes −0 as 0, but other writers do not.
  return { min: min.map((x) => x + 0), max: max.map((x) => x + 0) };
}

/** glTF does not allow zero normals (of patches that are curves): they become +z. */
function unitNormals(normals: Float32Array) {
  const isZero = (k: number) => !normals[k] && !normals[k + 1] && !normals[k + 2];
  return normals.map((x, k) => (k % 3 === 2 && isZero(k - 2) ? 1 : x));
}

/**
 * The JSON chunk: one mesh in one node, double-sided because surfaces may be open; an empty scene for an empty mesh.
 */
function document(views: View[], byteLength: number) {
  const asset = { version: "2.0", generator: "casteljau" };
  if (!views.length) return { asset, scene: 0, scenes: [{}] };
  const names = views.length === 4 ? ["POSITION", "NORMAL", "TEXCOORD_0"] : ["POSITION", "NORMAL"];
  let byteOffset = 0;
  const bufferViews = views.map(({ array, target }) => {
    const view = { buffer: 0, byteOffset, byteLength: array.byteLength, target };
    byteOffset += paddedLength(array.byteLength);
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
    accessors: views.map(({ accessor }, k) => ({ bufferView: k, ...accessor })),
    bufferViews,
    buffers: [{ byteLength }],
  };
}

/** The bytes of an array in little-endian order. */
function littleEndian(array: Float32Array | Uint16Array | Uint32Array): Uint8Array {
  const bytes = new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
  if (new Uint8Array(Uint16Array.of(1).buffer)[0] === 1) return bytes;
  const width = array.BYTES_PER_ELEMENT;
  return bytes.map((_, k) => bytes[k - (k % width) + (width - 1 - (k % width))]);
}
