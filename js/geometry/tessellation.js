import * as check from "./check.js";
import { meshInto, segmentsOf } from "./mesh.js";

/**
 * @import { MatrixLike } from "./check.js"
 * @import { Mesh } from "./mesh.js"
 */

/**
 * The level of detail by a number of segments.
 *
 * @typedef {object} SegmentDetail
 * @property {number | { u: number, v: number }} segments cells of every patch along u and v; one number for both directions
 */

/**
 * The level of detail by a distance.
 *
 * @typedef {object} ToleranceDetail
 * @property {number} tolerance the largest distance from the surface to the mesh, in the surface's unit
 */

/**
 * The level of detail by a distance on the screen; parts outside the viewport may be coarser.
 *
 * @typedef {object} PixelDetail
 * @property {number} pixels the largest distance from the surface to the mesh on the screen
 * @property {MatrixLike} viewProjection maps (x, y, z, 1) to clip space: 16 numbers column-major, or an object with `elements`
 * @property {ArrayLike<number>} viewport width and height in pixels
 */

/**
 * The level of detail of a mesh, in one of three ways.
 *
 * @typedef {SegmentDetail | ToleranceDetail | PixelDetail} Detail
 */

/**
 * The options of a tessellation besides the level of detail.
 *
 * @typedef {object} MeshOptions
 * @property {"position" | "normal" | "none"} [weld] which corners become one vertex: "position", one vertex per point; "normal", the
 *   default of surfaces, separate vertices where normals differ by more than 0.1°; "none", the default of patches, separate vertices
 *   for each patch, so that uvs and patch indices are defined
 * @property {"f32" | "f64"} [precision] the type of positions and normals, "f32" by default
 * @property {Mesh} [into] an earlier mesh, whose arrays are reused if they are large enough
 */

/**
 * The options of a tessellation: the level of detail and what mesh is made.
 *
 * @typedef {Detail & MeshOptions} TessellationOptions
 */

/** The names of the options; exactly one of `DETAILS` is given. */
const DETAILS = ["segments", "tolerance", "pixels"];
const VIEW = ["viewProjection", "viewport"];
const NAMES = /** @type {any} */ ([...DETAILS, ...VIEW, "weld", "precision", "into"]);
/** In the order of the core's codes. */
const WELDS = /** @type {const} */ (["position", "normal", "none"]);
const SEGMENTS = 0;
const TOLERANCE = 1;
const PIXELS = 2;

/**
 * The checked options of `tessellate` as arguments of the core: the kind of detail with its two numbers, the weld code
 * and the precision; `extra` is written to the arena after the surface.
 *
 * @internal
 * @param {TessellationOptions} options
 * @param {"normal" | "none"} [defaultWeld]
 */
export function tessellation(options, defaultWeld = "normal") {
  const { weld = defaultWeld, precision = "f32", into, ...detail } = check.options(options, NAMES);
  const weldCode = WELDS.indexOf(check.oneOf(weld, "weld", WELDS));
  const isF64 = check.oneOf(precision, "precision", ["f32", "f64"]) === "f64";
  const { kind, a, b = 0, extra = [] } = detailNumbers(detail);
  const args = /** @type {[number, number, number, number, boolean]} */ ([kind, a, b, weldCode, isF64]);
  return { args, extra, isF64, separatePatches: weld === "none", into: meshInto(into) };
}

/**
 * @param {Record<string, any>} detail
 * @returns {{ kind: number, a: number, b?: number, extra?: number[] }}
 */
function detailNumbers(detail) {
  const given = DETAILS.filter((name) => detail[name] !== undefined);
  if (given.length !== 1) {
    const got = given.length === 0 ? "none of them" : given.join(" and ");
    throw new TypeError(`options: expected {segments}, {tolerance} or {pixels, viewProjection, viewport}, got ${got}`);
  }
  const extraView = VIEW.find((name) => detail[name] !== undefined);
  if (detail.pixels === undefined && extraView) throw new TypeError(`${extraView}: expected pixels, got ${given[0]}`);
  if (detail.segments !== undefined) {
    const { u, v } = segmentsOf(detail.segments);
    return { kind: SEGMENTS, a: u, b: v };
  }
  if (detail.tolerance !== undefined) return { kind: TOLERANCE, a: check.positive(detail.tolerance, "tolerance") };
  return { kind: PIXELS, a: check.positive(detail.pixels, "pixels"), extra: viewNumbers(detail) };
}

/**
 * @param {Record<string, any>} view
 * @returns {number[]}
 */
function viewNumbers({ viewProjection, viewport }) {
  const matrix = check.matrixNumbers(viewProjection, "viewProjection");
  if (matrix.length !== 16) throw new RangeError(`viewProjection: expected 16 numbers, got ${matrix.length}`);
  if (!check.isList(viewport))
    throw new TypeError(`viewport: expected [width, height], got ${check.describe(viewport)}`);
  if (viewport.length !== 2) throw new RangeError(`viewport: expected 2 numbers, got ${viewport.length}`);
  return [...matrix, check.positive(viewport[0], "viewport[0]"), check.positive(viewport[1], "viewport[1]")];
}
