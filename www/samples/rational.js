import { Curve, Spline } from "casteljau";

export function sample(print) {
  // A quarter of the unit circle with the weights 1, 1, 2, as the curve of the points (w x, w y, w) in space.
  const arc = new Curve([
    [1, 0, 1],
    [1, 1, 1],
    [0, 2, 2],
  ]);
  for (const t of [0, 0.25, 0.5, 1]) {
    const { x, y, z: w } = arc.eval(t);
    print(`t = ${t}: (${(x / w).toFixed(4)}, ${(y / w).toFixed(4)}), radius ${Math.hypot(x / w, y / w).toFixed(12)}`);
  }

  // The whole circle: nine points, every other weight is the root of 1/2, and twelve knots.
  const w = Math.SQRT1_2;
  const points = [
    [1, 0, 1],
    [w, w, w],
    [0, 1, 1],
    [-w, w, w],
    [-1, 0, 1],
    [-w, -w, w],
    [0, -1, 1],
    [w, -w, w],
    [1, 0, 1],
  ];
  const circle = Spline.fromBSpline(points, { degree: 2, knots: [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4] });
  let error = 0;
  for (let i = 0; i <= 1000; i++) {
    const { x, y, z } = circle.eval(i / 250);
    error = Math.max(error, Math.abs(Math.hypot(x / z, y / z) - 1));
  }
  print(`${circle.segmentCount} arcs, error below 1e-15: ${error < 1e-15}`);
}
