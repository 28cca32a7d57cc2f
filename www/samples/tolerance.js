import { Surface } from "casteljau";

export function sample(print) {
  const teapot = Surface.teapot();
  for (const tolerance of [0.1, 0.01, 0.001]) {
    const { indices } = teapot.tessellate({ tolerance });
    print(`within ${tolerance}: ${indices.length / 3} triangles`);
  }
}
