import { Curve } from "casteljau";

export function sample(print) {
  const points = [[120, 360], [200, 120], [470, 120], [550, 360]];

  // Four points, four readings of them. Where does each curve begin and end?
  for (const basis of ["bezier", "b-spline", "catmull-rom"]) {
    const curve = Curve.fromBasis(basis, points);
    const [a, b] = [curve.eval(0), curve.eval(1)];
    print(`${basis}: [${a.x.toFixed(1)}, ${a.y.toFixed(1)}] to [${b.x.toFixed(1)}, ${b.y.toFixed(1)}]`);
  }

  // Hermite takes two ends and the derivatives there: three times the handles of the Bézier curve.
  const bezier = new Curve(points);
  const hermite = Curve.fromBasis("hermite", [[120, 360], [550, 360], [240, -720], [240, 720]]);
  print(`the same curve: ${hermite.equals(bezier, 1e-9)}`);

  // A matrix of your own: the straight line from the first point to the last.
  const straight = Curve.fromBasis([0, 0, 0, 0, 0, 0, 0, 0, -1, 0, 0, 1, 1, 0, 0, 0], points);
  print(`amid the line: (${straight.eval(0.5).x.toFixed(1)}, ${straight.eval(0.5).y.toFixed(1)})`);
}
