import { Surface } from "casteljau";

export function sample(print) {
  const teapot = Surface.teapot();
  const tubes = teapot.wireframe({ lines: 4, radius: 0.02, sides: 6 });
  const ribbons = teapot.wireframe({ lines: 4, width: 0.05 });
  print(`tubes: ${tubes.indices.length / 3} triangles`);
  print(`ribbons: ${ribbons.indices.length / 3} triangles`);
}
