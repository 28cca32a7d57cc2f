import * as check from "./check.js";
import { meshInto, segmentsOf } from "./mesh.js";

/**
 * @import { MatrixLike } from "./check.js"
 * @import { Mesh } from "./mesh.js"
 */

/**
 * How fine a mesh must be: `segments` along u and v of every patch; `tolerance`, the largest distance from the surface to
 * the mesh, in the surface's unit; or `pixels`, that distance on the screen, where what lies outside of the picture may be
 * coarser. `viewProjection` takes (x, y, z, 1) to clip space, 16 numbers column-major; `viewport` is the width and height
 * of the picture in pixels.
 *
 * @typedef {{ segments: number | { u: number, v: number } } | { tolerance: number }
 *   | { pixels: number, viewProjection: MatrixLike, viewport: ArrayLike<number> }} Detail
 */

/**
 * How a surface becomes a mesh: its detail; `weld`, which points become one vertex ("position": all at one place; "normal",
 * the default: split where normals differ by more than 0.1°; "none": each patch has its own, so that uvs and patch numbers
 * hold); `precision`, the type of positions and normals ("f32" by default); `into`, an earlier mesh whose arrays are reused
 * where they are large enough.
 *
 * @typedef {Detail & { weld?: "position" | "normal" | "none", precision?: "f32" | "f64", into?: Mesh }} TessellationOptions
 */

/** In the order of the core's numbers. */
const WELDS = /** @type {const} */ (["position", "normal", "none"]);
const SEGMENTS = 0;
const TOLERANCE = 1;
const PIXELS = 2;

/**
 * Checked arguments of `tessellate`, as the core takes them: the kind of detail with its two numbers, the weld and the
 * precision; `extra` goes behind the surface.
 *
 * @internal
 * @param {TessellationOptions} options
 */
export function tessellation(options) {
  const { weld = "normal", precision = "f32", into, ...detail } = check.options(options);
  const how = WELDS.indexOf(check.oneOf(weld, "weld", WELDS));
  const precise = check.oneOf(precision, "precision", ["f32", "f64"]) === "f64";
  const { kind, a, b = 0, extra = [] } = detailNumbers(detail);
  const args = /** @type {[number, number, number, number, boolean]} */ ([kind, a, b, how, precise]);
  return { args, extra, precise, own: weld === "none", into: meshInto(into) };
}

/**
 * @param {Record<string, any>} given
 * @returns {{ kind: number, a: number, b?: number, extra?: number[] }}
 */
function detailNumbers(given) {
  if ("segments" in given) {
    const { u, v } = segmentsOf(given.segments);
    return { kind: SEGMENTS, a: u, b: v };
  }
  if ("tolerance" in given) return { kind: TOLERANCE, a: check.positive(given.tolerance, "tolerance") };
  if ("pixels" in given) return { kind: PIXELS, a: check.positive(given.pixels, "pixels"), extra: viewNumbers(given) };
  throw new TypeError(
    "options: expected {segments}, {tolerance} or {pixels, viewProjection, viewport}, got none of them",
  );
}

/**
 * @param {Record<string, any>} view
 * @returns {number[]}
 */
function viewNumbers({ viewProjection, viewport }) {
  const matrix = check.matrixNumbers(viewProjection, "viewProjection");
  if (matrix.length !== 16) throw new RangeError(`viewProjection: expected 16 numbers, got ${matrix.length}`);
  if (!check.isList(viewport)) throw new TypeError(`viewport: expected [width, height], got ${check.shown(viewport)}`);
  if (viewport.length !== 2) throw new RangeError(`viewport: expected 2 numbers, got ${viewport.length}`);
  return [...matrix, check.positive(viewport[0], "viewport[0]"), check.positive(viewport[1], "viewport[1]")];
}
