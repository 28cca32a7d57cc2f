import { Curve } from "casteljau";

const lerp = (a, b, t) => [(1 - t) * a[0] + t * b[0], (1 - t) * a[1] + t * b[1]];

export function sample(print) {
  const [p0, p1, p2] = [
    [80, 400],
    [240, 60],
    [600, 320],
  ];
  const t = 0.75;

  const p01 = lerp(p0, p1, t);
  const p12 = lerp(p1, p2, t);
  const p = lerp(p01, p12, t);
  print(`p01 = (${p01.join(", ")})`);
  print(`p12 = (${p12.join(", ")})`);
  print(`P   = (${p.join(", ")})`);

  const { x, y } = new Curve([p0, p1, p2]).eval(t);
  print(`the curve there: (${x}, ${y})`);
}
