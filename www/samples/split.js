import { Curve, Spline } from "casteljau";

const show = (curve) => {
  const c = curve.controlPoints();
  const round = (x) => Number(x.toFixed(6));
  return [0, 2, 4, 6].map((k) => `(${round(c[k])}, ${round(c[k + 1])})`).join(" ");
};

export function sample(print) {
  const points = [
    [0, 8],
    [8, 0],
    [24, 0],
    [32, 8],
  ];
  const curve = new Curve(points);

  const [q, r] = curve.split(0.5);
  print(`q: ${show(q)}`);
  print(`r: ${show(r)}`);

  // The part between two parameters. If they are swapped, it runs backwards.
  print(`third quarter: ${show(curve.subsegment(0.5, 0.75))}`);
  print(`reversed: ${show(curve.subsegment(1, 0))}`);

  // Insert a point: two pieces, the same shape.
  const spline = new Spline(points).insert(0.5);
  const [a, b] = [spline.eval(1.5), curve.eval(0.75)];
  const moved = Math.hypot(a.x - b.x, a.y - b.y);
  print(`${spline.segmentCount} segments, moved by ${moved}`);
}
