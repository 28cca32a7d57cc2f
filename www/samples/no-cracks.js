import { Surface } from "casteljau";

export function sample(print) {
  const teapot = Surface.teapot();
  print(`pieces of the recursion: ${teapot.subdivide(0.02).length}`);
  const mesh = teapot.tessellate({ tolerance: 0.02, weld: "position" });
  const sides = new Map(); // how many triangles each edge has
  for (let i = 0; i < mesh.indices.length; i++) {
    const ends = [mesh.indices[i], mesh.indices[i % 3 === 2 ? i - 2 : i + 1]];
    const edge = `${Math.min(...ends)} ${Math.max(...ends)}`;
    sides.set(edge, (sides.get(edge) ?? 0) + 1);
  }
  const counts = [1, 2, 3].map((n) => [...sides.values()].filter((count) => count === n).length);
  print(`edges with one triangle: ${counts[0]}, with two: ${counts[1]}, with three: ${counts[2]}`);
  const { shared, open, collapsed } = teapot.topology();
  print(`sides: ${shared.length} pairs, ${open.length} open, ${collapsed.length} collapsed`);
}
