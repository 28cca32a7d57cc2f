// The patches of a surface one by one, and surfaces of parts of them.
import { cached, Memo } from "../../editor/memo.js";
import { Surface } from "../../surfaces.js";
import type { Patch } from "../../surfaces.js";
import type { SurfaceFigure } from "../types.js";

/** Whether it is one of casteljau/nurbs; see rational.ts. */
export const hasWeights = (surface: Surface) => "weights" in surface;

/** All patches of a surface, taken out of it once. */
export const patchesOf = cached((surface: Surface): readonly Patch[] =>
  Array.from({ length: surface.patchCount }, (_, k) => surface.patch(k)),
);

const memoOf = cached((_: Surface) => new Memo());

/** The nearest point of a surface, computed once: the picture and the figure ask for the same. */
export const nearestTo = (surface: Surface, [x, y, z]: number[]) =>
  memoOf(surface).get("nearest", [x, y, z], (): SurfaceFigure["nearest"] => {
    const found = surface.nearest([x, y, z]);
    if (!found) return null;
    const { patch, u, v, distance, point } = found;
    return { patch, u, v, distance, point: [point.x, point.y, point.z] };
  });

/** What of a surface the curve of constant u has swept on its way from 0: the first piece of every patch. */
export function sweptBy(surface: Surface, u: number): Surface {
  const pieces = patchesOf(surface).map((patch) => patch.splitU(u)[0]);
  return Surface.fromPatches(pieces);
}
