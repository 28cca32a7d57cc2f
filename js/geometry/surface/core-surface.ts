import { checkedData, fromChecked } from "../checked.js";
import { surfacesModule } from "../../wasm/surfaces-module.js";
import * as check from "../check.js";
import * as queries from "../surface-queries.js";
import { affine } from "../affine.js";
import { coreCurveOf } from "../curve/core-curve.js";
import { corePatchOf } from "../patch/core-patch.js";
import { joinedOf, parsedNetwork, teapotNetwork, teasetNetwork } from "./network.js";
import { showInNode } from "../inspected.js";
import { writePoint } from "../points.js";
import { checkedNetwork, networkJSON, networkOfJSON, networkOfPatches } from "../surface-network.js";
import { surfaceText } from "../../io/surface-text.js";
import { subdivide } from "../flat-pieces.js";
import { readGrid } from "../grid-mesh.js";
import { gridOptions, readMesh } from "../mesh.js";
import { tessellation } from "../tessellation.js";
import { readTopology } from "../topology.js";
import { isocurves, wireframe } from "../wireframe.js";
import type { TransformLike, Complete, PointLike, PointsLike, MatrixLike } from "../check.js";
import type { Network } from "../brand.js";
import type { TeapotOptions } from "./network.js";
import type { SurfaceJSON } from "../surface-network.js";
import type { CorePatch } from "../patch/core-patch.js";
import type { CoreCurve } from "../curve/core-curve.js";
import type { FlatPiece } from "../flat-pieces.js";
import type { GridOptions, Mesh } from "../mesh.js";
import type { Bounds } from "../points.js";
import type { SurfacePoint } from "../surface-queries.js";
import type { TessellationOptions } from "../tessellation.js";
import type { Topology } from "../topology.js";
import type { WireframeOptions } from "../wireframe.js";

/** A class of surfaces, on which static methods are called. */
export type SurfaceClass<S> = new (data: { vertices: PointsLike; patches: ArrayLike<ArrayLike<number>> }) => S;

/** Whether Node knows how to show the instances. */
let isShown = false;

/**
 * A network of Bézier patches that share control points.
 *
 *     const mesh = Surface.teapot().grid({ segments: 16 });
 *
 * This is `Surface` of casteljau/surfaces. That of `casteljau` extends it; where a function takes a surface, it takes the
 * surfaces of every entry point. Static methods make surfaces of the class on which they are called; `parse` and `fromJSON`,
 * which may be passed to `map`, belong to one class.
 *
 * @template P the class of its patches
 * @template C the class of its curves
 */
export class CoreSurface<P extends CorePatch = CorePatch, C extends CoreCurve = CoreCurve> {
  #network: Network;
  /** For each patch the start of its indices, and at last their number; once asked for */
  #starts: Uint32Array | undefined;

  /**
   * The surface of patches of the same degrees, whose control points are given as indices into a list of vertices.
   *
   * @param data for each patch its (degreeU + 1)·(degreeV + 1) vertex indices, u along the fast index
   * @param options `degreeU`: 3 by default; `degreeV`: 3 by default
   * @throws {RangeError} for an index without a vertex, a wrong count, a NaN or an infinity
   */
  constructor(
    data: { vertices: PointsLike; patches: ArrayLike<ArrayLike<number>> },
    options?: { degreeU?: number; degreeV?: number },
  ) {
    if (!isShown) show();
    this.#network = checkedData<Network>(data) ?? checkedNetwork(data, options, joinedOf);
  }

  /**
   * The surface as text from which `parse` creates a bit-identical surface (except that vertices which have been moved
   * to the same position are joined): the row `surface`; `vertices` and their number, then a row x y z for each;
   * `patches` and their number, then for each a row with its degrees in u and v, followed by its net, for each j a row
   * with the vertex numbers, from 0, of the points Pᵢⱼ.
   */
  toText(): string {
    return surfaceText(this.#network);
  }

  /**
   * The vertices and, for each patch, its vertex indices and degrees. As with `toText`, vertices which have been moved
   * to the same position are joined in the surface that `fromJSON` returns.
   */
  toJSON(): { vertices: number[][]; patches: number[][]; degrees: number[][] } {
    return networkJSON(this.#network, this.patches);
  }

  /** A copy of the coordinates of the vertices. */
  get vertices() {
    return this.#network.vertices.slice();
  }

  /** For each patch a copy of the vertex indices of its control points. */
  get patches() {
    return Array.from({ length: this.patchCount }, (_, k) => this.#indicesOf(k).slice());
  }

  /** The number of patches. */
  get patchCount() {
    return this.#network.degrees.length / 2;
  }

  /**
   * One patch.
   *
   * @param k the number of the patch, from 0
   */
  patch(k: number): P {
    check.whole(k, "patch", 0, this.patchCount - 1);
    const { vertices, degrees } = this.#network;
    const indices = this.#indicesOf(k);
    const net = new Float64Array(3 * indices.length);
    indices.forEach((index, i) => net.set(vertices.subarray(3 * index, 3 * index + 3), 3 * i));
    return this._patchOf(net, degrees[2 * k], degrees[2 * k + 1]);
  }

  /**
   * The surface with one vertex moved, together with all vertices that had the same position when the surface was
   * created. So patches that were joined stay joined, and others do not become joined.
   *
   * @param index the number of the control point, from 0
   * @param to the new position
   */
  movePoint(index: number, to: PointLike): this {
    const { joined } = this.#network;
    if (joined.length === 0) throw new RangeError("vertices: expected at least 1, got 0");
    check.whole(index, "index", 0, joined.length - 1);
    const vertices = this.vertices;
    writePoint(vertices, 3 * index, to, 3, "to");
    const moved = vertices.slice(3 * index, 3 * index + 3);
    joined.forEach((first, k) => {
      if (first === joined[index]) vertices.set(moved, 3 * k);
    });
    return this._surfaceOf({ ...this.#network, vertices });
  }

  /**
   * The surface transformed by an affine map.
   *
   * @param matrix a matrix, or a text such as "translate(50 50) rotate(30)"
   * @throws {RangeError} for an image with a coordinate beyond 2^500
   */
  transform<const M extends TransformLike>(matrix: M & Complete<M>): this {
    const { vertices } = this.#network;
    surfacesModule.write(vertices, 12).set(affine(matrix), vertices.length);
    const length = surfacesModule.functions.points_transform(3, vertices.length / 3);
    return this._surfaceOf({ ...this.#network, vertices: surfacesModule.read(0, length) });
  }

  /**
   * See `brand.js`.
   *
   * @internal
   */
  get casteljauType(): "surface" {
    return "surface";
  }

  /**
   * The data, see `Branded`.
   *
   * @internal
   */
  casteljauData(): Network {
    return this.#network;
  }

  /**
   * A surface of the same class.
   *
   * @internal
   */
  _surfaceOf(network: Network): this {
    return coreSurfaceOf(network) as this;
  }

  /**
   * A patch.
   *
   * @internal
   */
  _patchOf(flat: Float64Array, degreeU: number, degreeV: number): P {
    return corePatchOf(flat, degreeU, degreeV) as unknown as P;
  }

  /**
   * @internal
   * Writes the surface to the arena with room for `extra` more numbers, and returns the arena and the index of that
   * room.
   * @param withJoined false for functions that treat patches separately
   */
  _write(extra = 0, withJoined = true): { view: Float64Array; at: number } {
    const { vertices, degrees, indices, joined } = this.#network;
    const from = 3 + degrees.length;
    const joinedAt = from + vertices.length + indices.length;
    const joinedCount = withJoined ? joined.length : 0;
    const at = joinedAt + joinedCount;
    const view = surfacesModule.write(
      Float64Array.of(vertices.length / 3, degrees.length / 2, joinedCount),
      at + extra,
    );
    view.set(degrees, 3);
    view.set(vertices, from);
    view.set(indices, from + vertices.length);
    if (withJoined) view.set(joined, joinedAt);
    return { view, at };
  }

  /** The vertex indices of a patch, not copied. */
  #indicesOf(k: number) {
    const { degrees, indices } = this.#network;
    if (!this.#starts) {
      this.#starts = new Uint32Array(this.patchCount + 1);
      for (let i = 0; i < this.patchCount; i++) {
        this.#starts[i + 1] = this.#starts[i] + (degrees[2 * i] + 1) * (degrees[2 * i + 1] + 1);
      }
    }
    return indices.subarray(this.#starts[k], this.#starts[k + 1]);
  }

  /**
   * How the patches are joined. Two edges are the same line if their control points are equal in the same order or
   * reversed. An edge of another degree, or a part of a longer edge, is a different line.
   */
  topology(): Topology {
    this._write();
    return readTopology(surfacesModule.read(0, surfacesModule.functions.surface_topology()));
  }

  /**
   * The smallest box that contains the surface, exact up to rounding; null without patches. The limit of steps of
   * `Patch.bounds` applies to each patch.
   */
  bounds(): Bounds<3> | null {
    return queries.bounds(this.#writer(false));
  }

  /** The total area of all patches with a relative error below 1e-8; see `Patch.area`. */
  area(): number {
    return queries.area(this.#writer(false));
  }

  /**
   * The volume that a closed surface encloses; null if there is an open edge or an edge that three patches share. It is
   * positive if the normals point outwards; if neighbours disagree, the first patch of each component decides.
   */
  volume(): number | null {
    return queries.volume(this.#writer(true));
  }

  /**
   * The point of the surface that is nearest to p; null without patches. The limit of steps of `Patch.nearest` applies
   * to each patch whose box is not too far away.
   *
   * @param p the point, in the unit of the points
   */
  nearest(p: PointLike): SurfacePoint | null {
    const found = queries.nearest(this.#writer(false), p);
    return found;
  }

  /**
   * All intersections with a ray, sorted by distance; see `Patch.intersectRay`. An intersection on a shared edge is
   * reported once.
   *
   * @param origin the start of the ray
   * @param direction the direction of the ray, of any length above 0
   * @throws {RangeError} for a direction of length 0, and if the search in a patch takes too many steps
   */
  intersectRay(origin: PointLike, direction: PointLike): SurfacePoint[] {
    return queries.intersectRay(this.#writer(false), origin, direction);
  }

  /**
   * A mesh of one grid of samples per patch, as in the web lesson: each patch has its own vertices, also along shared
   * edges.
   */
  grid(options: GridOptions): Mesh {
    const checked = gridOptions(options);
    const { u, v, quads, differences } = checked;
    this._write(0, false);
    surfacesModule.count(surfacesModule.functions.surface_grid(u, v, quads, differences));
    return readGrid(this.patchCount, checked);
  }

  /**
   * A mesh without cracks and T-junctions: every inner edge belongs to exactly two triangles, by the positions of its
   * ends. With `weld: "position"` it does so by their indices, too; otherwise vertices at creases are separate. With
   * `tolerance`, no point of the surface is farther from the mesh than that. Normals are those of the patches, and limits
   * at collapsed edges.
   *
   *     const mesh = Surface.teapot().tessellate({ tolerance: 0.01 });
   *
   * @throws {RangeError} for a tolerance below the precision of f32 (or f64), and for a mesh above 1 GiB; with
   *   `tolerance` or `pixels` and degrees m and n above 4 also above 2³¹ / ((m − 1)(n + 1) + mn + (m + 1)(n − 1))
   *   triangles
   */
  tessellate(options: TessellationOptions): Mesh {
    const { args, extra, into, ...kind } = tessellation(options);
    const end = this._write(extra.length);
    end.view.set(extra, end.at);
    surfacesModule.count(surfacesModule.functions.surface_tessellate(...args));
    return readMesh(into, kind);
  }

  /**
   * The isocurves that divide every patch into `lines` strips in each direction (4 by default), edges included. A
   * shared edge is listed once, a collapsed edge is not listed. For each patch, first the curves u = constant, then v =
   * constant.
   *
   * @param options `lines`: how many strips, 4 by default
   * @throws {RangeError} for 0 lines and above 1 GiB
   */
  isocurves(options?: { lines?: number }): C[] {
    return isocurves(() => this._write(), options).map((points) => this._curveOf(points));
  }

  /**
   * A mesh of the isocurves: tubes, or ribbons that lie in the surface.
   *
   *     const tubes = Surface.teapot().wireframe({ lines: 4, radius: 0.02 });
   *     const ribbons = Surface.teapot().wireframe({ lines: 4, width: 0.05 });
   *
   * The mesh follows a line as closely as a tube's cross-section approximates its circle: within r (1 − cos(π /
   * sides)), and with at most 2π / sides of turning between two samples. A ribbon follows it as closely as a tube with
   * eight sides and half its width as radius. Tubes are closed bodies with round ends and do not twist; ribbons have
   * the surface's normals and are one-sided. A line that is a point is omitted. `uvs` and `patchIds` are null;
   * `patchRanges` has the range of each patch.
   *
   * @throws {TypeError} for neither radius nor width, and for both
   * @throws {RangeError} for a radius or a width below the precision of f32, and above 1 GiB
   */
  wireframe(options: WireframeOptions): Mesh {
    return wireframe(() => this._write(), options);
  }

  /**
   * The recursive subdivision of the texts: every patch is split into four, and the parts again, until the control
   * points of a part are within the tolerance of the plane of three of its corners (those with the largest triangle; of
   * their line or point if they have no plane). For teaching: neighbours that were split differently leave cracks, and
   * the tolerance does not bound the distance from the two triangles of a part. `tessellate` has no cracks and keeps
   * its tolerance.
   *
   * @param tolerance the largest distance, in the unit of the points
   * @returns patch by patch
   * @throws {RangeError} for a tolerance that the coordinates cannot resolve, above 2¹⁸ pieces and 64 for each patch,
   *   and if all pieces, including split ones, have more than 2²⁴ control points together and 128 for each of the
   *   surface (the lower limit for degrees above 5)
   */
  subdivide(tolerance: number): FlatPiece[] {
    return subdivide(() => this._write(), tolerance);
  }

  /**
   * Draws the projected isocurves of all patches on a canvas context or a Path2D with one call of the core. The caller
   * strokes the path.
   *
   * @param target a canvas context or a Path2D
   * @param options `matrix`: maps the surface's coordinates to pixels, 16 numbers column-major; (X, Y, ·, W) is drawn
   *   at (X/W, Y/W). `lines`: the number of strips per patch in each direction, 4 by default; `tolerance`: in pixels,
   *   0.1 by default
   */
  trace(
    target: CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D | Path2D,
    options: { matrix: MatrixLike; lines?: number; tolerance?: number },
  ) {
    const sink = check.drawingTarget(target);
    const { matrix, lines = 4, tolerance } = check.options(options, ["matrix", "lines", "tolerance"]);
    const m = queries.projectionNumbers(matrix as MatrixLike);
    check.segmentCount(lines, "lines");
    const tolerancePx = check.optionalTolerance(tolerance);
    const end = this._write(16);
    end.view.set(m, end.at);
    surfacesModule.count(surfacesModule.functions.surface_trace(sink, lines, tolerancePx));
  }

  /**
   * A curve in space.
   *
   * @internal
   */
  _curveOf(flat: Float64Array): C {
    return coreCurveOf({ flat, dimension: 3 }) as unknown as C;
  }

  #writer(withJoined: boolean): (extra: number) => { view: Float64Array; at: number } {
    return (extra) => this._write(extra, withJoined);
  }

  /** The Utah teapot: 32 patches; rim 0–3, body 4–11, handle 12–15, spout 16–19, lid 20–27, bottom 28–31. */
  static teapot<S extends CoreSurface>(this: SurfaceClass<S>, options?: TeapotOptions): S {
    return surfaceFrom(this, teapotNetwork(options));
  }

  /**
   * Newell's teacup on its saucer: 26 patches; rim 0–3, outside 4–7, inside 8–11, handle 12–13, saucer 14–25. 46 pairs
   * of its edges are shared and 12 edges are open: the bottoms of cup and saucer and the ends of the handle.
   *
   * @param options the axis that points up, "z" by default; "y" gives the axes of the original data
   */
  static teacup<S extends CoreSurface>(this: SurfaceClass<S>, options?: { up?: "z" | "y" }): S {
    return surfaceFrom(this, teasetNetwork(false, options));
  }

  /**
   * Newell's teaspoon: 16 patches, lying with its bowl open upwards and its handle along −y. As in the original data,
   * the end of the bowl and the tip have small gaps: 28 pairs of edges are shared and 8 edges are open.
   *
   * @param options the axis that points up, "z" by default
   */
  static teaspoon<S extends CoreSurface>(this: SurfaceClass<S>, options?: { up?: "z" | "y" }): S {
    return surfaceFrom(this, teasetNetwork(true, options));
  }

  /**
   * The surface of patches, which may differ in their degrees. Control points at the same position become one vertex,
   * so neighbours that have the same points along an edge are joined there. The order of the patches is kept.
   *
   * @param patches patches of any degrees
   */
  static fromPatches<S extends CoreSurface>(this: SurfaceClass<S>, patches: readonly CorePatch[]): S {
    return surfaceFrom(this, networkOfPatches(patches, joinedOf));
  }

  /**
   * Parses the text of a surface. There are four formats, which differ in their first rows:
   *
   * - the format of `toText`;
   * - .bpt: the number of patches; for each patch a row with its degrees, followed by its points, one per row, u along
   *   the fast index. Points with equal coordinates become one vertex;
   * - the listing in which the teapot was published: the number of patches, for each a row of 16 vertex numbers from 1;
   *   the number of vertices, for each a row x y z. Bicubic;
   * - arrays of C source code, in which many programs carry the teapot: an array whose rows are 3 coordinates in braces,
   *   and an array whose rows are 16 vertex numbers in braces, in either order. The numbers are from 0 if 0 occurs,
   *   otherwise from 1. Declarations around the arrays and the comments of C are skipped. Bicubic; the vertices keep
   *   their order.
   *
   * In the other three formats a row is a line; spaces, tabs or commas separate its words. Empty lines and comments, from `#` to the end of the
   * line, are ignored. The time is proportional to the length of the text; counts are checked against that length
   * first.
   *
   * @param text the text in one of the four formats
   * @throws {RangeError} for a syntax error, with the line number, what was expected and what the text contains
   */
  static parse(text: string): CoreSurface {
    return coreSurfaceOf(parsedNetwork(text));
  }

  /**
   * The surface that `toJSON` described.
   *
   * @param json what `toJSON` returned
   */
  static fromJSON(json: SurfaceJSON): CoreSurface {
    return coreSurfaceOf(networkOfJSON(json, joinedOf));
  }
}

/** Outside of the class, so that it does not refer to itself; see `markClassNames` in xtask/bundle.js. */
function show() {
  isShown = showInNode(CoreSurface.prototype, "Surface", summary);
}

function coreSurfaceOf(network: Network): CoreSurface {
  return surfaceFrom(CoreSurface, network); // outside of the class, see ../curve/core-curve.js
}

/**
 * A surface of a class, from a network.
 *
 * @internal
 * @throws {TypeError} for a static method that was called without its class
 */
export function surfaceFrom<S>(Class: SurfaceClass<S>, network: Network): S {
  if (typeof Class !== "function")
    throw new TypeError("expected a call of a static method on its class, as Surface.teapot()");
  return fromChecked(Class, network);
}

/** What Node's console shows of a surface. */
function summary(surface: CoreSurface) {
  const { degrees, vertices } = surface.casteljauData();
  const nets = new Set(degrees.flatMap((degree, k) => (k % 2 ? [`${degrees[k - 1]} × ${degree}`] : [])));
  return { patches: surface.patchCount, degrees: [...nets], vertices: vertices.length / 3 };
}
