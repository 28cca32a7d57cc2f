import { Surface } from "casteljau";

export function sample(print) {
  const teapot = Surface.teapot();
  for (const [upper, lower] of [
    [0, 4],
    [4, 8],
  ]) {
    const [above, below] = [teapot.patch(upper), teapot.patch(lower)]; // they share v = 1 and v = 0
    const [p, q] = [above.partials(0.3, 1).v, below.partials(0.3, 0).v];
    const ratio = Math.hypot(q.x, q.y, q.z) / Math.hypot(p.x, p.y, p.z);
    const [n, m] = [above.normal(0.3, 1), below.normal(0.3, 0)];
    const cosine = n.x * m.x + n.y * m.y + n.z * m.z;
    print(`patches ${upper} and ${lower}: ratio ${ratio.toFixed(3)}, cosine of the angle ${cosine.toFixed(6)}`);
  }
}
