import { Curve, Path } from "casteljau";

export function sample(print) {
  const curve = new Curve([
    [0, 0],
    [0, 2],
    [2, 2],
    [2, 0],
  ]);
  // One cubic becomes several: the smaller the tolerance, the more.
  for (const tolerance of [0.01, 0.0001, 0.00001]) {
    const offset = curve.offset(0.3, { tolerance });
    print(`tolerance ${tolerance}, cubics: ${offset.segmentCount}, length ${offset.length().toFixed(3)}`);
  }

  // The outline of a stroke: offsets on both sides, a join, two caps.
  const line = Path.fromSVG("M0 0H10V10");
  for (const join of ["miter", "round", "bevel"]) {
    const outline = line.stroke(2, { join });
    print(`${join}: area ${outline.area().toFixed(3)}`);
  }
}
