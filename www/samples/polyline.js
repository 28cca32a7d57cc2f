import { Curve } from "casteljau";

export function sample(print) {
  const curve = new Curve([
    [60, 400],
    [160, 40],
    [480, 40],
    [600, 400],
  ]);

  // Ten segments, eleven points. i / 10 reaches 1; adding 0.1 ten times does not.
  let sum = 0;
  for (let i = 0; i <= 10; i++) {
    const { x, y } = curve.eval(i / 10);
    print(`t = ${(i / 10).toFixed(1)}  (${x.toFixed(1)}, ${y.toFixed(1)})`);
    if (i < 10) sum += 0.1;
  }
  print(`sum of ten tenths is 1: ${sum === 1}`);

  // With twice as many segments, the missing length is about a quarter.
  for (const segments of [4, 8, 16, 32]) {
    const points = curve.sample(segments);
    let length = 0;
    for (let k = 2; k < points.length; k += 2) {
      const [x, y] = [points[k] - points[k - 2], points[k + 1] - points[k - 1]];
      length += Math.hypot(x, y);
    }
    const missing = curve.length() - length;
    print(`${segments} segments: ${missing.toFixed(3)} too short`);
  }
}
