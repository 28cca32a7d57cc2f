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

/** The last answer for each point: a figure is read several times in a frame. @type {WeakMap<number[], { surface: Scene["surface"], nearest: SurfaceFigure["nearest"] }>} */
const answers = new WeakMap();

/** @param {Scene["surface"]} surface @param {number[] | null} probe */
function nearestOf(surface, probe) {
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

/** @param {{ x: number, y: number, z?: number }} point @returns {[number, number, number]} */
const triple = ({ x, y, z = 0 }) => [x, y, z];

/** @param {Float64Array} flat @returns {[number, number, number][]} */
function triples(flat) {
  return Array.from({ length: flat.length / 3 }, (_, k) => [flat[3 * k], flat[3 * k + 1], flat[3 * k + 2]]);
}
