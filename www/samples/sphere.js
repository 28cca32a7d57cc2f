import { NurbsCurve, NurbsSurface } from "casteljau/nurbs";

export function sample(print) {
  const sphere = NurbsSurface.sphere([0, 0, 0], 1);
  for (const v of [0, 0.1, 0.5]) {
    const { x, y, z } = sphere.eval(0.3, v);
    print(`height ${z.toFixed(4)}, distance from the centre ${Math.hypot(x, y, z).toFixed(12)}`);
  }

  // Only its triangles have an error.
  for (const tolerance of [0.1, 0.01, 0.001]) {
    const { indices } = sphere.toSurface().tessellate({ tolerance });
    print(`within ${tolerance}: ${indices.length / 3} triangles`);
  }

  // A circle beside the axis, turned by half a turn: a torus with R = 2 and r = ½ has the area 4π²Rr.
  const circle = NurbsCurve.circle([2, 0], 0.5);
  const half = NurbsSurface.revolve(circle, { axis: [0, 1, 0], angle: Math.PI });
  print(`half a torus: ${half.toSurface().area().toFixed(6)}, and 2π² = ${(2 * Math.PI ** 2).toFixed(6)}`);
}
