// Meshes as binary STL; src/io/mesh_export.rs writes the same bytes.
import { checkMesh, toFloat32Array, newFile } from "./mesh-file.js";
import type { MeshArrays } from "./mesh-file.js";

const STL_HEADER_BYTES = 80;
/** A normal and three corners of three f32, and two unused bytes. */
const STL_TRIANGLE_BYTES = 50;

/**
 * See `Mesh.toSTL`.
 *
 * @internal
 */
export function meshToSTL(mesh: MeshArrays): Uint8Array<ArrayBuffer> {
  const { indices } = mesh;
  checkMesh(mesh, indices, 3);
  const positions = toFloat32Array(mesh.positions, "positions");
  const bytes = newFile(STL_HEADER_BYTES + 4 + (indices.length / 3) * STL_TRIANGLE_BYTES);
  const view = new DataView(bytes.buffer);
  // The header must not start with "solid", as the text format does.
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
 * The unit normal of a triangle by the right-hand rule; zero if the triangle is degenerate.
 *
 * @param corners the index of each corner's x in `p`
 */
function faceNormal(p: Float32Array, [a, b, c]: number[]): number[] {
  const ab = [0, 1, 2].map((axis) => p[b + axis] - p[a + axis]);
  const ac = [0, 1, 2].map((axis) => p[c + axis] - p[a + axis]);
  const cross = [ab[1] * ac[2] - ab[2] * ac[1], ab[2] * ac[0] - ab[0] * ac[2], ab[0] * ac[1] - ab[1] * ac[0]];
  const length = Math.sqrt(cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2]);
  return cross.map((x) => (length > 0 ? x / length : 0));
}
