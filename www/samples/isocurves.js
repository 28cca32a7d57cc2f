import { Surface } from "casteljau";

export function sample(print) {
  const teapot = Surface.teapot();
  const curve = teapot.patch(16).isocurveAtU(0.5); // along the spout
  print(`degree ${curve.degree}, length ${curve.length().toFixed(4)}`);
  const lines = teapot.isocurves({ lines: 4 });
  print(`${lines.length} curves divide the teapot into strips`);
}
