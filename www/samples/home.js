import { Curve } from "casteljau";

export function sample(print) {
  const curve = new Curve([
    [0, 0],
    [0, 100],
    [200, 100],
    [200, 0],
  ]);
  const [left] = curve.split(0.5);
  print(`half way: t = ${curve.timeAtLength(curve.length() / 2)}`);
  print(`highest: y = ${curve.bounds().max.y}`);
  print(`first half: ${left.controlPoints().join(" ")}`);
}
