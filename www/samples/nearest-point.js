import { Curve } from "casteljau";

export function sample(print) {
  const curve = new Curve([
    [0, 0],
    [0, 2],
    [2, 2],
    [2, 0],
  ]);
  for (const q of [
    [1, 3],
    [3, 1],
    [1, -1],
  ]) {
    const { t, point, distance } = curve.nearest(q);
    const place = `(${point.x.toFixed(3)}, ${point.y.toFixed(3)})`;
    print(`Q = (${q.join(", ")}): t = ${t.toFixed(4)}, ${place}, distance ${distance.toFixed(4)}`);
  }

  // Was the curve clicked? Ask whether the distance is at most a few pixels.
  const isHit = (q) => curve.nearest(q).distance <= 0.1;
  print(`(1, 1.45): ${isHit([1, 1.45])}, (1, 1): ${isHit([1, 1])}`);
}
