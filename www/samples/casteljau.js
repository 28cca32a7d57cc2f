import { Curve } from "casteljau";

// De Casteljau's algorithm for any degree: interpolate on every leg until one point is left.
function casteljau(points, t) {
  if (points.length === 1) return points[0];
  const divide = (a, b) => a.map((x, k) => (1 - t) * x + t * b[k]);
  const next = points.slice(1).map((b, i) => divide(points[i], b));
  return casteljau(next, t);
}

export function sample(print) {
  const points = [
    [0, 0],
    [0, 8],
    [8, 8],
    [8, 0],
  ];
  print(`by hand: (${casteljau(points, 0.25).join(", ")})`);

  // The library returns the points of all rounds: four, three, two, one.
  for (const level of new Curve(points).deCasteljau(0.25)) {
    const text = [];
    for (let k = 0; k < level.length; k += 2) {
      text.push(`(${level[k]}, ${level[k + 1]})`);
    }
    print(text.join(" "));
  }
}
