// Meshes as Wavefront OBJ text; src/io/mesh_export.rs writes the same.
import * as check from "../geometry/check.js";
import { formatNumber } from "./format-number.js";
import { checkMesh } from "./mesh-file.js";
import type { MeshArrays } from "./mesh-file.js";

/**
 * See `Mesh.toOBJ`.
 *
 * @internal
 */
export function meshToOBJ(mesh: MeshArrays, options?: { quads?: boolean }): string {
  const quads = check.optionalBoolean(check.options(options, ["quads"]).quads, "quads", mesh.quads !== undefined);
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
 * @param count the number of numbers per line
 */
function addLines(lines: string[], word: string, numbers: Float32Array | Float64Array, count: number) {
  for (let i = 0; i < numbers.length; i += count) {
    let line = word;
    for (let k = i; k < i + count; k++) line += ` ${formatNumber(numbers, k)}`;
    lines.push(line);
  }
}
