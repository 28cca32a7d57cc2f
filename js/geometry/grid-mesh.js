import { LARGE_MESH, Mesh, copy, layouts, room } from "./mesh.js";
import { core } from "../wasm/surfaces-transfer.js";

/** @import { PatchRange } from "./mesh.js" */

/** Behind positions and normals come the buffers that depend on counts only. */
const FIRST_OF_LAYOUT = 2;

/**
 * The grid that the core has prepared. It is made and copied part by part, so that a part is still in the processor's
 * cache when it is copied.
 *
 * @internal
 * @param {number} patches
 * @param {{ u: number, v: number, quads: boolean, into: Mesh | undefined }} options
 * @returns {Mesh}
 */
export function takeGrid(patches, { u, v, quads, into }) {
  const vertices = (u + 1) * (v + 1);
  /** @type {any} */
  const Indices = patches * vertices > 0x10000 ? Uint32Array : Uint16Array;
  const place = (/** @type {any} */ Type, /** @type {number} */ size, /** @type {any} */ earlier) =>
    room(Type, patches * size, earlier);
  /** @type {any} the arrays' types are those of their places */
  const data = {
    positions: place(Float32Array, 3 * vertices, into?.positions),
    normals: place(Float32Array, 3 * vertices, into?.normals),
    uvs: place(Float32Array, 2 * vertices, into?.uvs),
    patchIds: place(Uint32Array, vertices, into?.patchIds),
    indices: place(Indices, 6 * u * v, into?.indices),
    quads: quads ? place(Indices, 4 * u * v, into?.quads) : undefined,
    patchRanges: ranges(patches, vertices, 6 * u * v, into?.patchRanges ?? []),
  };
  // In the order of the core.
  const buffers = [data.positions, data.normals, data.uvs, data.patchIds, data.indices];
  if (data.quads) buffers.push(data.quads);
  const layout = (/** @type {number} */ k) =>
    `${k} of ${patches} × ${u} × ${v} from ${buffers[k].byteOffset} in ${buffers[k].BYTES_PER_ELEMENT}`;
  const known = buffers.map((array, k) => k >= FIRST_OF_LAYOUT && layouts.get(array.buffer) === layout(k));
  for (let first = 0; first < patches; ) {
    const count = core().grid_part(first);
    buffers.forEach((array, buffer) => {
      if (known[buffer]) return;
      const size = array.length / patches;
      copy(buffer, count === patches ? array : array.subarray(first * size, (first + count) * size));
    });
    if (12 * count * vertices > LARGE_MESH) core().mesh_drop();
    first += count;
  }
  for (let k = FIRST_OF_LAYOUT; k < buffers.length; k++) layouts.set(buffers[k].buffer, layout(k));
  return into ? Object.assign(into, data) : new Mesh(data);
}

/**
 * @param {number} patches
 * @param {number} vertices of each
 * @param {number} indices of each
 * @param {PatchRange[]} into
 * @returns {PatchRange[]}
 */
function ranges(patches, vertices, indices, into) {
  into.length = patches;
  for (let k = 0; k < patches; k++) into[k] = { firstVertex: k * vertices, vertices, firstIndex: k * indices, indices };
  return into;
}
