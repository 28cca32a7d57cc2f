import * as check from "./check.js";
import { meshToOBJ } from "../io/obj.js";
import { meshToSTL } from "../io/stl.js";
import { meshToGLB } from "../io/glb.js";
import { meshToThree } from "../io/three.js";
import { core } from "../wasm/surfaces-transfer.js";

/**
 * @import { Three } from "../io/three.js"
 */

/**
 * The range of one patch in the arrays of a mesh.
 *
 * @typedef {object} PatchRange
 * @property {number} firstVertex the index of the first vertex
 * @property {number} vertices the number of vertices; 0 if patches share them
 * @property {number} firstIndex the position of the first index in `indices`
 * @property {number} indices the number of indices, three for each triangle
 */

/**
 * The options of a grid.
 *
 * @typedef {object} GridOptions
 * @property {number | { u: number, v: number }} segments the number of cells along u and v of a patch
 * @property {"bernstein" | "forward-difference"} [method] how samples are computed: by Bernstein polynomials (the
 *   default) or, for comparison and teaching, by forward differences along u, m additions per coordinate and step for
 *   degree m. The rounding errors of forward differences accumulate in f64, invisible in f32 up to a degree of about
 *   10, but shared edges may differ in the last bit
 * @property {boolean} [quads] whether to list the four-sided faces, too
 * @property {Mesh} [into] an earlier mesh whose arrays are reused if they are large enough. Positions and normals are
 *   always written; uvs, patchIds, indices and quads, which depend only on the counts, are not written again if they
 *   already belong to a grid with the same counts: changes that you made there remain
 */

/**
 * The buffers that hold uvs, patch indices or faces of a grid, with a key of the grid's layout: they need not be
 * written again for the same layout.
 *
 * @internal
 * @type {WeakMap<object, string>}
 */
export const gridLayouts = new WeakMap();

const GRID_OPTIONS = /** @type {const} */ (["segments", "method", "quads", "into"]);
const METHODS = /** @type {const} */ (["bernstein", "forward-difference"]);

/** The core releases the memory of a mesh with more bytes than this after it was read. */
export const LARGE_MESH = 1 << 24;

/** The core's indices of the buffers of a mesh. */
const POSITIONS = 0;
const NORMALS = 1;
const UVS = 2;
const PATCH_IDS = 3;
const INDICES = 4;
const QUADS = 5;
const PATCH_RANGES = 6;
const F64_POSITIONS = 7;
const F64_NORMALS = 8;

/**
 * A triangle mesh as plain arrays, ready for a GPU. Triangles are counter-clockwise as seen from the side to which ∂u ×
 * ∂v points.
 */
export class Mesh {
  /**
   * The mesh of the given arrays, which are not copied.
   *
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
    /** u, v of each vertex in its patch; null if patches share vertices. */
    this.uvs = uvs;
    /** The index of the patch of each vertex; null if patches share vertices. */
    this.patchIds = patchIds;
    /** Three vertex indices per triangle, in the smallest type that fits. */
    this.indices = indices;
    /** Four vertex indices per face, if they were requested. */
    this.quads = quads;
    /** The range of each patch in the arrays; with 0 vertices if patches share them. */
    this.patchRanges = patchRanges;
  }

  /**
   * See `brand.js`.
   *
   * @internal
   * @returns {"mesh"}
   */
  get casteljauType() {
    return "mesh";
  }

  /**
   * The text of a Wavefront OBJ file: positions, (u, v) if the mesh has uvs, normals; quads if the mesh has them,
   * otherwise triangles. Each number has the fewest digits that round-trip.
   *
   * @param {{ quads?: boolean }} [options] `quads: false` always writes triangles
   * @returns {string}
   * @throws {RangeError} for `quads: true` without quads, and if the arrays were changed and do not match
   */
  toOBJ(options) {
    return meshToOBJ(this, options);
  }

  /**
   * The bytes of a binary STL file: 84, and 50 for each triangle. The normals are computed from the corners by the
   * right-hand rule; those of degenerate triangles are zero. Positions in f64 are rounded to f32.
   *
   * @param {never[]} surplus
   * @returns {Uint8Array<ArrayBuffer>}
   * @throws {RangeError} above 1 GiB, for positions that overflow f32, and as `toOBJ`
   */
  toSTL(...surplus) {
    check.noSurplus(surplus, "toSTL", 0);
    return meshToSTL(this);
  }

  /**
   * The bytes of a self-contained binary glTF 2.0 file: one double-sided mesh with positions, normals, (u, v) if the
   * mesh has uvs, and indices. An empty mesh gives an empty scene. Numbers in f64 are rounded to f32; normals that are
   * zero become +z, because glTF does not allow them. In glTF, y points up: create the surface with `up: "y"`.
   *
   * @param {never[]} surplus
   * @returns {Uint8Array<ArrayBuffer>}
   * @throws {RangeError} as `toSTL`
   */
  toGLB(...surplus) {
    check.noSurplus(surplus, "toGLB", 0);
    return meshToGLB(this);
  }

  /**
   * A BufferGeometry of three.js with `position`, `normal`, `uv` if the mesh has uvs, and an index. It uses the arrays
   * of this mesh, not copies (except those in f64, which are converted to f32).
   *
   *     import * as THREE from "three";
   *     const geometry = Surface.teapot({ up: "y" }).tessellate({ tolerance: 0.01 }).toThree(THREE);
   *
   * @template {{ new (): any, prototype: any }} GeometryClass
   * @param {Three<GeometryClass>} THREE the namespace of three.js, or an object with its BufferGeometry and
   *   BufferAttribute
   * @returns {GeometryClass["prototype"]}
   * @throws {TypeError} if one of the two classes is missing
   */
  toThree(THREE) {
    return meshToThree(this, THREE);
  }
}

/**
 * Checks the options of a grid.
 *
 * @internal
 * @param {GridOptions} options
 * @returns {{ u: number, v: number, quads: boolean, differences: boolean, into: Mesh | undefined }}
 */
export function gridOptions(options) {
  const { segments, method = "bernstein", quads, into } = check.options(options, GRID_OPTIONS);
  const { u, v } = segmentsOf(segments);
  const differences = check.oneOf(method, "method", METHODS) === "forward-difference";
  return { u, v, quads: check.optionalBoolean(quads, "quads"), differences, into: meshInto(into) };
}

/**
 * Checks the option `into`: an earlier mesh or undefined.
 *
 * @internal
 * @param {unknown} into
 * @returns {Mesh | undefined}
 */
export function meshInto(into) {
  return into === undefined ? into : check.instanceOf(into, "into", Mesh, "a Mesh");
}

/**
 * Checks the option `segments`.
 *
 * @internal
 * @param {unknown} segments
 * @returns {{ u: number, v: number }}
 */
export function segmentsOf(segments) {
  const isPair = typeof segments === "object" && segments !== null;
  const { u, v } = /** @type {{ u: unknown, v: unknown }} */ (isPair ? segments : { u: segments, v: segments });
  return {
    u: check.segmentCount(u, isPair ? "segments.u" : "segments"),
    v: check.segmentCount(v, isPair ? "segments.v" : "segments"),
  };
}

/**
 * Reads the last mesh of the core, to the arrays of an earlier mesh if they are large enough.
 *
 * @internal
 * @param {Mesh | undefined} into
 * @param {{ separatePatches?: boolean, isF64?: boolean }} [kind] whether each patch has vertices of its own; whether
 *   positions and normals are f64
 * @returns {Mesh}
 */
export function readMesh(into, { separatePatches = true, isF64 = false } = {}) {
  const [positions, normals] = isF64 ? [F64_POSITIONS, F64_NORMALS] : [POSITIONS, NORMALS];
  const Real = /** @type {any} */ (isF64 ? Float64Array : Float32Array);
  const wide = core().mesh_length(positions) / 3 > 0x10000;
  /** @type {any} */
  const Indices = wide ? Uint32Array : Uint16Array;
  const data = {
    positions: /** @type {Float32Array | Float64Array} */ (readBuffer(positions, Real, into?.positions)),
    normals: /** @type {Float32Array | Float64Array} */ (readBuffer(normals, Real, into?.normals)),
    uvs: separatePatches ? readBuffer(UVS, Float32Array, into?.uvs) : null,
    patchIds: separatePatches ? readBuffer(PATCH_IDS, Uint32Array, into?.patchIds) : null,
    indices: /** @type {Uint16Array | Uint32Array} */ (readBuffer(INDICES, Indices, into?.indices)),
    quads: core().mesh_length(QUADS)
      ? /** @type {Uint16Array | Uint32Array} */ (readBuffer(QUADS, Indices, into?.quads))
      : undefined,
    patchRanges: readPatchRanges(into?.patchRanges ?? []),
  };
  if (data.positions.byteLength > LARGE_MESH) core().mesh_drop();
  return into ? Object.assign(into, data) : new Mesh(data);
}

/**
 * Copies one buffer of the core's last mesh.
 *
 * @template {Float32Array | Float64Array | Uint16Array | Uint32Array} T
 * @param {number} buffer
 * @param {new (length: number) => T} Type
 * @param {Float32Array | Float64Array | Uint16Array | Uint32Array | null | undefined} into
 * @returns {T}
 */
function readBuffer(buffer, Type, into) {
  const array = copyBuffer(buffer, reuseOrAllocate(Type, core().mesh_length(buffer), into));
  gridLayouts.delete(array.buffer);
  return array;
}

/**
 * The earlier array if it has the type and is long enough (or its first part, if it is longer), otherwise a new array.
 *
 * @internal
 * @template {Float32Array | Float64Array | Uint16Array | Uint32Array} T
 * @param {new (length: number) => T} Type
 * @param {number} length
 * @param {Float32Array | Float64Array | Uint16Array | Uint32Array | null | undefined} earlier
 * @returns {T}
 */
export function reuseOrAllocate(Type, length, earlier) {
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
export function copyBuffer(buffer, array) {
  core().mesh_copy(buffer, array);
  return array;
}

/**
 * @param {PatchRange[]} into
 * @returns {PatchRange[]}
 */
function readPatchRanges(into) {
  const numbers = readBuffer(PATCH_RANGES, Uint32Array, undefined);
  into.length = numbers.length / 4;
  for (let k = 0; k < into.length; k++) {
    const [firstVertex, vertices, firstIndex, indices] = numbers.subarray(4 * k, 4 * k + 4);
    into[k] = { firstVertex, vertices, firstIndex, indices };
  }
  return into;
}
