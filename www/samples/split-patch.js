import { Surface } from "casteljau";

export function sample(print) {
  const patch = Surface.teapot().patch(4);
  const [left, right] = patch.splitU(0.25);
  for (const [name, { x, y, z }] of Object.entries({
    "patch at (0.125, 0.5)": patch.eval(0.125, 0.5),
    "left part at (0.5, 0.5)": left.eval(0.5, 0.5),
  }))
    print(`${name}: ${x.toFixed(6)} ${y.toFixed(6)} ${z.toFixed(6)}`);
  const [before, after] = [left.isocurveAtU(1), right.isocurveAtU(0)];
  print(`the common side is the same: ${before.equals(after)}`);
}
