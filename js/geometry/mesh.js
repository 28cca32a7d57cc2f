import * as check from "./check.js";
import { meshToOBJ } from "../io/obj.js";
import { meshToSTL } from "../io/stl.js";
import { meshToGLB } from "../io/glb.js";
import { meshToThree } from "../io/three.js";
import { core } from "../wasm/surfaces-transfer.js";

/**
 * @import { GeometryLike, Three } from "../io/three.js"
 */

/**
 * Where the part of one patch lies in a mesh.
 *
 * @typedef {{ firstVertex: number, vertices: number, firstIndex: number, indices: number }} PatchRange
 */

/**
 * What a grid is made of.
 *
 * @typedef {object} GridOptions
 * @property {number | { u: number, v: number }} segments cells along each direction of a patch
 * @property {"bernstein" | "forward-difference"} [method] how samples are computed: from the Bernstein polynomials (the
 *   default), or along u by adding up differences, m additions per coordinate and step for degree m: for comparison and
 *   teaching. Rounding errors add up, too, though in 64 bits they stay below what 32 bits show; sides of neighbours may
 *   differ by the last bit
 * @property {boolean} [quads] list four-sided faces too
 * @property {Mesh} [into] an earlier mesh, whose arrays are reused where they are large enough. Positions and normals are
 *   written anew; uvs, patchIds, indices and quads, which depend on counts only, are left alone where they already are
 *   those of a grid of these counts, and with them what you may have changed there
 */

/**
 * Memory that holds a part of the layout of a grid, and of which: it need not be written again.
 *
 * @internal
 * @type {WeakMap<object, string>}
 */
export const layouts = new WeakMap();

const METHODS = /** @type {const} */ (["bernstein", "forward-difference"]);

/** Above this many bytes the core gives the memory of a mesh back after it was read. */
export const LARGE_MESH = 1 << 24;

/** The buffers of a mesh in the order of the core. */
const POSITIONS = 0;
const NORMALS = 1;
const UVS = 2;
const PATCH_IDS = 3;
const INDICES = 4;
const QUADS = 5;
const PATCH_RANGES = 6;
const PRECISE_POSITIONS = 7;
const PRECISE_NORMALS = 8;

/**
 * A triangle mesh as plain data, ready for a graphics card. Triangles run counter-clockwise as seen from the side that
 * ∂u × ∂v points to.
 */
export class Mesh {
  /**
   * @param {object} data
   * @param {Float32Array | Float64Array} data.positions
   * @param {Float32Array | Float64Array} data.normals
   * @param {Float32Array | null} data.uvs
   * @param {Uint32Array | null} data.patchIds
   * @param {Uint16Array | Uint32Array} data.indices
   * @param {Uint16Array | Uint32Array} [data.quads]
   * @param {PatchRange[]} data.patchRanges
   */
  constructor({ positions, normals, uvs, patchIds, indices, quads, patchRanges }) {
    /** x, y, z of each vertex. */
    this.positions = positions;
    /** The unit normal of each vertex. */
    this.normals = normals;
    /** u, v of each vertex in its patch; null where patches share vertices. */
    this.uvs = uvs;
    /** The patch that each vertex belongs to; null where patches share vertices. */
    this.patchIds = patchIds;
    /** Three vertices per triangle, in the smallest type that fits. */
    this.indices = indices;
    /** Four vertices per face, where they were asked for. */
    this.quads = quads;
    /** Where each patch lies in the arrays; no vertices where patches share them. */
    this.patchRanges = patchRanges;
  }

  /**
   * The text of a Wavefront OBJ file: positions, (u, v) where there are any, normals; faces of four where the mesh has
   * quads, else triangles. Numbers have the fewest digits that give them back.
   *
   * @param {{ quads?: boolean }} [options] `quads: false` writes triangles in any case
   * @returns {string}
   * @throws {RangeError} for `quads: true` without quads, and for arrays that were changed and no longer belong together
   */
  toOBJ(options) {
    return meshToOBJ(this, options);
  }

  /**
   * The bytes of a binary STL file: 84 and 50 for each triangle. Normals follow from the corners by the right-hand rule,
   * zero where a triangle is degenerate. Positions of 64 bits are rounded to 32.
   *
   * @returns {Uint8Array<ArrayBuffer>}
   * @throws {RangeError} above 1 GiB, for positions that 32 bits cannot hold, and as `toOBJ`
   */
  toSTL() {
    return meshToSTL(this);
  }

  /**
   * The bytes of a binary glTF 2.0 file, self-contained: one mesh with positions, normals, (u, v) where there are any and
   * indices, visible from both sides. An empty mesh gives an empty scene. Numbers of 64 bits are rounded to 32; normals
   * that are zero become +z, as glTF allows none. Viewers of glTF take y as up: make the surface with `up: "y"`.
   *
   * @returns {Uint8Array<ArrayBuffer>}
   * @throws {RangeError} as `toSTL`
   */
  toGLB() {
    return meshToGLB(this);
  }

  /**
   * A BufferGeometry of three.js with `position`, `normal`, `uv` where there are any, and an index. It works on the arrays
   * of this mesh, not on copies (but for those of 64 bits, which become 32).
   *
   *     import * as THREE from "three";
   *     const geometry = Surface.teapot({ up: "y" }).tessellate({ tolerance: 0.01 }).toThree(THREE);
   *
   * @template Attribute
   * @template {GeometryLike<Attribute>} Geometry
   * @param {Three<Attribute, Geometry>} THREE the namespace of three.js, or as much of it
   * @returns {Geometry}
   * @throws {TypeError} without the two classes
   */
  toThree(THREE) {
    return meshToThree(this, THREE);
  }
}

/**
 * Grid options, checked.
 *
 * @internal
 * @param {GridOptions} options
 * @returns {{ u: number, v: number, quads: boolean, differences: boolean, into: Mesh | undefined }}
 */
export function gridOptions(options) {
  const { segments, method = "bernstein", quads = false, into } = check.options(options);
  const { u, v } = segmentsOf(segments);
  const differences = check.oneOf(method, "method", METHODS) === "forward-difference";
  return { u, v, quads: Boolean(quads), differences, into: meshInto(into) };
}

/**
 * An earlier mesh to fill, or nothing.
 *
 * @internal
 * @param {unknown} into
 * @returns {Mesh | undefined}
 */
export function meshInto(into) {
  return into === undefined ? into : check.instanceOf(into, "into", Mesh);
}

/**
 * Segments along u and v, checked.
 *
 * @internal
 * @param {unknown} segments
 * @returns {{ u: number, v: number }}
 */
export function segmentsOf(segments) {
  const two = typeof segments === "object" && segments !== null;
  const { u, v } = /** @type {{ u: unknown, v: unknown }} */ (two ? segments : { u: segments, v: segments });
  return {
    u: check.segmentCount(u, two ? "segments.u" : "segments"),
    v: check.segmentCount(v, two ? "segments.v" : "segments"),
  };
}

/**
 * The mesh that the core left, in the arrays of an earlier one where they are large enough.
 *
 * @internal
 * @param {Mesh | undefined} into
 * @param {{ own?: boolean, precise?: boolean }} [kind] whether each patch has its own vertices; whether positions and
 *   normals are f64
 * @returns {Mesh}
 */
export function takeMesh(into, { own = true, precise = false } = {}) {
  const [positions, normals] = precise ? [PRECISE_POSITIONS, PRECISE_NORMALS] : [POSITIONS, NORMALS];
  const Real = /** @type {any} */ (precise ? Float64Array : Float32Array);
  const wide = core().mesh_length(positions) / 3 > 0x10000;
  /** @type {any} */
  const Indices = wide ? Uint32Array : Uint16Array;
  const data = {
    positions: /** @type {Float32Array | Float64Array} */ (read(positions, Real, into?.positions)),
    normals: /** @type {Float32Array | Float64Array} */ (read(normals, Real, into?.normals)),
    uvs: own ? read(UVS, Float32Array, into?.uvs) : null,
    patchIds: own ? read(PATCH_IDS, Uint32Array, into?.patchIds) : null,
    indices: /** @type {Uint16Array | Uint32Array} */ (read(INDICES, Indices, into?.indices)),
    quads: core().mesh_length(QUADS)
      ? /** @type {Uint16Array | Uint32Array} */ (read(QUADS, Indices, into?.quads))
      : undefined,
    patchRanges: ranges(into?.patchRanges ?? []),
  };
  if (data.positions.byteLength > LARGE_MESH) core().mesh_drop();
  return into ? Object.assign(into, data) : new Mesh(data);
}

/**
 * One buffer of the core's last mesh, copied.
 *
 * @template {Float32Array | Float64Array | Uint16Array | Uint32Array} T
 * @param {number} buffer
 * @param {new (length: number) => T} Type
 * @param {Float32Array | Float64Array | Uint16Array | Uint32Array | null | undefined} into
 * @returns {T}
 */
function read(buffer, Type, into) {
  const array = copy(buffer, room(Type, core().mesh_length(buffer), into));
  layouts.delete(array.buffer);
  return array;
}

/**
 * The earlier array if it is of that type and long enough, or the part of it that is needed; else a new one.
 *
 * @internal
 * @template {Float32Array | Float64Array | Uint16Array | Uint32Array} T
 * @param {new (length: number) => T} Type
 * @param {number} length
 * @param {Float32Array | Float64Array | Uint16Array | Uint32Array | null | undefined} earlier
 * @returns {T}
 */
export function room(Type, length, earlier) {
  const fits = earlier instanceof Type && earlier.length >= length;
  return /** @type {T} */ (
    fits ? (earlier.length === length ? earlier : earlier.subarray(0, length)) : new Type(length)
  );
}

/**
 * Copies a buffer of the core's last mesh to an array of exactly its length.
 *
 * @internal
 * @template {Float32Array | Float64Array | Uint16Array | Uint32Array} T
 * @param {number} buffer
 * @param {T} array
 * @returns {T}
 */
export function copy(buffer, array) {
  core().mesh_copy(buffer, array);
  return array;
}

/**
 * @param {PatchRange[]} into
 * @returns {PatchRange[]}
 */
function ranges(into) {
  const numbers = read(PATCH_RANGES, Uint32Array, undefined);
  into.length = numbers.length / 4;
  for (let k = 0; k < into.length; k++) {
    const [firstVertex, vertices, firstIndex, indices] = numbers.subarray(4 * k, 4 * k + 4);
    into[k] = { firstVertex, vertices, firstIndex, indices };
  }
  return into;
}
