import { Curve } from "casteljau";

export function sample(print) {
  const curve = new Curve([
    [0, 0],
    [1, 3],
    [3, 3],
    [4, 0],
  ]);
  for (const t of [0, 0.25, 0.5, 0.75, 1]) {
    const { x, y } = curve.eval(t);
    print(`t = ${t}: (${x}, ${y})`);
  }
}
