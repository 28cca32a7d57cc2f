// The patches of a surface one by one, and surfaces of parts of them.
import { Surface } from "../../surfaces.js";
import type { Patch } from "../../surfaces.js";

/** Whether it is one of casteljau/nurbs; see rational.ts. */
export const hasWeights = (surface: Surface) => "weights" in surface;

const known: WeakMap<Surface, Patch[]> = new WeakMap();

/** All patches of a surface, taken out of it once. */
export function patchesOf(surface: Surface): readonly Patch[] {
  const patches = known.get(surface) ?? Array.from({ length: surface.patchCount }, (_, k) => surface.patch(k));
  known.set(surface, patches);
  return patches;
}

/** What of a surface the curve of constant u has swept on its way from 0: the first piece of every patch. */
export function sweptBy(surface: Surface, u: number): Surface {
  const pieces = patchesOf(surface).map((patch) => patch.splitU(u)[0]);
  return Surface.fromPatches(pieces);
}
