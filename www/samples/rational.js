import { NurbsCurve, RationalCurve } from "casteljau/nurbs";

export function sample(print) {
  // A quarter of the unit circle with the weights 1, 1, 2.
  const points = [
    [1, 0],
    [1, 1],
    [0, 1],
  ];
  const quarter = new RationalCurve(points, [1, 1, 2]);
  for (const t of [0, 0.25, 0.5, 1]) {
    const { x, y } = quarter.eval(t);
    print(`t = ${t}: (${x.toFixed(4)}, ${y.toFixed(4)}), radius ${Math.hypot(x, y).toFixed(12)}`);
  }

  // The same arc with the first and the last weight 1.
  const middle = quarter.reparametrize().weights()[1];
  print(`weight of the middle point: ${middle.toFixed(4)}`);

  // The whole circle, and one more knot, which does not change it.
  const circle = NurbsCurve.circle([0, 0], 1);
  const refined = circle.insertKnot(0.1);
  for (const curve of [circle, refined]) {
    print(`${curve.points().length} points, ${curve.segments().length} arcs, length ${curve.length().toFixed(12)}`);
  }
}
