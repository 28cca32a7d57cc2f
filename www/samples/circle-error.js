import { Curve } from "casteljau";

export function sample(print) {
  const handle = (4 / 3) * (Math.SQRT2 - 1); // the usual cubic for a quarter of a circle
  const quarter = new Curve([
    [1, 0],
    [1, handle],
    [handle, 1],
    [0, 1],
  ]);
  let error = 0;
  for (let k = 0; k <= 1000; k++) {
    const { x, y } = quarter.eval(k / 1000);
    error = Math.max(error, Math.abs(Math.hypot(x, y) - 1));
  }
  print(`largest error of the radius: ${error.toFixed(6)}`);
}
