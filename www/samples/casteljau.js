import { Curve } from "casteljau";

// The whole algorithm, for any degree: divide every leg, drop one point, repeat.
function casteljau(points, t) {
  if (points.length === 1) return points[0];
  const next = points.slice(1).map((b, i) => points[i].map((a, k) => (1 - t) * a + t * b[k]));
  return casteljau(next, t);
}

export function sample(print) {
  const points = [[0, 4], [2, 0], [6, 0], [8, 4]];
  print(`by hand: (${casteljau(points, 0.25).join(", ")})`);

  // The library keeps all levels: four points, three, two, one.
  for (const level of new Curve(points).scaffold(0.25)) {
    const pairs = [];
    for (let k = 0; k < level.length; k += 2) pairs.push(`(${level[k]}, ${level[k + 1]})`);
    print(pairs.join(" "));
  }
}
