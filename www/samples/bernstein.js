import { Curve } from "casteljau";

export function sample(print) {
  const points = [
    [60, 400],
    [160, 40],
    [480, 40],
    [600, 400],
  ];
  const t = 0.25;

  const weights = Curve.bernstein(3, t);
  print(`weights: ${[...weights].join(", ")}`);
  print(`their sum: ${weights.reduce((sum, weight) => sum + weight)}`);

  // The weighted mean of the control points
  const x = points.reduce((sum, point, i) => sum + weights[i] * point[0], 0);
  const y = points.reduce((sum, point, i) => sum + weights[i] * point[1], 0);
  print(`mean:  (${x.toFixed(4)}, ${y.toFixed(4)})`);

  // is the point of the curve.
  const p = new Curve(points).eval(t);
  print(`curve: (${p.x.toFixed(4)}, ${p.y.toFixed(4)})`);

  // At t = 1/2 the weights are the binomial coefficients, divided by 2 to the power of the degree.
  for (let degree = 1; degree <= 5; degree++) {
    const row = Curve.bernstein(degree, 0.5).map((w) => w * 2 ** degree);
    print(`degree ${degree}: ${row.join(" ")}`);
  }
}
