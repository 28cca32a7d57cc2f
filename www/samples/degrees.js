import { Curve } from "casteljau";

const show = (curve) => {
  const c = curve.controlPoints();
  const text = [];
  for (let k = 0; k < c.length; k += 2) {
    text.push(`(${c[k].toFixed(2)}, ${c[k + 1].toFixed(2)})`);
  }
  return text.join(" ");
};

export function sample(print) {
  // The same curve with more and more points.
  let curve = new Curve([
    [0, 0],
    [3, 6],
    [6, 0],
  ]);
  for (let n = 2; n <= 5; n++) {
    print(`degree ${curve.degree}: ${show(curve)}`);
    curve = curve.elevate();
  }

  // Reducing the degree. If a curve needs its degree, there is an error.
  const { curve: lower, error } = curve.reduce();
  const exact = error < 1e-12;
  print(`${curve.degree} to ${lower.degree}: error below 1e-12: ${exact}`);
  const cubic = new Curve([
    [0, 0],
    [0, 3],
    [6, 3],
    [6, 6],
  ]);
  print(`a real cubic: error ${cubic.reduce().error.toFixed(3)}`);

  // One of eleven points moves by 100. How far does the curve move?
  const moved = (t) => (100 * Curve.bernstein(10, t)[5]).toFixed(1);
  const moves = [0, 0.25, 0.5, 0.75, 1].map(moved);
  print(`degree 10, P5 moved by 100: ${moves.join(" ")}`);
}
