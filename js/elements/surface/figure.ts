// What the element shows, as plain values: for pages that judge it.
import { patchesOf } from "./patches.js";
import type { SurfaceFigure } from "../types.js";
import type { Facts, Scene } from "./geometry.js";

const NOTHING = {
  triangles: 0,
  vertices: 0,
  error: null,
  unit: "" as "" | "px",
  ms: null,
  recursion: null,
};

export function figureOf({ surface, picked, settings }: Scene, facts: Facts | null): SurfaceFigure {
  const { detail, layers, parts, ...plain } = settings;
  const patch = patchesOf(surface)[picked ?? 0] ?? null;
  const { u, v } = settings;
  return {
    ...plain,
    ...detail,
    segments: "segments" in detail ? detail.segments : null,
    parts: [...parts],
    layers: [...layers],
    surface,
    patch: picked,
    points: patch ? triples(patch.controlPoints()) : [],
    degreeU: patch?.degreeU ?? 0,
    degreeV: patch?.degreeV ?? 0,
    place: patch ? { point: triple(patch.eval(u, v)), normal: triple(patch.normal(u, v)) } : null,
    nearest: nearestOf(surface, settings.probe),
    mesh: facts ?? NOTHING,
  };
}

/** The last answer for each point: a figure is read several times in a frame. */
const answers: WeakMap<number[], { surface: Scene["surface"]; nearest: SurfaceFigure["nearest"] }> = new WeakMap();

function nearestOf(surface: Scene["surface"], probe: number[] | null) {
  if (!probe) return null;
  const known = answers.get(probe);
  if (known?.surface === surface) return known.nearest;
  const found = surface.nearest(probe);
  const nearest = found && {
    patch: found.patch,
    u: found.u,
    v: found.v,
    distance: found.distance,
    point: triple(found.point),
  };
  answers.set(probe, { surface, nearest });
  return nearest;
}

const triple = ({ x, y, z = 0 }: { x: number; y: number; z?: number }): [number, number, number] => [x, y, z];

function triples(flat: Float64Array): [number, number, number][] {
  return Array.from({ length: flat.length / 3 }, (_, k) => [flat[3 * k], flat[3 * k + 1], flat[3 * k + 2]]);
}
