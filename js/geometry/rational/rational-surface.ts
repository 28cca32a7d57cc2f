import { checkedData, fromChecked } from "../checked.js";
import { surfacesModule } from "../../wasm/surfaces-module.js";
import * as check from "../check.js";
import { parseRationalSurface, rationalSurfaceText } from "../../io/rational-surface-text.js";
import { patchData, rationalPatchData, rationalSurfaceData, requireJSON, surfaceData, typeOf } from "../brand.js";
import { showInNode } from "../inspected.js";
import { meshInto, readMesh, segmentsOf } from "../mesh.js";
import { boxAt, writePoint } from "../points.js";
import { joinedOf } from "../surface/network.js";
import { coordinatesOf, projectionNumbers, readPoints } from "../surface-queries.js";
import { checkedNetwork, networkJSON, networkOfJSON, networkOfNets } from "../surface-network.js";
import { tessellation } from "../tessellation.js";
import { readTopology } from "../topology.js";
import { linesOf, wireframeArguments } from "../wireframe.js";
import { checkedWeights, rationalCurveOf } from "./rational-curve.js";
import { rationalPatchOf, transformed } from "./rational-patch.js";
import { writeTurning } from "./sections.js";
import type { PatchData, RationalSurfaceData } from "../brand.js";
import type { MatrixLike, PointLike, PointsLike, TransformLike } from "../check.js";
import type { GridOptions, Mesh } from "../mesh.js";
import type { CorePatch } from "../patch/core-patch.js";
import type { Bounds } from "../points.js";
import type { SurfacePoint } from "../surface-queries.js";
import type { CoreSurface } from "../surface/core-surface.js";
import type { SurfaceJSON } from "../surface-network.js";
import type { TessellationOptions } from "../tessellation.js";
import type { Topology } from "../topology.js";
import type { WireframeOptions } from "../wireframe.js";
import type { RationalCurve } from "./rational-curve.js";
import type { RationalPatch } from "./rational-patch.js";
import type { SectionLike, TurningOptions } from "./sections.js";

/** Whether Node knows how to show the instances. */
let isShown = false;

/** What `RationalSurface.toJSON` returns; `RationalSurface.fromJSON` also reads other forms of points. */
export interface RationalSurfaceJSON extends SurfaceJSON {
  /** For each patch a weight for each of its vertex indices */
  weights: ArrayLike<ArrayLike<number>>;
}

/** What a surface of rational patches is made of. */
export interface RationalSurfaceOptions {
  vertices: PointsLike;
  /** For each patch its (degreeU + 1)·(degreeV + 1) vertex indices, u along the fast index */
  patches: ArrayLike<ArrayLike<number>>;
  /** For each patch a weight for each of its vertex indices, from 2^-500 to 2^500; all 1 by default */
  weights?: ArrayLike<ArrayLike<number>>;
}

/**
 * A network of rational Bézier patches that share control points: a `Surface` with a weight for each index of each patch.
 *
 *     const sphere = NurbsSurface.sphere([0, 0, 0], 1).toSurface();
 *     const mesh = sphere.tessellate({ tolerance: 0.01 });
 *
 * Weights belong to patches: patches that share a vertex may have different weights there, as at the pole of a sphere, and a
 * common factor of all weights of a patch changes nothing. Surfaces are immutable: every change returns a new one.
 */
export class RationalSurface {
  #data: RationalSurfaceData;
  /** For each patch the start of its indices, and at last their number */
  #starts: Uint32Array;

  /**
   * The surface of patches of the same degrees, whose control points are given as indices into a list of vertices.
   *
   * @param data `vertices`, `patches` and `weights`
   * @param options `degreeU`: 3 by default; `degreeV`: 3 by default
   * @throws {RangeError} for an index without a vertex, a wrong count, a NaN or an infinity, and for a weight that is not above 0
   */
  constructor(data: RationalSurfaceOptions, options?: { degreeU?: number; degreeV?: number }) {
    if (!isShown) show();
    this.#data = checkedData<RationalSurfaceData>(data) ?? dataOf(data, options);
    this.#starts = startsOf(this.#data.degrees);
  }

  /** A copy of the coordinates of the vertices. */
  get vertices() {
    return this.#data.vertices.slice();
  }

  /** For each patch a copy of the vertex indices of its control points. */
  get patches() {
    return this.#ofPatches(this.#data.indices);
  }

  /** The number of patches. */
  get patchCount() {
    return this.#data.degrees.length / 2;
  }

  /**
   * @returns for each patch a copy of the weights of its vertex indices
   */
  weights(): Float64Array[] {
    return this.#ofPatches(this.#data.weights);
  }

  #ofPatches<T extends Float64Array | Uint32Array>(all: T): T[] {
    return Array.from({ length: this.patchCount }, (_, k) => all.slice(this.#starts[k], this.#starts[k + 1]) as T);
  }

  /**
   * One patch.
   *
   * @param k the number of the patch, from 0
   */
  patch(k: number): RationalPatch {
    check.whole(k, "patch", 0, this.patchCount - 1);
    const { vertices, degrees, indices, weights } = this.#data;
    const [from, to] = [this.#starts[k], this.#starts[k + 1]];
    const numbers = new Float64Array(4 * (to - from));
    indices.subarray(from, to).forEach((index, i) => numbers.set(vertices.subarray(3 * index, 3 * index + 3), 3 * i));
    numbers.set(weights.subarray(from, to), 3 * (to - from));
    return rationalPatchOf(numbers, degrees[2 * k], degrees[2 * k + 1]);
  }

  /**
   * The surface with one vertex moved, together with all vertices that had the same position when the surface was
   * created; see `Surface.movePoint`.
   *
   * @param index the number of the vertex, from 0
   * @param to the new position
   */
  movePoint(index: number, to: PointLike): RationalSurface {
    const { joined } = this.#data;
    if (joined.length === 0) throw new RangeError("vertices: expected at least 1, got 0");
    check.whole(index, "index", 0, joined.length - 1);
    const vertices = this.vertices;
    writePoint(vertices, 3 * index, to, 3, "to");
    const moved = vertices.slice(3 * index, 3 * index + 3);
    joined.forEach((first, k) => {
      if (first === joined[index]) vertices.set(moved, 3 * k);
    });
    return surfaceOf({ ...this.#data, vertices });
  }

  /**
   * The surface transformed by an affine map, with the same weights.
   *
   * @param matrix a matrix, or a text such as "translate(50 50) rotate(30)"
   * @throws {RangeError} for an image with a coordinate beyond 2^500
   */
  transform(matrix: TransformLike): RationalSurface {
    return surfaceOf({ ...this.#data, vertices: transformed(this.#data.vertices, matrix) });
  }

  /**
   * The vertices and, for each patch, its vertex indices, degrees and weights. Vertices which have been moved to the same
   * position are joined in the surface that `fromJSON` returns.
   */
  toJSON(): { vertices: number[][]; patches: number[][]; degrees: number[][]; weights: number[][] } {
    const weights = this.weights().map((numbers) => [...numbers]);
    return { ...networkJSON(this.#data, this.patches), weights };
  }

  /**
   * The surface as text in the format of `Surface.toText`, from which `parse` creates an equal surface. The net of a patch whose
   * weights are not all 1 is followed by rows of the letter w and the weights of a row of the net.
   */
  toText(): string {
    return rationalSurfaceText(this.#data);
  }

  /**
   * See `brand.js`.
   *
   * @internal
   */
  get casteljauType(): "rationalsurface" {
    return "rationalsurface";
  }

  /**
   * See `brand.js`.
   *
   * @internal
   */
  casteljauData(): RationalSurfaceData {
    return this.#data;
  }

  /** Writes the surface, and then further numbers, to the arena. */
  #write(further: ArrayLike<number> = []) {
    const { vertices, degrees, indices, joined, weights } = this.#data;
    const lists = [degrees, vertices, indices, joined, weights, further];
    const counts = Float64Array.of(vertices.length / 3, degrees.length / 2, joined.length);
    const length = lists.reduce((sum, list) => sum + list.length, 0);
    const view = surfacesModule.write(counts, length);
    let at = counts.length;
    for (const list of lists) {
      view.set(list, at);
      at += list.length;
    }
  }

  /**
   * How the patches are joined. Two edges are the same line if their control points are equal in the same order or reversed and
   * the quotients of their weights are equal to 512 ulps; edges with the same points and other weights are open. An edge that is
   * a point is collapsed, whatever its weights.
   */
  topology(): Topology {
    this.#write();
    return readTopology(surfacesModule.read(0, surfacesModule.functions.rationalsurface_topology()));
  }

  /** The smallest box that contains the surface, exact up to rounding; null without patches. */
  bounds(): Bounds<3> | null {
    this.#write();
    const numbers = surfacesModule.read(0, surfacesModule.functions.rationalsurface_bounds());
    return numbers.length ? boxAt(numbers, 3) : null;
  }

  /** The total area of all patches; regions that a patch covers twice count twice. */
  area(): number {
    this.#write();
    return surfacesModule.read(0, surfacesModule.functions.rationalsurface_area())[0];
  }

  /**
   * The volume that a closed surface encloses; null if there is an open edge or an edge that three patches share. It is
   * positive if the normals point outwards; if neighbours disagree, the first patch of each component decides.
   */
  volume(): number | null {
    this.#write();
    return surfacesModule.read(0, surfacesModule.functions.rationalsurface_volume())[0] ?? null;
  }

  /**
   * The point of the surface that is nearest to p; null without patches. See `Surface.nearest`.
   *
   * @param p the point, in the unit of the points
   */
  nearest(p: PointLike): SurfacePoint | null {
    const [coordinates] = coordinatesOf([p, "p"]);
    this.#write(coordinates);
    return readPoints(surfacesModule.read(0, surfacesModule.functions.rationalsurface_nearest()))[0] ?? null;
  }

  /**
   * All intersections with a ray, sorted by distance; see `Surface.intersectRay`.
   *
   * @param origin the start of the ray
   * @param direction the direction of the ray, of any length above 0
   * @throws {RangeError} for a direction of length 0, and if the search in a patch takes too many steps
   */
  intersectRay(origin: PointLike, direction: PointLike): SurfacePoint[] {
    const [start, along] = coordinatesOf([origin, "origin"], [direction, "direction"]);
    this.#write([...start, ...along]);
    return readPoints(surfacesModule.read(0, surfacesModule.functions.rationalsurface_ray()));
  }

  /**
   * A mesh without cracks and T-junctions; see `Surface.tessellate`, whose promises hold.
   *
   *     const mesh = NurbsSurface.torus([0, 0, 0], 2, 1).toSurface().tessellate({ tolerance: 0.01 });
   *
   * @throws {RangeError} as there, and with `tolerance` or `pixels` for a patch whose largest weight is more than 2²⁰ times its
   *   smallest one
   */
  tessellate(options: TessellationOptions): Mesh {
    const { args, extra, into, ...kind } = tessellation(options);
    this.#write(extra);
    surfacesModule.count(surfacesModule.functions.rationalsurface_tessellate(...args));
    return readMesh(into, kind);
  }

  /**
   * A mesh of one grid of samples per patch; see `Surface.grid`. Normals are exact, also at collapsed edges.
   *
   * @param options `segments`: cells of every patch along u and v; `quads`: whether the mesh has quads, too; `into`: an earlier mesh
   */
  grid(options: Omit<GridOptions, "method">): Mesh {
    const { segments, quads, into } = check.options(options, ["segments", "quads", "into"]);
    const { u, v } = segmentsOf(segments);
    const earlier = meshInto(into);
    const withQuads = check.optionalBoolean(quads, "quads");
    this.#write();
    surfacesModule.count(surfacesModule.functions.rationalsurface_grid(u, v, withQuads));
    return readMesh(earlier);
  }

  /**
   * The isocurves that divide every patch into `lines` strips in each direction (4 by default), edges included; see
   * `Surface.isocurves`.
   *
   * @param options `lines`: how many strips, 4 by default
   * @throws {RangeError} for 0 lines and above 1 GiB
   */
  isocurves(options?: { lines?: number }): RationalCurve<3>[] {
    const lines = linesOf(options);
    this.#write();
    const numbers = surfacesModule.read(0, surfacesModule.functions.rationalsurface_isocurves(lines));
    surfacesModule.release();
    const curves: RationalCurve<3>[] = [];
    for (let at = 0; at < numbers.length; ) {
      const weights = at + 1 + 3 * numbers[at];
      const end = weights + numbers[at];
      const flat = numbers.slice(at + 1, weights);
      curves.push(rationalCurveOf({ flat, dimension: 3 }, numbers.slice(weights, end)) as RationalCurve<3>);
      at = end;
    }
    return curves;
  }

  /**
   * A mesh of the isocurves: tubes, or ribbons that lie in the surface; see `Surface.wireframe`.
   *
   * @throws {TypeError} for neither radius nor width, and for both
   * @throws {RangeError} for a radius or a width below the precision of f32, and above 1 GiB
   */
  wireframe(options: WireframeOptions): Mesh {
    const { args, into } = wireframeArguments(options);
    this.#write();
    surfacesModule.count(surfacesModule.functions.rationalsurface_wireframe(...args));
    return readMesh(into, { separatePatches: false });
  }

  /**
   * Draws the projected isocurves of all patches on a canvas context or a Path2D; see `Surface.trace`. Curves whose weights
   * differ are replaced by cubics within the tolerance.
   *
   * @param target a canvas context or a Path2D
   * @param options `matrix`: maps the surface's coordinates to pixels, 16 numbers column-major; `lines`: the number of strips per
   *   patch in each direction, 4 by default; `tolerance`: in pixels, 0.1 by default
   */
  trace(
    target: CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D | Path2D,
    options: { matrix: MatrixLike; lines?: number; tolerance?: number },
  ) {
    const sink = check.drawingTarget(target);
    const { matrix, tolerance, ...others } = check.options(options, ["matrix", "lines", "tolerance"]);
    const m = projectionNumbers(matrix as MatrixLike);
    const lines = linesOf(others);
    const tolerancePx = check.optionalTolerance(tolerance);
    this.#write(m);
    surfacesModule.count(surfacesModule.functions.rationalsurface_trace(sink, lines, tolerancePx));
  }

  /**
   * A surface with the weights 1, or a rational surface itself.
   *
   * @param surface of any entry point
   */
  static from(surface: CoreSurface | RationalSurface): RationalSurface {
    if (typeOf(surface) === "rationalsurface") return surfaceOf(rationalSurfaceData(surface, "surface"));
    const network = surfaceData(surface, "surface");
    return surfaceOf({ ...network, weights: new Float64Array(network.indices.length).fill(1) });
  }

  /**
   * The surface of patches, which may differ in their degrees; patches without weights have the weights 1. Control points at the
   * same position become one vertex. The order of the patches is kept.
   *
   * Open edges with the same vertices are one curve with two parameters if the quotients of their weights are c·ρⁱ, as they always are for
   * degree 1. The weights of the later patch are then multiplied by ρ⁻ⁱ along that direction, and so on for the patches beside it: its
   * points stay the same, t′/(1 − t′) = ρ t/(1 − t), and meshes have no cracks there. Where a closed chain of patches needs two factors,
   * edges stay open; so they do where the largest weight of a patch would be more than 2²⁰ times its smallest one.
   *
   * @param patches patches of any degrees
   */
  static fromPatches(patches: readonly (RationalPatch | CorePatch)[]): RationalSurface {
    if (!Array.isArray(patches)) throw new TypeError(`patches: expected an array, got ${check.describe(patches)}`);
    const surface = surfaceOfPatches(Array.from(patches, patchWithWeights)); // also finds holes
    surface.#write();
    const count = surfacesModule.functions.rationalsurface_common_parameters();
    return surfaceOf({ ...surface.#data, weights: surfacesModule.readLarge(count) });
  }

  /**
   * The solid that a profile sweeps over when it turns around an axis: `NurbsSurface.revolve` with caps.
   *
   *     const bowl = RationalSurface.solidOfRevolution(new Curve([[1, 0, 0], [3, 0, 1], [1, 0, 3]]), { angle: 4 });
   *
   * An end of an open profile that is not on the axis has a disk, or a sector of it. After less than a full turn there are also two
   * caps between the profile and the axis, or the centroid of a profile that ends where it starts. All edges are shared by two
   * patches, and the normals point outwards.
   *
   * @param profile a curve of any kind; one of the plane lies in z = 0
   * @param options `origin`: a point of the axis, by default [0, 0, 0]; `axis`: its direction, by default [0, 0, 1]; `angle`: in
   *   radians, by default a full turn
   * @throws {RangeError} as `NurbsSurface.revolve`; for less than a full turn of a profile that turns back along the axis, or around
   *   its centroid if it ends where it starts; for a profile so small, beside its distance from the axis, that rounding leaves open
   *   edges
   */
  static solidOfRevolution(profile: SectionLike, options?: TurningOptions): RationalSurface {
    const angle = writeTurning(profile, options);
    const numbers = surfacesModule.read(0, surfacesModule.functions.rationalsurface_solid_of_revolution(angle));
    const patches: WeightedPatch[] = [];
    for (let at = 0; at < numbers.length; ) {
      const [degreeU, degreeV] = numbers.subarray(at, at + 2);
      const weights = at + 2 + 3 * (degreeU + 1) * (degreeV + 1);
      const end = weights + (degreeU + 1) * (degreeV + 1);
      patches.push({ flat: numbers.slice(at + 2, weights), degreeU, degreeV, weights: numbers.slice(weights, end) });
      at = end;
    }
    return surfaceOfPatches(patches);
  }

  /**
   * Parses the text of `toText`, or one that `Surface.parse` reads; weights are 1 where there are none.
   *
   * @param text the text
   * @throws {RangeError} for a syntax error, with the line number, what was expected and what the text contains
   */
  static parse(text: string): RationalSurface {
    if (typeof text !== "string") throw new TypeError(`text: expected a string, got ${check.describe(text)}`);
    return surfaceOf(parseRationalSurface(text, joinedOf));
  }

  /**
   * The surface that `toJSON` described.
   *
   * @param json what `toJSON` returned
   */
  static fromJSON(json: RationalSurfaceJSON): RationalSurface {
    const network = networkOfJSON(json, joinedOf);
    requireJSON(json, "vertices, patches and weights", ({ weights }) => weights !== undefined);
    return surfaceOf({ ...network, weights: weightsOf(json.weights, network.degrees) });
  }
}

/** Outside of the class, so that it does not refer to itself; see `markClassNames` in xtask/bundle.js. */
function show() {
  isShown = showInNode(RationalSurface.prototype, "RationalSurface", (surface) => ({
    patches: surface.patchCount,
    vertices: surface.casteljauData().vertices.length / 3,
  }));
}

// Outside of the class, see ../curve/core-curve.js.
function surfaceOf(data: RationalSurfaceData): RationalSurface {
  return fromChecked(RationalSurface, data);
}

type WeightedPatch = PatchData & { weights: Float64Array };

/**
 * The surface of patches: control points at the same position become one vertex.
 *
 * @internal
 */
export function surfaceOfPatches(patches: WeightedPatch[]): RationalSurface {
  const weights = new Float64Array(patches.reduce((sum, patch) => sum + patch.weights.length, 0));
  let at = 0;
  for (const patch of patches) {
    weights.set(patch.weights, at);
    at += patch.weights.length;
  }
  return surfaceOf({ ...networkOfNets(patches, joinedOf), weights });
}

function patchWithWeights(patch: unknown, k: number): WeightedPatch {
  const name = `patches[${k}]`;
  if (typeOf(patch) === "rationalpatch") return rationalPatchData(patch, name);
  const data = patchData(patch, name);
  return { ...data, weights: new Float64Array(data.flat.length / 3).fill(1) };
}

function startsOf(degrees: number[]): Uint32Array {
  const starts = new Uint32Array(degrees.length / 2 + 1);
  for (let k = 0; 2 * k < degrees.length; k++) {
    starts[k + 1] = starts[k] + (degrees[2 * k] + 1) * (degrees[2 * k + 1] + 1);
  }
  return starts;
}

function dataOf(
  data: RationalSurfaceOptions,
  options: { degreeU?: number; degreeV?: number } | undefined,
): RationalSurfaceData {
  const network = checkedNetwork(data, options, joinedOf);
  if (data.weights !== undefined) return { ...network, weights: weightsOf(data.weights, network.degrees) };
  return { ...network, weights: new Float64Array(network.indices.length).fill(1) };
}

/** The weights of all patches, checked. */
function weightsOf(lists: unknown, degrees: number[]): Float64Array {
  if (!Array.isArray(lists)) throw new TypeError(`weights: expected an array, got ${check.describe(lists)}`);
  const patches = degrees.length / 2;
  if (lists.length !== patches) {
    throw new RangeError(`weights: expected ${patches} lists, one for each patch, got ${lists.length}`);
  }
  const starts = startsOf(degrees);
  const all = new Float64Array(starts[patches]);
  for (let k = 0; k < patches; k++) {
    all.set(checkedWeights(lists[k], starts[k + 1] - starts[k], `weights[${k}]`), starts[k]);
  }
  return all;
}
