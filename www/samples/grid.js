import { Surface } from "casteljau";

export function sample(print) {
  const teapot = Surface.teapot();
  for (const segments of [4, 8, 16]) {
    const grid = teapot.grid({ segments });
    const mesh = teapot.tessellate({ segments, weld: "position" });
    const counts = [grid.positions.length, mesh.positions.length, mesh.indices.length].map((n) => n / 3);
    print(`${segments}: ${counts[0]} vertices, welded ${counts[1]}, ${counts[2]} triangles`);
  }
}
