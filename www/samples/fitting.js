import { Path, Spline } from "casteljau";

export function sample(print) {
  // 60 points, alternately 0.05 above and below a wave.
  const points = Array.from({ length: 60 }, (_, i) => [i / 10, Math.sin(i / 10) + 0.05 * (-1) ** i]);
  for (const tolerance of [0.01, 0.03, 0.06]) {
    const spline = Spline.fit(points, { tolerance });
    const isNear = points.every((point) => spline.nearest(point).distance <= tolerance);
    print(`tolerance ${tolerance}: ${spline.segmentCount} cubics, all points near: ${isNear}`);
  }

  // A polygon of 200 corners, with fewer segments: the whole outline stays within the tolerance.
  const corner = (i) => [Math.cos(i), Math.sin(i)].map((x) => x * (50 + 10 * Math.sin(5 * i)));
  const polygon = Path.polygon(Array.from({ length: 200 }, (_, i) => corner((i * Math.PI) / 100)));
  const simple = polygon.simplify(0.5);
  print(`${polygon.subpaths[0].segmentCount} lines, ${simple.subpaths[0].segmentCount} cubics`);
}
