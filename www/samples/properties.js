import { Curve } from "casteljau";

export function sample(print) {
  // A curve in space. Its velocities at the ends are 3(P1 − P0) and 3(P3 − P2).
  const curve = new Curve([
    [0, 2, 3],
    [2, 3, 5],
    [6, 7, 9],
    [3, 4, 5],
  ]);
  const show = ({ x, y, z }) => `(${x}, ${y}, ${z})`;
  print(`middle: ${show(curve.eval(0.5))}`);
  print(`velocity at the start ${show(curve.derivativeAt(0))}`);
  print(`velocity at the end ${show(curve.derivativeAt(1))}`);

  // Map the points, then draw; or draw, then map: the same. (Half the size, rotated.)
  const matrix = [0, 0.5, -0.5, 0, 300, 20];
  const flat = new Curve([
    [60, 400],
    [160, 40],
    [480, 40],
    [600, 400],
  ]);
  const p = flat.eval(0.3);
  const moved = { x: -0.5 * p.y + 300, y: 0.5 * p.x + 20 };
  const other = flat.transform(matrix).eval(0.3);
  print(`affine: ${Math.hypot(other.x - moved.x, other.y - moved.y) < 1e-12}`);

  // The curve lies inside the hull and does not reach P1 and P2.
  const { min, max } = flat.bounds();
  const [low, high] = [min.y.toFixed(1), max.y.toFixed(1)];
  print(`y from ${low} to ${high}, points from 40 to 400`);
}
