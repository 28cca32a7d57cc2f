import * as check from "./check.js";
import { takeGrid } from "./grid-mesh.js";
import { subdivide } from "./flat-pieces.js";
import { gridOptions, takeMesh } from "./mesh.js";
import { Patch } from "./patch.js";
import { flatten, writePoint } from "./points.js";
import * as queries from "./surface-queries.js";
import { tessellation } from "./tessellation.js";
import { readTopology } from "./topology.js";
import { parseSurface, surfaceText } from "../io/surface-text.js";
import { core, done, load, take, trim } from "../wasm/surfaces-transfer.js";
import { Checked } from "../wasm/transfer.js";
import { isocurves, wireframe } from "./wireframe.js";

/**
 * @import { MatrixLike, PointLike, PointsLike } from "./check.js"
 * @import { Curve } from "./curve.js"
 * @import { FlatPiece } from "./flat-pieces.js"
 * @import { WireframeOptions } from "./wireframe.js"
 * @import { GridOptions, Mesh } from "./mesh.js"
 * @import { Point } from "./points.js"
 * @import { SurfacePoint } from "./surface-queries.js"
 * @import { TessellationOptions } from "./tessellation.js"
 * @import { Topology } from "./topology.js"
 */

/**
 * The teapot's parts (all there by default), its height ("squashed", 3.15, by default; "original", 4/3 as tall) and the
 * axis that points up ("z" by default).
 *
 * @typedef {{ rim?: boolean, body?: boolean, handle?: boolean, spout?: boolean, lid?: boolean, bottom?: boolean,
 *   height?: "squashed" | "original", up?: "z" | "y" }} TeapotOptions
 */

/**
 * The nets of a surface: vertices, for each the first that was at the same place when the surface was made, two degrees for
 * each patch, and the vertex indices of all nets in turn.
 *
 * @typedef {{ vertices: Float64Array, joined: Float64Array, degrees: number[], indices: Uint32Array }} Network
 */

/** In the order of the core's bits. */
const PARTS = /** @type {const} */ (["rim", "body", "handle", "spout", "lid", "bottom"]);

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
   * @throws {RangeError} for an index that names no vertex, a wrong count, a NaN or an infinity
   */
  constructor(data, options) {
    const inside = /** @type {unknown} */ (data);
    if (inside instanceof CheckedNetwork) {
      this.#network = inside.network;
      return;
    }
    const { vertices, patches } = check.options(data, "data");
    const { degreeU = 3, degreeV = 3 } = check.options(options);
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
    const given = check.options(options);
    const height = check.oneOf(given.height ?? "squashed", "height", ["squashed", "original"]);
    const up = upAxis(given);
    const bits = PARTS.reduce((sum, part, k) => (given[part] === false ? sum : sum | (1 << k)), 0);
    return readSurface(core().surface_teapot(bits, height === "original", up === "y"));
  }

  /**
   * Newell's teacup on its saucer: 26 patches; rim 0–3, outside 4–7, inside 8–11, handle 12–13, saucer 14–25. Of its
   * sides 46 pairs are shared and 12 open: the bottoms of cup and saucer and the ends of the handle.
   *
   * @param {{ up?: "z" | "y" }} [options] the axis that points up, "z" by default; with "y" the axes of the archive
   * @returns {Surface}
   */
  static teacup(options) {
    return readSurface(core().surface_teaset(false, upAxis(options) === "y"));
  }

  /**
   * Newell's teaspoon: 16 patches, lying with its bowl open upwards and its handle along −y. As in the archive the bowl's
   * end and the tip have small gaps: 28 pairs of sides are shared and 8 sides open.
   *
   * @param {{ up?: "z" | "y" }} [options] the axis that points up, "z" by default
   * @returns {Surface}
   */
  static teaspoon(options) {
    return readSurface(core().surface_teaset(true, upAxis(options) === "y"));
  }

  /**
   * A surface from its text, in one of three forms, told apart by their first rows:
   *
   * - as `toText` writes it;
   * - .bpt: the number of patches; for each a row with its degrees and below it its points, one a row, u along the fast
   *   index. Points with equal coordinates become one vertex;
   * - the listing in which the teapot was handed on: the number of patches, for each a row of 16 vertex numbers from 1;
   *   the number of vertices, for each a row x y z. Bicubic.
   *
   * A row is a line; blanks, tabs or commas separate its words. Empty lines and comments, from `#` to the end of the line,
   * do not count. The time is proportional to the length of the text, and counts are checked against that length first.
   *
   * @param {string} text
   * @returns {Surface}
   * @throws {RangeError} for text that is none of these, with the number of the line, what was expected there and what came
   */
  static parse(text) {
    if (typeof text !== "string") throw new TypeError(`text: expected a string, got ${check.shown(text)}`);
    return surfaceOf(parseSurface(text, joinedOf));
  }

  /**
   * The surface as text, which `parse` reads back to an equal one, bit for bit (but vertices that a move has brought to one
   * place are joined when they are read): the row `surface`; `vertices` and their
   * number, then a row x y z for each; `patches` and their number, then for each a row with its degrees in u and v, and
   * below it its net: a row for each j with the vertex numbers, from 0, of its points Pᵢⱼ.
   *
   * @returns {string}
   */
  toText() {
    return surfaceText(this.#network);
  }

  /** The coordinates of the vertices, a copy. */
  get vertices() {
    return this.#network.vertices.slice();
  }

  /** For each patch the indices of its control points, copies. */
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
    const checked = /** @type {any} */ (new Checked(net, 3));
    return new Patch(checked, { degreeU: degrees[2 * k], degreeV: degrees[2 * k + 1] });
  }

  /**
   * The surface with one vertex moved, for all patches that share it, and with it all vertices that were at the same place
   * when the surface was made: what was joined stays joined, what was not does not become so.
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
   * How the patches are joined: sides are the same line when their control points are at the same places, in the same
   * order or reversed. A side of another degree, or a part of a longer one, is another line.
   *
   * @returns {Topology}
   */
  topology() {
    this.#load();
    return readTopology(take(0, core().surface_topology()));
  }

  /**
   * The image under an affine map.
   *
   * @param {MatrixLike} matrix
   * @returns {Surface}
   */
  transform(matrix) {
    const { vertices } = this.#network;
    load(vertices, 12).set(check.affine(matrix), vertices.length);
    core().points_transform(3, vertices.length / 3);
    return surfaceOf({ ...this.#network, vertices: take(0, vertices.length) });
  }

  /**
   * The smallest box that contains the surface, exact to rounding; null without patches. Each patch adds to the most steps
   * as `Patch.bounds` says.
   *
   * @returns {{ min: Point, max: Point } | null}
   */
  bounds() {
    return queries.bounds(this.#loader(false));
  }

  /**
   * The area of all patches together, within 1e-8 of itself; see `Patch.area`.
   *
   * @returns {number}
   */
  area() {
    return queries.area(this.#loader(false));
  }

  /**
   * The volume that a closed surface encloses, null for one with an open side or a side that three patches share. Positive
   * where the normals point outwards; where neighbours disagree, the first patch of each connected part decides.
   *
   * @returns {number | null}
   */
  volume() {
    return queries.volume(this.#loader(true));
  }

  /**
   * The point of the surface that is nearest to p; null without patches. Each patch whose box is not too far away adds to
   * the most steps as `Patch.nearest` says.
   *
   * @param {PointLike} p
   * @returns {SurfacePoint | null}
   */
  nearest(p) {
    return queries.nearest(this.#loader(false), p);
  }

  /**
   * All hits of a ray, by distance; see `Patch.intersectRay`. One on a side that patches share counts once.
   *
   * @param {PointLike} origin
   * @param {PointLike} direction
   * @returns {SurfacePoint[]}
   * @throws {RangeError} for a direction of length 0, and when the search over a patch takes too many steps
   */
  intersectRay(origin, direction) {
    return queries.intersectRay(this.#loader(false), origin, direction);
  }

  /**
   * A mesh of one grid per patch, as the tutorial does it: each patch has its own vertices, also along sides.
   *
   * @param {GridOptions} options
   * @returns {Mesh}
   */
  grid(options) {
    const wanted = gridOptions(options);
    const { u, v, quads, differences } = wanted;
    this.#load(0, false);
    done(core().surface_grid(u, v, quads, differences));
    return takeGrid(this.patchCount, wanted);
  }

  /**
   * A mesh without cracks and T-junctions: every edge inside has exactly two triangles. By tolerance, no point of the
   * surface is farther from the mesh than that; normals are those of the patches, limits where a side has collapsed.
   *
   *     const mesh = Surface.teapot().tessellate({ tolerance: 0.01 });
   *
   * @param {TessellationOptions} options
   * @returns {Mesh}
   * @throws {RangeError} for a tolerance that f32 (or f64) cannot keep, and for a mesh above 1 GiB; with patches of degrees
   *   m and n above 4 also, by tolerance or pixels, above 2³¹ / ((m − 1)(n + 1) + mn + (m + 1)(n − 1)) triangles
   */
  tessellate(options) {
    const { args, extra, into, ...kind } = tessellation(options);
    const end = this.#load(extra.length);
    end.view.set(extra, end.at);
    done(core().surface_tessellate(...args));
    return takeMesh(into, kind);
  }

  /**
   * The curves that divide every patch into `lines` strips each way (4 by default), sides included: a side that patches
   * share comes once, one that is a point not at all. For each patch first the curves of constant u, then of constant v.
   *
   * @param {{ lines?: number }} [options]
   * @returns {Curve[]}
   * @throws {RangeError} for 0 lines, and above 1 GiB
   */
  isocurves(options) {
    return isocurves(() => this.#load(), options);
  }

  /**
   * A mesh of the isocurves: tubes, or ribbons that lie in the surface.
   *
   *     const tubes = Surface.teapot().wireframe({ lines: 4, radius: 0.02 });
   *     const ribbons = Surface.teapot().wireframe({ lines: 4, width: 0.05 });
   *
   * A line is followed as closely as a tube's cross-section follows its circle: to r (1 − cos(π / sides)), turning by at
   * most 2π / sides from place to place; a ribbon as a tube of half its width with eight sides. Tubes are closed bodies
   * with round ends, and do not twist; ribbons have the surface's normals and one side. A line that is a point gives
   * nothing. `uvs` and `patchIds` are null; `patchRanges` tell which patch has drawn what.
   *
   * @param {WireframeOptions} options
   * @returns {Mesh}
   * @throws {TypeError} without a radius or a width, and with both
   * @throws {RangeError} for a radius that 32 bits cannot show on coordinates of this size, and above 1 GiB
   */
  wireframe(options) {
    return wireframe(() => this.#load(), options);
  }

  /**
   * The recursive split of the tutorials: every patch in four, and the pieces again, until the control points of each are
   * within the tolerance of the plane of three of its corners (those with the largest triangle; of their line or point
   * where they have no plane). For teaching: neighbours that were split differently leave cracks, and the tolerance does not
   * bound the distance from the two triangles of a piece. `tessellate` has no cracks and keeps its tolerance.
   *
   * @param {number} tolerance
   * @returns {FlatPiece[]} patch by patch
   * @throws {RangeError} for a tolerance that the coordinates cannot resolve, above 2¹⁸ pieces, and when all pieces, split
   *   ones included, together have more than 2²⁴ control points (at degrees above 5 that comes first)
   */
  subdivide(tolerance) {
    return subdivide(() => this.#load(), tolerance);
  }

  /**
   * Draws curves of constant u and v of all patches on a canvas context or a Path2D, projected: all lines in one call.
   * The caller strokes.
   *
   * @param {CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D | Path2D} target
   * @param {{ matrix: MatrixLike, lines?: number, tolerance?: number }} options `matrix`: from the surface's coordinates
   *   to pixels, 16 numbers column-major; (X, Y, ·, W) is drawn at (X/W, Y/W). `lines`: strips per patch, 4 by default;
   *   `tolerance`: in pixels, 0.1 by default
   */
  trace(target, options) {
    const pen = check.drawingTarget(target);
    const { matrix, lines = 4, tolerance } = check.options(options);
    const m = check.matrixNumbers(/** @type {MatrixLike} */ (matrix));
    check.segmentCount(lines, "lines");
    const px = check.optionalTolerance(tolerance);
    const end = this.#load(16);
    end.view.set(m.length === 6 ? [m[0], m[1], 0, 0, m[2], m[3], 0, 0, 0, 0, 1, 0, m[4], m[5], 0, 1] : m, end.at);
    done(core().surface_trace(pen, lines, px));
  }

  /**
   * @param {boolean} withJoined
   * @returns {(extra: number) => { view: Float64Array, at: number }}
   */
  #loader(withJoined) {
    return (extra) => this.#load(extra, withJoined);
  }

  /** @param {number} k */
  #netLength(k) {
    const { degrees } = this.#network;
    return (degrees[2 * k] + 1) * (degrees[2 * k + 1] + 1);
  }

  /**
   * Writes the surface to the arena, with room behind it.
   *
   * @param {number} [extra]
   * @param {boolean} [withJoined] not needed where patches stand alone
   */
  #load(extra = 0, withJoined = true) {
    const { vertices, degrees, indices, joined } = this.#network;
    const from = 3 + degrees.length;
    const joinedAt = from + vertices.length + indices.length;
    const joinedCount = withJoined ? joined.length : 0;
    const at = joinedAt + joinedCount;
    const view = load(Float64Array.of(vertices.length / 3, degrees.length / 2, joinedCount), at + extra);
    view.set(degrees, 3);
    view.set(vertices, from);
    view.set(indices, from + vertices.length);
    if (withJoined) view.set(joined, joinedAt);
    return { view, at };
  }
}

/** A network that was checked: what the constructor takes from inside. */
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
 * The surface that the core left, see `put` in src/wasm/surface.rs.
 *
 * @param {number} length
 */
function readSurface(length) {
  const numbers = take(0, length);
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
  load(vertices);
  const joined = take(0, core().points_joined(vertices.length / 3));
  trim();
  return joined;
}

/** @param {{ up?: "z" | "y" } | undefined} options */
function upAxis(options) {
  return check.oneOf(check.options(options).up ?? "z", "up", ["z", "y"]);
}

/**
 * @param {unknown} patches
 * @param {number} count of one net
 * @param {number} vertices
 * @returns {Uint32Array}
 */
function patchIndices(patches, count, vertices) {
  if (!Array.isArray(patches)) throw new TypeError(`patches: expected an array, got ${check.shown(patches)}`);
  const all = new Uint32Array(patches.length * count);
  patches.forEach((net, k) => {
    if (!check.isList(net)) throw new TypeError(`patches[${k}]: expected vertex indices, got ${check.shown(net)}`);
    if (net.length !== count)
      throw new RangeError(`patches[${k}]: expected ${count} vertex indices, got ${net.length}`);
    for (let i = 0; i < count; i++) all[k * count + i] = check.whole(net[i], `patches[${k}][${i}]`, 0, vertices - 1);
  });
  return all;
}
