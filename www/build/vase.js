// The vase that the recipe of this name shows first, for its pictures.
import { NurbsCurve, NurbsSurface } from "#js/nurbs.js";

export function vase() {
  const points = [
    [0, 12],
    [21, 12],
    [42, 12],
    [80, 96],
    [18, 142],
    [36, 186],
    [30, 186],
    [12, 142],
    [74, 96],
    [36, 18],
    [0, 18],
  ];
  const weights = points.map((_, i) => (i === 3 || i === 8 ? 1.5 : 1));
  const knots = [0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 9, 9];
  const profile = new NurbsCurve({ degree: 2, points, weights, knots });
  return NurbsSurface.revolve(profile, { axis: [0, 1, 0] }).toSurface();
}
