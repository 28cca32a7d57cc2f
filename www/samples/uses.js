import { Path, Spline, easing } from "casteljau";

export function sample(print) {
  // Animation: which share of the way is done after which share of the time?
  const inOut = easing(0.42, 0, 0.58, 1);
  const values = [0, 0.25, 0.5, 0.75, 1].map((x) => inOut(x).toFixed(3));
  print(`ease-in-out: ${values.join(" ")}`);

  // A camera flies through four points at constant speed. The steps of t are not equal.
  const way = Spline.interpolate([
    [60, 380],
    [170, 110],
    [420, 90],
    [610, 300],
  ]);
  const ts = [...way.equidistantTimes(4)].map((t) => t.toFixed(3));
  print(`each a quarter of the way: t = ${ts.join(" ")}`);

  // A letter is an outline of curves. Is a point inside? What is its bounding box?
  const o = Path.fromSVG("M 50 10 C 90 10 90 90 50 90 S 10 10 50 10 Z");
  const { min, max } = o.bounds();
  print(`o: ${o.contains([50, 50])}, outside: ${o.contains([85, 15])}`);
  print(`box from [${min.x}, ${min.y}] to [${max.x}, ${max.y}]`);
}
