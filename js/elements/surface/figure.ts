// What the element shows, as plain values: for pages that judge it.
import { nearestTo, patchesOf } from "./patches.js";
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
    nearest: settings.probe && nearestTo(surface, settings.probe),
    mesh: facts ?? NOTHING,
  };
}

const triple = ({ x, y, z = 0 }: { x: number; y: number; z?: number }): [number, number, number] => [x, y, z];

function triples(flat: Float64Array): [number, number, number][] {
  return Array.from({ length: flat.length / 3 }, (_, k) => [flat[3 * k], flat[3 * k + 1], flat[3 * k + 2]]);
}
