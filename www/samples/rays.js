import { Surface } from "casteljau";

export function sample(print) {
  const teapot = Surface.teapot();
  for (const { patch, distance } of teapot.intersectRay([-5, 0.1, 1.2], [1, 0, 0])) {
    print(`patch ${patch} at distance ${distance.toFixed(4)}`);
  }
  const { patch, u, v, distance } = teapot.nearest([2, 1, 3]);
  print(`nearest: patch ${patch}, u = ${u.toFixed(3)}, v = ${v.toFixed(3)}, ${distance.toFixed(4)} away`);
}
