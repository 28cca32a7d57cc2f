import { Curve } from "casteljau";

/** The first of n equal arcs of the circle of radius 1. */
const arc = (n) => {
  const angle = (2 * Math.PI) / n;
  const h = (4 / 3) * Math.tan(angle / 4);
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return new Curve([
    [1, 0],
    [1, h],
    [c + h * s, s - h * c],
    [c, s],
  ]);
};

export function sample(print) {
  for (const n of [2, 4, 8, 16]) {
    const curve = arc(n);
    let error = 0;
    for (let i = 0; i <= 1000; i++) {
      const { x, y } = curve.eval(i / 1000);
      error = Math.max(error, Math.abs(Math.hypot(x, y) - 1));
    }
    print(`${n} arcs: error ${(1e6 * error).toFixed(3)} millionths`);
  }
}
