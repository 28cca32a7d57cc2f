import { Curve } from "casteljau";

export function sample(print) {
  const curve = new Curve([
    [0, 0],
    [0, 3],
    [1, 0],
    [4, 0],
  ]);
  const length = curve.length();
  print(`length ${length.toFixed(6)}`);

  // The t where half of the length is covered is not 0.5.
  const t = curve.timeAtLength(length / 2);
  print(`half of it at t = ${t.toFixed(6)}`);

  // Five points at equal distances along the curve.
  for (const time of curve.equidistantTimes(4)) {
    const { x, y } = curve.eval(time);
    print(`t = ${time.toFixed(4)}: (${x.toFixed(3)}, ${y.toFixed(3)})`);
  }
}
