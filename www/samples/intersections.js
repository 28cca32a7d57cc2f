import { Curve } from "casteljau";

export function sample(print) {
  const arch = new Curve([
    [0, 0],
    [0, 2],
    [2, 2],
    [2, 0],
  ]);
  const line = new Curve([
    [-0.5, 0.5],
    [2.5, 1.2],
  ]);
  for (const { t, u, point, kind } of arch.intersections(line)) {
    const place = `(${point.x.toFixed(3)}, ${point.y.toFixed(3)})`;
    print(`t = ${t.toFixed(4)}, u = ${u.toFixed(4)}: ${place}, ${kind}`);
  }

  // Two cubics can meet in nine points: x = T(y) and y = T(x).
  const wave = [-1, 5, -5, 1];
  const even = [-1, -1 / 3, 1 / 3, 1];
  const across = new Curve(wave.map((x, i) => [x, even[i]]));
  const along = new Curve(wave.map((y, i) => [even[i], y]));
  print(`${across.intersections(along).length} intersections`);
}
