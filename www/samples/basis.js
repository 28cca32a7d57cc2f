import { Curve } from "casteljau";

const show = ({ x, y }) => `[${x.toFixed(1)}, ${y.toFixed(1)}]`;

export function sample(print) {
  const points = [
    [120, 360],
    [200, 120],
    [470, 120],
    [550, 360],
  ];

  // The same four points in three bases. Where does each curve start and end?
  for (const basis of ["bezier", "b-spline", "catmull-rom"]) {
    const curve = Curve.fromBasis(basis, points);
    const [from, to] = [curve.eval(0), curve.eval(1)].map(show);
    print(`${basis}: ${from} to ${to}`);
  }

  // The Hermite form has two ends and the velocities there: three times the legs.
  const bezier = new Curve(points);
  const data = [
    [120, 360],
    [550, 360],
    [240, -720],
    [240, 720],
  ];
  const hermite = Curve.fromBasis("hermite", data);
  print(`the same curve: ${hermite.equals(bezier, 1e-9)}`);

  // Any other matrix: this one gives the line from the first point to the last.
  const matrix = [0, 0, 0, 0, 0, 0, 0, 0, -1, 0, 0, 1, 1, 0, 0, 0];
  print(`middle of the line: ${show(Curve.fromBasis(matrix, points).eval(0.5))}`);
}
