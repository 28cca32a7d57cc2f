import { Curve } from "casteljau";

export function sample(print) {
  // Four curves: an arch, an S, a loop and a cusp.
  const [a, b, c, d] = [
    [0, 0],
    [0, 3],
    [4, 3],
    [4, 0],
  ];
  const shapes = {
    arch: [a, b, c, d],
    S: [a, [4, 0], [0, 3], [4, 3]],
    loop: [a, [5, 4], [-1, 4], d],
    cusp: [a, c, b, d],
  };
  for (const [name, points] of Object.entries(shapes)) {
    const curve = new Curve(points);
    const inflections = curve.inflections().length;
    const crossings = curve.selfIntersections().length;
    print(`${name}: ${curve.classify()}, ${inflections} inflections, ${crossings} crossings`);
  }

  // At the cusp the velocity is zero.
  const { x, y } = new Curve(shapes.cusp).derivativeAt(0.5);
  print(`velocity of the cusp at t = ½: (${x}, ${y})`);
}
