import { surfacesModule } from "../wasm/surfaces-module.js";
import { LARGE_MESH, Mesh, copyBuffer, gridLayouts, reuseOrAllocate } from "./mesh.js";
import type { PatchRange } from "./mesh.js";

/** The first of the buffers that depend only on the counts; positions and normals are before it. */
const FIRST_LAYOUT_BUFFER = 2;

/**
 * Reads the grid that the core has prepared. It is computed and copied in parts, so that each part is still in the
 * processor cache when it is copied.
 *
 * @internal
 */
export function readGrid(
  patches: number,
  { u, v, quads, into }: { u: number; v: number; quads: boolean; into: Mesh | undefined },
): Mesh {
  const vertices = (u + 1) * (v + 1);
  const Indices: any = patches * vertices > 0x10000 ? Uint32Array : Uint16Array;
  const allocate = (Type: any, size: number, earlier: any) => reuseOrAllocate(Type, patches * size, earlier);
  /** Each array has the type of its field */
  const data: any = {
    positions: allocate(Float32Array, 3 * vertices, into?.positions),
    normals: allocate(Float32Array, 3 * vertices, into?.normals),
    uvs: allocate(Float32Array, 2 * vertices, into?.uvs),
    patchIds: allocate(Uint32Array, vertices, into?.patchIds),
    indices: allocate(Indices, 6 * u * v, into?.indices),
    quads: quads ? allocate(Indices, 4 * u * v, into?.quads) : undefined,
    patchRanges: patchRangesOf(patches, vertices, 6 * u * v, into?.patchRanges ?? []),
  };
  // In the order of the core's buffer indices.
  const buffers = [data.positions, data.normals, data.uvs, data.patchIds, data.indices];
  if (data.quads) buffers.push(data.quads);
  const layout = (k: number) =>
    `${k} of ${patches} × ${u} × ${v} from ${buffers[k].byteOffset} in ${buffers[k].BYTES_PER_ELEMENT}`;
  const upToDate = buffers.map((array, k) => k >= FIRST_LAYOUT_BUFFER && gridLayouts.get(array.buffer) === layout(k));
  for (let first = 0; first < patches; ) {
    const count = surfacesModule.functions.grid_part(first);
    buffers.forEach((array, buffer) => {
      if (upToDate[buffer]) return;
      const size = array.length / patches;
      copyBuffer(buffer, count === patches ? array : array.subarray(first * size, (first + count) * size));
    });
    if (12 * count * vertices > LARGE_MESH) surfacesModule.functions.mesh_drop();
    first += count;
  }
  for (let k = FIRST_LAYOUT_BUFFER; k < buffers.length; k++) gridLayouts.set(buffers[k].buffer, layout(k));
  return into ? Object.assign(into, data) : new Mesh(data);
}

/**
 * @param vertices per patch
 * @param indices per patch
 */
function patchRangesOf(patches: number, vertices: number, indices: number, into: PatchRange[]): PatchRange[] {
  into.length = patches;
  for (let k = 0; k < patches; k++) into[k] = { firstVertex: k * vertices, vertices, firstIndex: k * indices, indices };
  return into;
}
