import * as check from "./check.js";
import { readGrid } from "./grid-mesh.js";
import { subdivide } from "./flat-pieces.js";
import { gridOptions, readMesh } from "./mesh.js";
import { Patch } from "./patch.js";
import { flatten, writePoint } from "./points.js";
import * as queries from "./surface-queries.js";
import { networkJSON, networkOfJSON, networkOfPatches, vertexIndices } from "./surface-network.js";
import { tessellation } from "./tessellation.js";
import { readTopology } from "./topology.js";
import { parseSurface, surfaceText } from "../io/surface-text.js";
import { core, unwrapCount, writeArguments, readResult, releaseMemory } from "../wasm/surfaces-transfer.js";
import { CheckedPoints } from "../wasm/transfer.js";
import { isocurves, wireframe } from "./wireframe.js";

/**
 * @import { MatrixLike, PointLike, PointsLike } from "./check.js"
 * @import { Curve } from "./curve/curve.js"
 * @import { FlatPiece } from "./flat-pieces.js"
 * @import { WireframeOptions } from "./wireframe.js"
 * @import { GridOptions, Mesh } from "./mesh.js"
 * @import { Point } from "./points.js"
 * @import { SurfaceJSON } from "./surface-network.js"
 * @import { SurfacePoint } from "./surface-queries.js"
 * @import { TessellationOptions } from "./tessellation.js"
 * @import { Topology } from "./topology.js"
 */

/**
 * The parts of the teapot, its height and the axis that points up.
 *
 * @typedef {object} TeapotOptions
 * @property {boolean} [rim] true by default, as all parts
 * @property {boolean} [body]
 * @property {boolean} [handle]
 * @property {boolean} [spout]
 * @property {boolean} [lid]
 * @property {boolean} [bottom]
 * @property {"squashed" | "original"} [height] "squashed" (3.15) by default; "original" is 4/3 as tall
 * @property {"z" | "y"} [up] "z" by default
 */

/**
 * The nets of a surface: the vertices; for each vertex the index of the first one that had the same position when the
 * surface was created (`joined`); two degrees for each patch; the vertex indices of all nets, one net after the other.
 *
 * @typedef {{ vertices: Float64Array, joined: Float64Array, degrees: number[], indices: Uint32Array }} Network
 */

/** In the order of the core's bits. */
const PARTS = /** @type {const} */ (["rim", "body", "handle", "spout", "lid", "bottom"]);
const TEAPOT_OPTIONS = /** @type {const} */ ([...PARTS, "height", "up"]);

/**
 * A network of Bézier patches that share control points.
 *
 *     const mesh = Surface.teapot().grid({ segments: 16 });
 */
export class Surface {
  /** @type {Network} */
  #network;

  /**
   * @param {{ vertices: PointsLike, patches: ArrayLike<ArrayLike<number>> }} data for each patch its
   *   (degreeU + 1)·(degreeV + 1) vertex indices, u along the fast index
   * @param {{ degreeU?: number, degreeV?: number }} [options] bicubic by default
   * @throws {RangeError} for an index without a vertex, a wrong count, a NaN or an infinity
   */
  constructor(data, options) {
    const checked = /** @type {unknown} */ (data);
    if (checked instanceof CheckedNetwork) {
      this.#network = checked.network;
      return;
    }
    const { vertices, patches } = check.object(data, "data");
    const { degreeU = 3, degreeV = 3 } = check.options(options, ["degreeU", "degreeV"]);
    check.whole(degreeU, "degreeU", 1, 64);
    check.whole(degreeV, "degreeV", 1, 64);
    const flat = flatten(/** @type {PointsLike} */ (vertices), 3, 3, "vertices").flat;
    const indices = patchIndices(patches, (degreeU + 1) * (degreeV + 1), flat.length / 3);
    const degrees = Array.from({ length: (2 * indices.length) / ((degreeU + 1) * (degreeV + 1)) }, (_, k) =>
      k % 2 ? degreeV : degreeU,
    );
    this.#network = { vertices: flat, joined: joinedOf(flat), degrees, indices };
  }

  /**
   * The Utah teapot: 32 patches; rim 0–3, body 4–11, handle 12–15, spout 16–19, lid 20–27, bottom 28–31.
   *
   * @param {TeapotOptions} [options]
   * @returns {Surface}
   */
  static teapot(options) {
    const checked = check.options(options, TEAPOT_OPTIONS);
    const height = check.oneOf(checked.height ?? "squashed", "height", ["squashed", "original"]);
    const up = upAxis(checked.up);
    const bits = PARTS.reduce(
      (sum, part, k) => (check.optionalBoolean(checked[part], part, true) ? sum | (1 << k) : sum),
      0,
    );
    return readSurface(core().surface_teapot(bits, height === "original", up === "y"));
  }

  /**
   * Newell's teacup on its saucer: 26 patches; rim 0–3, outside 4–7, inside 8–11, handle 12–13, saucer 14–25. 46 pairs
   * of its edges are shared and 12 edges are open: the bottoms of cup and saucer and the ends of the handle.
   *
   * @param {{ up?: "z" | "y" }} [options] the axis that points up, "z" by default; "y" gives the axes of the original
   *   data
   * @returns {Surface}
   */
  static teacup(options) {
    return readSurface(core().surface_teaset(false, upAxis(check.options(options, ["up"]).up) === "y"));
  }

  /**
   * Newell's teaspoon: 16 patches, lying with its bowl open upwards and its handle along −y. As in the original data,
   * the end of the bowl and the tip have small gaps: 28 pairs of edges are shared and 8 edges are open.
   *
   * @param {{ up?: "z" | "y" }} [options] the axis that points up, "z" by default
   * @returns {Surface}
   */
  static teaspoon(options) {
    return readSurface(core().surface_teaset(true, upAxis(check.options(options, ["up"]).up) === "y"));
  }

  /**
   * Parses the text of a surface. There are three formats, which differ in their first rows:
   *
   * - the format of `toText`;
   * - .bpt: the number of patches; for each patch a row with its degrees, followed by its points, one per row, u along
   *   the fast index. Points with equal coordinates become one vertex;
   * - the listing in which the teapot was published: the number of patches, for each a row of 16 vertex numbers from 1;
   *   the number of vertices, for each a row x y z. Bicubic.
   *
   * A row is a line; spaces, tabs or commas separate its words. Empty lines and comments, from `#` to the end of the
   * line, are ignored. The time is proportional to the length of the text; counts are checked against that length
   * first.
   *
   * @param {string} text
   * @returns {Surface}
   * @throws {RangeError} for a syntax error, with the line number, what was expected and what the text contains
   */
  static parse(text) {
    if (typeof text !== "string") throw new TypeError(`text: expected a string, got ${check.describe(text)}`);
    return surfaceOf(parseSurface(text, joinedOf));
  }

  /**
   * The surface of patches, which may differ in their degrees. Control points at the same position become one vertex,
   * so neighbours that have the same points along an edge are joined there. The order of the patches is kept.
   *
   * @param {readonly Patch[]} patches
   * @returns {Surface}
   */
  static fromPatches(patches) {
    return surfaceOf(networkOfPatches(patches, joinedOf));
  }

  /**
   * @param {SurfaceJSON} json what `toJSON` returned
   * @returns {Surface}
   */
  static fromJSON(json) {
    return surfaceOf(networkOfJSON(json, joinedOf));
  }

  /**
   * The vertices and, for each patch, its vertex indices and degrees. As with `toText`, vertices which have been moved
   * to the same position are joined in the surface that `fromJSON` returns.
   *
   * @returns {{ vertices: number[][], patches: number[][], degrees: number[][] }}
   */
  toJSON() {
    return networkJSON(this.#network, this.patches);
  }

  /**
   * See `brand.js`.
   *
   * @internal
   * @returns {"surface"}
   */
  get casteljauType() {
    return "surface";
  }

  /**
   * The surface as text from which `parse` creates a bit-identical surface (except that vertices which have been moved
   * to the same position are joined): the row `surface`; `vertices` and their number, then a row x y z for each;
   * `patches` and their number, then for each a row with its degrees in u and v, followed by its net, for each j a row
   * with the vertex numbers, from 0, of the points Pᵢⱼ.
   *
   * @returns {string}
   */
  toText() {
    return surfaceText(this.#network);
  }

  /** A copy of the coordinates of the vertices. */
  get vertices() {
    return this.#network.vertices.slice();
  }

  /** For each patch a copy of the vertex indices of its control points. */
  get patches() {
    let from = 0;
    return Array.from({ length: this.patchCount }, (_, k) => {
      const to = from + this.#netLength(k);
      const indices = this.#network.indices.slice(from, to);
      from = to;
      return indices;
    });
  }

  /** The number of patches. */
  get patchCount() {
    return this.#network.degrees.length / 2;
  }

  /**
   * One patch.
   *
   * @param {number} k
   * @returns {Patch}
   */
  patch(k) {
    check.whole(k, "patch", 0, this.patchCount - 1);
    const { vertices, degrees } = this.#network;
    const indices = this.patches[k];
    const net = new Float64Array(3 * indices.length);
    indices.forEach((index, i) => net.set(vertices.subarray(3 * index, 3 * index + 3), 3 * i));
    const checked = /** @type {any} */ (new CheckedPoints(net, 3));
    return new Patch(checked, { degreeU: degrees[2 * k], degreeV: degrees[2 * k + 1] });
  }

  /**
   * The surface with one vertex moved, together with all vertices that had the same position when the surface was
   * created. So patches that were joined stay joined, and others do not become joined.
   *
   * @param {number} index
   * @param {PointLike} to
   * @returns {Surface}
   */
  movePoint(index, to) {
    const { joined } = this.#network;
    if (joined.length === 0) throw new RangeError("vertices: expected at least 1, got 0");
    check.whole(index, "index", 0, joined.length - 1);
    const vertices = this.vertices;
    writePoint(vertices, 3 * index, to, 3, "to");
    const moved = vertices.slice(3 * index, 3 * index + 3);
    joined.forEach((first, k) => {
      if (first === joined[index]) vertices.set(moved, 3 * k);
    });
    return surfaceOf({ ...this.#network, vertices });
  }

  /**
   * How the patches are joined. Two edges are the same line if their control points are equal in the same order or
   * reversed. An edge of another degree, or a part of a longer edge, is a different line.
   *
   * @returns {Topology}
   */
  topology() {
    this.#write();
    return readTopology(readResult(0, core().surface_topology()));
  }

  /**
   * The surface transformed by an affine map.
   *
   * @param {MatrixLike} matrix
   * @returns {Surface}
   */
  transform(matrix) {
    const { vertices } = this.#network;
    writeArguments(vertices, 12).set(check.affine(matrix), vertices.length);
    core().points_transform(3, vertices.length / 3);
    return surfaceOf({ ...this.#network, vertices: readResult(0, vertices.length) });
  }

  /**
   * The smallest box that contains the surface, exact up to rounding; null without patches. The limit of steps of
   * `Patch.bounds` applies to each patch.
   *
   * @returns {{ min: Point, max: Point } | null}
   */
  bounds() {
    return queries.bounds(this.#writer(false));
  }

  /**
   * The total area of all patches with a relative error below 1e-8; see `Patch.area`.
   *
   * @returns {number}
   */
  area() {
    return queries.area(this.#writer(false));
  }

  /**
   * The volume that a closed surface encloses; null if there is an open edge or an edge that three patches share. It is
   * positive if the normals point outwards; if neighbours disagree, the first patch of each component decides.
   *
   * @returns {number | null}
   */
  volume() {
    return queries.volume(this.#writer(true));
  }

  /**
   * The point of the surface that is nearest to p; null without patches. The limit of steps of `Patch.nearest` applies
   * to each patch whose box is not too far away.
   *
   * @param {PointLike} p
   * @returns {SurfacePoint | null}
   */
  nearest(p) {
    return queries.nearest(this.#writer(false), p);
  }

  /**
   * All intersections with a ray, sorted by distance; see `Patch.intersectRay`. An intersection on a shared edge is
   * reported once.
   *
   * @param {PointLike} origin
   * @param {PointLike} direction
   * @returns {SurfacePoint[]}
   * @throws {RangeError} for a direction of length 0, and if the search in a patch takes too many steps
   */
  intersectRay(origin, direction) {
    return queries.intersectRay(this.#writer(false), origin, direction);
  }

  /**
   * A mesh of one grid of samples per patch, as in the tutorial: each patch has its own vertices, also along shared
   * edges.
   *
   * @param {GridOptions} options
   * @returns {Mesh}
   */
  grid(options) {
    const checked = gridOptions(options);
    const { u, v, quads, differences } = checked;
    this.#write(0, false);
    unwrapCount(core().surface_grid(u, v, quads, differences));
    return readGrid(this.patchCount, checked);
  }

  /**
   * A mesh without cracks and T-junctions: every inner edge belongs to exactly two triangles. With `tolerance`, no
   * point of the surface is farther from the mesh than that. Normals are those of the patches, and limits at collapsed
   * edges.
   *
   *     const mesh = Surface.teapot().tessellate({ tolerance: 0.01 });
   *
   * @param {TessellationOptions} options
   * @returns {Mesh}
   * @throws {RangeError} for a tolerance below the precision of f32 (or f64), and for a mesh above 1 GiB; with
   *   `tolerance` or `pixels` and degrees m and n above 4 also above 2³¹ / ((m − 1)(n + 1) + mn + (m + 1)(n − 1))
   *   triangles
   */
  tessellate(options) {
    const { args, extra, into, ...kind } = tessellation(options);
    const end = this.#write(extra.length);
    end.view.set(extra, end.at);
    unwrapCount(core().surface_tessellate(...args));
    return readMesh(into, kind);
  }

  /**
   * The isocurves that divide every patch into `lines` strips in each direction (4 by default), edges included. A
   * shared edge is listed once, a collapsed edge is not listed. For each patch, first the curves u = constant, then v =
   * constant.
   *
   * @param {{ lines?: number }} [options]
   * @returns {Curve[]}
   * @throws {RangeError} for 0 lines and above 1 GiB
   */
  isocurves(options) {
    return isocurves(() => this.#write(), options);
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
   * @param {WireframeOptions} options
   * @returns {Mesh}
   * @throws {TypeError} for neither radius nor width, and for both
   * @throws {RangeError} for a radius or a width below the precision of f32, and above 1 GiB
   */
  wireframe(options) {
    return wireframe(() => this.#write(), options);
  }

  /**
   * The recursive subdivision of the tutorials: every patch is split into four, and the parts again, until the control
   * points of a part are within the tolerance of the plane of three of its corners (those with the largest triangle; of
   * their line or point if they have no plane). For teaching: neighbours that were split differently leave cracks, and
   * the tolerance does not bound the distance from the two triangles of a part. `tessellate` has no cracks and keeps
   * its tolerance.
   *
   * @param {number} tolerance
   * @returns {FlatPiece[]} patch by patch
   * @throws {RangeError} for a tolerance that the coordinates cannot resolve, above 2¹⁸ pieces, and if all pieces,
   *   including split ones, have more than 2²⁴ control points together (the lower limit for degrees above 5)
   */
  subdivide(tolerance) {
    return subdivide(() => this.#write(), tolerance);
  }

  /**
   * Draws the projected isocurves of all patches on a canvas context or a Path2D with one call of the core. The caller
   * strokes the path.
   *
   * @param {CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D | Path2D} target
   * @param {{ matrix: MatrixLike, lines?: number, tolerance?: number }} options `matrix`: maps the surface's
   *   coordinates to pixels, 16 numbers column-major; (X, Y, ·, W) is drawn at (X/W, Y/W). `lines`: the number of
   *   strips per patch in each direction, 4 by default; `tolerance`: in pixels, 0.1 by default
   */
  trace(target, options) {
    const sink = check.drawingTarget(target);
    const { matrix, lines = 4, tolerance } = check.options(options, ["matrix", "lines", "tolerance"]);
    const m = check.matrixNumbers(/** @type {MatrixLike} */ (matrix));
    check.segmentCount(lines, "lines");
    const tolerancePx = check.optionalTolerance(tolerance);
    const end = this.#write(16);
    end.view.set(m.length === 6 ? [m[0], m[1], 0, 0, m[2], m[3], 0, 0, 0, 0, 1, 0, m[4], m[5], 0, 1] : m, end.at);
    unwrapCount(core().surface_trace(sink, lines, tolerancePx));
  }

  /**
   * @param {boolean} withJoined
   * @returns {(extra: number) => { view: Float64Array, at: number }}
   */
  #writer(withJoined) {
    return (extra) => this.#write(extra, withJoined);
  }

  /** @param {number} k */
  #netLength(k) {
    const { degrees } = this.#network;
    return (degrees[2 * k] + 1) * (degrees[2 * k + 1] + 1);
  }

  /**
   * Writes the surface to the arena with room for `extra` more numbers, and returns the arena and the index of that
   * room.
   *
   * @param {number} [extra]
   * @param {boolean} [withJoined] false for functions that treat patches separately
   */
  #write(extra = 0, withJoined = true) {
    const { vertices, degrees, indices, joined } = this.#network;
    const from = 3 + degrees.length;
    const joinedAt = from + vertices.length + indices.length;
    const joinedCount = withJoined ? joined.length : 0;
    const at = joinedAt + joinedCount;
    const view = writeArguments(Float64Array.of(vertices.length / 3, degrees.length / 2, joinedCount), at + extra);
    view.set(degrees, 3);
    view.set(vertices, from);
    view.set(indices, from + vertices.length);
    if (withJoined) view.set(joined, joinedAt);
    return { view, at };
  }
}

/** A network that is already checked: the constructor accepts it from inside the package. */
class CheckedNetwork {
  /** @param {Network} network */
  constructor(network) {
    this.network = network;
  }
}

/** @param {Network} network */
function surfaceOf(network) {
  return new Surface(/** @type {any} */ (new CheckedNetwork(network)));
}

/**
 * Reads a surface from the arena, see `write` in src/wasm/surface.rs.
 *
 * @param {number} length
 */
function readSurface(length) {
  const numbers = readResult(0, length);
  const [vertices, patches, joined] = numbers;
  const from = 3 + 2 * patches;
  const to = from + 3 * vertices;
  const end = numbers.length - joined;
  return surfaceOf({
    degrees: [...numbers.subarray(3, from)],
    vertices: numbers.slice(from, to),
    indices: Uint32Array.from(numbers.subarray(to, end)),
    joined: numbers.slice(end),
  });
}

/** @param {Float64Array} vertices */
function joinedOf(vertices) {
  writeArguments(vertices);
  const joined = readResult(0, core().points_joined(vertices.length / 3));
  releaseMemory();
  return joined;
}

/** @param {unknown} up */
function upAxis(up = "z") {
  return check.oneOf(up, "up", ["z", "y"]);
}

/**
 * @param {unknown} patches
 * @param {number} count the number of points of one net
 * @param {number} vertices
 * @returns {Uint32Array}
 */
function patchIndices(patches, count, vertices) {
  if (!Array.isArray(patches)) throw new TypeError(`patches: expected an array, got ${check.describe(patches)}`);
  const all = new Uint32Array(patches.length * count);
  patches.forEach((net, k) => all.set(vertexIndices(net, count, vertices, `patches[${k}]`), k * count));
  return all;
}
