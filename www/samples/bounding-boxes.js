import { Curve } from "casteljau";

export function sample(print) {
  const curve = new Curve([
    [0, 0],
    [3, 3],
    [-1, 3],
    [2, 0],
  ]);
  const show = ({ min, max }) => {
    const [x0, y0, x1, y1] = [min.x, min.y, max.x, max.y].map((c) => c.toFixed(3));
    return `x ${x0} to ${x1}, y ${y0} to ${y1}`;
  };
  print(`control points: ${show(curve.controlBounds())}`);
  print(`curve:          ${show(curve.bounds())}`);

  const { x, y } = curve.extrema();
  const times = (ts) => Array.from(ts, (t) => t.toFixed(4)).join(", ");
  print(`extrema of x at t = ${times(x)}`);
  print(`extrema of y at t = ${times(y)}`);
}
