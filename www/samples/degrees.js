import { Curve } from "casteljau";

const show = (curve) => {
  const c = curve.controlPoints();
  const pairs = [];
  for (let k = 0; k < c.length; k += 2) pairs.push(`(${c[k].toFixed(2)}, ${c[k + 1].toFixed(2)})`);
  return pairs.join(" ");
};

export function sample(print) {
  // The same curve with one more control point, again and again: the polygon closes in on it.
  let curve = new Curve([[0, 0], [3, 6], [6, 0]]);
  for (let n = 2; n <= 5; n++) {
    print(`degree ${curve.degree}: ${show(curve)}`);
    curve = curve.elevate();
  }

  // And back. A curve that needs its degree leaves an error, and reduce says how large.
  const { curve: lower, error } = curve.reduce();
  print(`${curve.degree} to ${lower.degree}: error below 1e-12: ${error < 1e-12}`);
  print(`a real cubic: error ${new Curve([[0, 0], [0, 3], [6, 3], [6, 6]]).reduce().error.toFixed(3)}`);

  // One of eleven points moves by 100: how far does the curve move at t = 0, 1/4, 1/2, 3/4, 1?
  const moves = [0, 0.25, 0.5, 0.75, 1].map((t) => (100 * Curve.bernstein(10, t)[5]).toFixed(1));
  print(`degree 10, P5 moved by 100: ${moves.join(" ")}`);
}
