import { surfacesModule } from "../wasm/surfaces-module.js";
import * as check from "./check.js";
import { showInNode } from "./inspected.js";
import { meshToOBJ } from "../io/obj.js";
import { meshToSTL } from "../io/stl.js";
import { meshToGLB } from "../io/glb.js";
import { meshToThree } from "../io/three.js";
import type { Three } from "../io/three.js";

/** The range of one patch in the arrays of a mesh. */
export interface PatchRange {
  /** The index of the first vertex */
  firstVertex: number;
  /** The number of vertices; 0 if patches share them */
  vertices: number;
  /** The position of the first index in `indices` */
  firstIndex: number;
  /** The number of indices, three for each triangle */
  indices: number;
}

/** The options of a grid. */
export interface GridOptions {
  /** The number of cells along u and v of a patch */
  segments: number | { u: number; v: number };
  /**
   * How samples are computed: by Bernstein polynomials (the default) or, for comparison and teaching, by forward
   * differences along u, m additions per coordinate and step for degree m. The rounding errors of forward differences
   * accumulate in f64, invisible in f32 up to a degree of about 10, but shared edges may differ in the last bit
   */
  method?: "bernstein" | "forward-difference";
  /** Whether to list the four-sided faces, too */
  quads?: boolean;
  /**
   * An earlier mesh whose arrays are reused if they are large enough. Positions and normals are
   * always written; uvs, patchIds, indices and quads, which depend only on the counts, are not written again if they
   * already belong to a grid with the same counts: changes that you made there remain
   */
  into?: Mesh;
}

/**
 * The buffers that hold uvs, patch indices or faces of a grid, with a key of the grid's layout: they need not be
 * written again for the same layout.
 *
 * @internal
 */
export const gridLayouts: WeakMap<object, string> = new WeakMap();

const GRID_OPTIONS = ["segments", "method", "quads", "into"] as const;
const METHODS = ["bernstein", "forward-difference"] as const;

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

/** Whether Node knows how to show the instances. */
let isShown = false;

/**
 * A triangle mesh as plain arrays, ready for a GPU. Triangles are counter-clockwise as seen from the side to which ∂u ×
 * ∂v points.
 */
export class Mesh {
  /** x, y, z of each vertex. */
  positions: Float32Array<ArrayBufferLike> | Float64Array<ArrayBufferLike>;
  /** The unit normal of each vertex. */
  normals: Float32Array<ArrayBufferLike> | Float64Array<ArrayBufferLike>;
  /** u, v of each vertex in its patch; null if patches share vertices. */
  uvs: Float32Array<ArrayBufferLike> | null;
  /** The index of the patch of each vertex; null if patches share vertices. */
  patchIds: Uint32Array<ArrayBufferLike> | null;
  /** Three vertex indices per triangle, in the smallest type that fits. */
  indices: Uint32Array<ArrayBufferLike> | Uint16Array<ArrayBufferLike>;
  /** Four vertex indices per face, if they were requested. */
  quads: Uint32Array<ArrayBufferLike> | Uint16Array<ArrayBufferLike> | undefined;
  /** The range of each patch in the arrays; with 0 vertices if patches share them. */
  patchRanges: PatchRange[];

  /** The mesh of the given arrays, which are not copied. */
  constructor({
    positions,
    normals,
    uvs,
    patchIds,
    indices,
    quads,
    patchRanges,
  }: {
    positions: Float32Array | Float64Array;
    normals: Float32Array | Float64Array;
    uvs: Float32Array | null;
    patchIds: Uint32Array | null;
    indices: Uint16Array | Uint32Array;
    quads?: Uint16Array | Uint32Array;
    patchRanges: PatchRange[];
  }) {
    if (!isShown) show();
    this.positions = positions;
    this.normals = normals;
    this.uvs = uvs;
    this.patchIds = patchIds;
    this.indices = indices;
    this.quads = quads;
    this.patchRanges = patchRanges;
  }

  /**
   * See `brand.js`.
   *
   * @internal
   */
  get casteljauType(): "mesh" {
    return "mesh";
  }

  /**
   * The text of a Wavefront OBJ file: positions, (u, v) if the mesh has uvs, normals; quads if the mesh has them,
   * otherwise triangles. Each number has the fewest digits that round-trip.
   *
   * @param options `quads: false` always writes triangles
   * @throws {RangeError} for `quads: true` without quads, and if the arrays were changed and do not match
   */
  toOBJ(options?: { quads?: boolean }): string {
    return meshToOBJ(this, options);
  }

  /**
   * The bytes of a binary STL file: 84, and 50 for each triangle. The normals are computed from the corners by the
   * right-hand rule; those of degenerate triangles are zero. Positions in f64 are rounded to f32.
   *
   * @throws {RangeError} above 1 GiB, for positions that overflow f32, and as `toOBJ`
   */
  toSTL(): Uint8Array<ArrayBuffer> {
    return meshToSTL(this);
  }

  /**
   * The bytes of a self-contained binary glTF 2.0 file: one double-sided mesh with positions, normals, (u, v) if the
   * mesh has uvs, and indices. An empty mesh gives an empty scene. Numbers in f64 are rounded to f32; normals that are
   * zero become +z, because glTF does not allow them. In glTF, y points up: create the surface with `up: "y"`.
   *
   * @throws {RangeError} as `toSTL`
   */
  toGLB(): Uint8Array<ArrayBuffer> {
    return meshToGLB(this);
  }

  /**
   * A BufferGeometry of three.js with `position`, `normal`, `uv` if the mesh has uvs, and an index. It uses the arrays
   * of this mesh, not copies (except those in f64, which are converted to f32).
   *
   *     import * as THREE from "three";
   *     const geometry = Surface.teapot({ up: "y" }).tessellate({ tolerance: 0.01 }).toThree(THREE);
   *
   * @param THREE the namespace of three.js, or an object with its BufferGeometry and BufferAttribute
   * @throws {TypeError} if one of the two classes is missing
   */
  toThree<GeometryClass extends { new (): any; prototype: any }>(
    THREE: Three<GeometryClass>,
  ): GeometryClass["prototype"] {
    return meshToThree(this, THREE);
  }
}

/**
 * Checks the options of a grid.
 *
 * @internal
 */
export function gridOptions(options: GridOptions): {
  u: number;
  v: number;
  quads: boolean;
  differences: boolean;
  into: Mesh | undefined;
} {
  const { segments, method = "bernstein", quads, into } = check.options(options, GRID_OPTIONS);
  const { u, v } = segmentsOf(segments);
  const differences = check.oneOf(method, "method", METHODS) === "forward-difference";
  return { u, v, quads: check.optionalBoolean(quads, "quads"), differences, into: meshInto(into) };
}

/**
 * Checks the option `into`: an earlier mesh or undefined.
 *
 * @internal
 */
export function meshInto(into: unknown): Mesh | undefined {
  return into === undefined ? into : check.instanceOf(into, "into", Mesh, "a Mesh");
}

/**
 * Checks the option `segments`.
 *
 * @internal
 */
export function segmentsOf(segments: unknown): { u: number; v: number } {
  const isPair = typeof segments === "object" && segments !== null;
  const { u, v } = (isPair ? segments : { u: segments, v: segments }) as { u: unknown; v: unknown };
  return {
    u: check.segmentCount(u, isPair ? "segments.u" : "segments"),
    v: check.segmentCount(v, isPair ? "segments.v" : "segments"),
  };
}

/**
 * Reads the last mesh of the core, to the arrays of an earlier mesh if they are large enough.
 *
 * @internal
 * @param kind whether each patch has vertices of its own; whether positions and normals are f64
 */
export function readMesh(
  into: Mesh | undefined,
  { separatePatches = true, isF64 = false }: { separatePatches?: boolean; isF64?: boolean } = {},
): Mesh {
  const [positions, normals] = isF64 ? [F64_POSITIONS, F64_NORMALS] : [POSITIONS, NORMALS];
  const Real = (isF64 ? Float64Array : Float32Array) as any;
  const wide = surfacesModule.functions.mesh_length(positions) / 3 > 0x10000;
  const Indices: any = wide ? Uint32Array : Uint16Array;
  const data = {
    positions: readBuffer(positions, Real, into?.positions) as Float32Array | Float64Array,
    normals: readBuffer(normals, Real, into?.normals) as Float32Array | Float64Array,
    uvs: separatePatches ? readBuffer(UVS, Float32Array, into?.uvs) : null,
    patchIds: separatePatches ? readBuffer(PATCH_IDS, Uint32Array, into?.patchIds) : null,
    indices: readBuffer(INDICES, Indices, into?.indices) as Uint16Array | Uint32Array,
    quads: surfacesModule.functions.mesh_length(QUADS)
      ? (readBuffer(QUADS, Indices, into?.quads) as Uint16Array | Uint32Array)
      : undefined,
    patchRanges: readPatchRanges(into?.patchRanges ?? []),
  };
  if (data.positions.byteLength > LARGE_MESH) surfacesModule.functions.mesh_drop();
  return into ? Object.assign(into, data) : new Mesh(data);
}

/** Copies one buffer of the core's last mesh. */
function readBuffer<T extends Float32Array | Float64Array | Uint16Array | Uint32Array>(
  buffer: number,
  Type: new (length: number) => T,
  into: Float32Array | Float64Array | Uint16Array | Uint32Array | null | undefined,
): T {
  const array = copyBuffer(buffer, reuseOrAllocate(Type, surfacesModule.functions.mesh_length(buffer), into));
  gridLayouts.delete(array.buffer);
  return array;
}

/**
 * The earlier array if it has the type and is long enough (or its first part, if it is longer), otherwise a new array.
 *
 * @internal
 */
export function reuseOrAllocate<T extends Float32Array | Float64Array | Uint16Array | Uint32Array>(
  Type: new (length: number) => T,
  length: number,
  earlier: Float32Array | Float64Array | Uint16Array | Uint32Array | null | undefined,
): T {
  const fits = earlier instanceof Type && earlier.length >= length;
  return (fits ? (earlier.length === length ? earlier : earlier.subarray(0, length)) : new Type(length)) as T;
}

/**
 * Copies a buffer of the core's last mesh to an array of exactly its length.
 *
 * @internal
 */
export function copyBuffer<T extends Float32Array | Float64Array | Uint16Array | Uint32Array>(
  buffer: number,
  array: T,
): T {
  surfacesModule.functions.mesh_copy(buffer, array);
  return array;
}

/** Outside of the class, so that it does not refer to itself; see `markClassNames` in xtask/bundle.js. */
function show() {
  isShown = showInNode(Mesh.prototype, "Mesh", counts);
}

/** What Node's console shows of a mesh. */
function counts({ positions, indices, patchRanges }: Mesh) {
  return { vertices: positions.length / 3, triangles: indices.length / 3, patches: patchRanges.length };
}

function readPatchRanges(into: PatchRange[]): PatchRange[] {
  const numbers = readBuffer(PATCH_RANGES, Uint32Array, undefined);
  into.length = numbers.length / 4;
  for (let k = 0; k < into.length; k++) {
    const [firstVertex, vertices, firstIndex, indices] = numbers.subarray(4 * k, 4 * k + 4);
    into[k] = { firstVertex, vertices, firstIndex, indices };
  }
  return into;
}
