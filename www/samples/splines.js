import { Spline } from "casteljau";

export function sample(print) {
  const points = [
    [60, 380],
    [170, 110],
    [300, 330],
    [420, 90],
    [610, 300],
  ];
  const kinds = {
    natural: Spline.interpolate(points, { kind: "natural" }),
    "Catmull-Rom": Spline.interpolate(points, { kind: "catmull-rom", alpha: 0.5 }),
    "B-spline": Spline.fromBSpline(points),
  };

  // How smooth is the first joint, and how far is the spline from P1?
  for (const [name, spline] of Object.entries(kinds)) {
    const { c1, c2 } = spline.continuity(1);
    const off = spline.nearest(points[1]).distance;
    print(`${name}: ${c2 ? "C2" : c1 ? "C1" : "G1"}, ${off.toFixed(1)} from P1`);
  }

  // Move the first point by 50. How far does the other end move?
  const shifted = [[60, 330], ...points.slice(1)];
  for (const kind of ["natural", "catmull-rom"]) {
    const before = Spline.interpolate(points, { kind }).eval(3.5);
    const after = Spline.interpolate(shifted, { kind }).eval(3.5);
    const moved = Math.hypot(after.x - before.x, after.y - before.y);
    print(`${kind}: the other end moves by ${moved.toFixed(3)}`);
  }
}
