import { Patch, Surface } from "casteljau";

export function sample(print) {
  // The profile of the teapot's rim, as pairs (r, z), and a quarter of the unit circle.
  const profile = [
    [1.4, 2.4],
    [1.3375, 2.53125],
    [1.4375, 2.53125],
    [1.5, 2.4],
  ];
  const quarter = [
    [1, 0],
    [1, -0.56],
    [0.56, -1],
    [0, -1],
  ];
  const net = profile.flatMap(([r, z]) => quarter.map(([x, y]) => [r * x, r * y, z]));
  const rim = Surface.teapot().patch(0).controlPoints();
  const differences = net.flat().map((coordinate, k) => Math.abs(coordinate - rim[k]));
  print(`difference from the teapot's points: ${Math.max(...differences).toFixed(6)}`);
  for (const u of [0, 0.25, 0.5]) {
    const { x, y } = new Patch(net).eval(u, 0);
    print(`radius at u = ${u}: ${(Math.hypot(x, y) / 1.4).toFixed(5)}`);
  }
}
