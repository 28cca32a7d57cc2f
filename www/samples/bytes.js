import { Surface } from "casteljau";

export function sample(print) {
  const teapot = Surface.teapot();
  const points = teapot.vertices.length * 4; // three numbers of four bytes each
  const indices = 32 * 16 * 2;
  print(`patches: ${points + indices} bytes`);
  for (const segments of [4, 16, 32]) {
    const { positions, normals, indices } = teapot.tessellate({ segments, weld: "position" });
    const bytes = positions.byteLength + normals.byteLength + indices.byteLength;
    print(`mesh of ${segments} × ${segments}: ${bytes} bytes`);
  }
}
