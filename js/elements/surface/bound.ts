// How far a grid of flat triangles can be from its surface.
import { patchesOf } from "./patches.js";
import type { Patch, Surface } from "../../surfaces.js";

/**
 * No point of the surface is farther than this from its grid of n × n cells: (M_uu + 2 M_uv + M_vv) / 8n², where M are
 * bounds of the second derivatives, taken from the second differences of the control points. Source: Filip, Magedson,
 * Markot, Surface algorithms using bounds on derivatives, CAGD 3 (1986).
 */
export function errorBound(surface: Surface, n: number): number {
  return patchesOf(surface).reduce((max, patch) => Math.max(max, secondDerivatives(patch)), 0) / (8 * n * n);
}

/** M_uu + 2 M_uv + M_vv of one patch. */
function secondDerivatives(patch: Patch) {
  const [n, m, net] = [patch.degreeU, patch.degreeV, patch.controlPoints()];
  const size = (...terms: [number, number, number][]) =>
    Math.hypot(
      ...[0, 1, 2].map((axis) =>
        terms.reduce((sum, [i, j, weight]) => sum + weight * net[3 * (j * (n + 1) + i) + axis], 0),
      ),
    );
  let [uu, uv, vv] = [0, 0, 0];
  for (let j = 0; j <= m; j++) {
    for (let i = 0; i <= n; i++) {
      if (i > 1) uu = Math.max(uu, size([i, j, 1], [i - 1, j, -2], [i - 2, j, 1]));
      if (j > 1) vv = Math.max(vv, size([i, j, 1], [i, j - 1, -2], [i, j - 2, 1]));
      if (i > 0 && j > 0) uv = Math.max(uv, size([i, j, 1], [i - 1, j, -1], [i, j - 1, -1], [i - 1, j - 1, 1]));
    }
  }
  return n * (n - 1) * uu + 2 * n * m * uv + m * (m - 1) * vv;
}
