import { Surface } from "casteljau";

export function sample(print) {
  const teapot = Surface.teapot();
  for (let row = 0; row < 16; row++) {
    let line = "";
    for (let column = 0; column < 54; column++) {
      const origin = [-3.1 + 0.125 * column, -10, 3.1 - 0.2 * row];
      const [hit] = teapot.intersectRay(origin, [0, 1, 0]); // the first hit
      line += hit ? shade(teapot.patch(hit.patch).normal(hit.u, hit.v)) : " ";
    }
    print(line.trimEnd());
  }
}

// A character for the angle between the normal and the light.
function shade({ x, y, z }) {
  const cosine = Math.max(0, -0.48 * x - 0.6 * y + 0.64 * z);
  return ".:-=+*#%@"[Math.min(8, Math.floor(9 * cosine))];
}
