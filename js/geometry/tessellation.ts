import * as check from "./check.js";
import { meshInto, segmentsOf } from "./mesh.js";
import type { MatrixLike } from "./check.js";
import type { Mesh } from "./mesh.js";

/** The level of detail by a number of segments. */
export interface SegmentDetail {
  /** Cells of every patch along u and v; one number for both directions */
  segments: number | { u: number; v: number };
}

/** The level of detail by a distance. */
export interface ToleranceDetail {
  /** The largest distance from the surface to the mesh, in the surface's unit */
  tolerance: number;
}

/** The level of detail by a distance on the screen; parts outside the viewport may be coarser. */
export interface PixelDetail {
  /** The largest distance from the surface to the mesh on the screen */
  pixels: number;
  /** Maps (x, y, z, 1) to clip space: 16 numbers column-major, or an object with `elements` */
  viewProjection: MatrixLike;
  /** Width and height in pixels */
  viewport: ArrayLike<number>;
}

/** Names of options that cannot be given. */
type Without<Names extends string> = { [name in Names]?: never };

/** The level of detail of a mesh, in one of three ways. */
export type Detail =
  | (SegmentDetail & Without<keyof ToleranceDetail | keyof PixelDetail>)
  | (ToleranceDetail & Without<keyof SegmentDetail | keyof PixelDetail>)
  | (PixelDetail & Without<keyof SegmentDetail | keyof ToleranceDetail>);

/** The options of a tessellation besides the level of detail. */
export interface MeshOptions {
  /**
   * Which corners become one vertex: "position", one vertex per point; "normal", the default of surfaces, separate
   * vertices where normals differ by more than 0.1°; "none", the default of patches, separate vertices for each patch,
   * so that uvs and patch indices are defined
   */
  weld?: "position" | "normal" | "none";
  /** The type of positions and normals, "f32" by default */
  precision?: "f32" | "f64";
  /** An earlier mesh, whose arrays are reused if they are large enough */
  into?: Mesh;
}

/** The options of a tessellation: the level of detail and what mesh is made. */
export type TessellationOptions = Detail & MeshOptions;

/** The names of the options; exactly one of `DETAILS` is given. */
const DETAILS = ["segments", "tolerance", "pixels"];
const VIEW = ["viewProjection", "viewport"];
const NAMES = [...DETAILS, ...VIEW, "weld", "precision", "into"] as any;
/** In the order of the core's codes. */
const WELDS = ["position", "normal", "none"] as const;
const SEGMENTS = 0;
const TOLERANCE = 1;
const PIXELS = 2;

/**
 * The checked options of `tessellate` as arguments of the core: the kind of detail with its two numbers, the weld code
 * and the precision; `extra` is written to the arena after the surface.
 *
 * @internal
 */
export function tessellation(options: TessellationOptions, defaultWeld: "normal" | "none" = "normal") {
  const { weld = defaultWeld, precision = "f32", into, ...detail } = check.options(options, NAMES);
  const weldCode = WELDS.indexOf(check.oneOf(weld, "weld", WELDS));
  const isF64 = check.oneOf(precision, "precision", ["f32", "f64"]) === "f64";
  const { kind, a, b = 0, extra = [] } = detailNumbers(detail);
  const args = [kind, a, b, weldCode, isF64] as [number, number, number, number, boolean];
  return { args, extra, isF64, separatePatches: weld === "none", into: meshInto(into) };
}

function detailNumbers(detail: Record<string, any>): { kind: number; a: number; b?: number; extra?: number[] } {
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

function viewNumbers({ viewProjection, viewport }: Record<string, any>): number[] {
  const matrix = check.matrixNumbers(viewProjection, "viewProjection");
  if (matrix.length !== 16) throw new RangeError(`viewProjection: expected 16 numbers, got ${matrix.length}`);
  if (!check.isList(viewport))
    throw new TypeError(`viewport: expected [width, height], got ${check.describe(viewport)}`);
  if (viewport.length !== 2) throw new RangeError(`viewport: expected 2 numbers, got ${viewport.length}`);
  return [...matrix, check.positive(viewport[0], "viewport[0]"), check.positive(viewport[1], "viewport[1]")];
}
