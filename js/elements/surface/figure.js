// What the element shows, as plain values: for pages that judge it.
import { patchesOf } from "./patches.js";

/**
 * @import { SurfaceFigure } from "../types.js"
 * @import { Facts, Scene } from "./geometry.js"
 */

const NOTHING = {
  triangles: 0,
  vertices: 0,
  error: null,
  unit: /** @type {"" | "px"} */ (""),
  ms: null,
  recursion: null,
};

/**
 * @param {Scene} scene
 * @param {Facts | null} facts
 * @returns {SurfaceFigure}
 */
export function figureOf({ surface, picked, settings }, facts) {
  const { fineness, layers, parts, ...plain } = settings;
  const patch = patchesOf(surface)[picked ?? 0] ?? null;
  const { u, v } = settings;
  return {
    ...plain,
    ...fineness,
    segments: "segments" in fineness ? fineness.segments : null,
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

/** @param {Scene["surface"]} surface @param {number[] | null} probe */
function nearestOf(surface, probe) {
  const found = probe && surface.nearest(probe);
  if (!found) return null;
  const { patch, u, v, distance, point } = found;
  return { patch, u, v, distance, point: triple(point) };
}

/** @param {{ x: number, y: number, z?: number }} point @returns {[number, number, number]} */
const triple = ({ x, y, z = 0 }) => [x, y, z];

/** @param {Float64Array} flat @returns {[number, number, number][]} */
function triples(flat) {
  return Array.from({ length: flat.length / 3 }, (_, k) => [flat[3 * k], flat[3 * k + 1], flat[3 * k + 2]]);
}
