import { Curve } from "casteljau";

export function sample(print) {
  const curve = new Curve([
    [0, 0],
    [0, 8],
    [8, 8],
    [8, 0],
  ]);

  // The control points of the derivative: three times the legs.
  print(`B' has the points ${curve.derivative().controlPoints().join(" ")}`);

  for (const t of [0, 0.5, 1]) {
    const { x, y } = curve.derivativeAt(t);
    print(`t = ${t}: velocity (${x}, ${y}), speed ${Math.hypot(x, y)}`);
  }

  const acceleration = curve.derivativeAt(0.5, 2);
  print(`acceleration at 0.5: (${acceleration.x}, ${acceleration.y})`);

  const curvature = curve.curvature(0.5);
  print(`curvature at 0.5: ${curvature.toFixed(4)}`);
  print(`radius of curvature: ${Math.abs(1 / curvature).toFixed(4)}`);
}
