/**
 * @import { Patch, Surface } from "../../index.js"
 */

/** @type {WeakMap<Surface, Patch[]>} */
const known = new WeakMap();

/**
 * All patches of a surface, taken out of it once.
 *
 * @param {Surface} surface
 * @returns {readonly Patch[]}
 */
export function patchesOf(surface) {
  const patches = known.get(surface) ?? Array.from({ length: surface.patchCount }, (_, k) => surface.patch(k));
  known.set(surface, patches);
  return patches;
}
