import { Curve, Surface } from "casteljau";

export function sample(print) {
  const patch = Surface.teapot().patch(4);
  const [u, v] = [0.25, 0.75];
  const net = patch.controlPoints();
  const rows = [0, 1, 2, 3].map((j) => new Curve(net.slice(12 * j, 12 * j + 12), { dimension: 3 }));
  const amid = rows.map((row) => row.eval(u)); // one point on each row
  const point = new Curve(amid).eval(v); // and they control one more curve
  const { x, y, z } = patch.eval(u, v);
  print(`${point.x.toFixed(6)} ${point.y.toFixed(6)} ${point.z.toFixed(6)}`);
  print(`${x.toFixed(6)} ${y.toFixed(6)} ${z.toFixed(6)}`);
}
