// Isocurves of a surface, and meshes of tubes or ribbons along them.
import { surfacesModule } from "../wasm/surfaces-module.js";
import * as check from "./check.js";
import { meshInto, readMesh } from "./mesh.js";
import type { Mesh } from "./mesh.js";

/** Lines as tubes. */
export interface TubeOptions {
  /** Of the tubes, in the surface's unit */
  radius: number;
  /** Of the cross-section, at least 3; 8 by default */
  sides?: number;
  /** Strips per patch in each direction, 4 by default */
  lines?: number;
  /** An earlier mesh, whose arrays are reused if they are large enough */
  into?: Mesh;
}

/** Lines as ribbons that lie in the surface. */
export interface RibbonOptions {
  /** Of the ribbons, in the surface's unit */
  width: number;
  /** Strips per patch in each direction, 4 by default */
  lines?: number;
  /** An earlier mesh, whose arrays are reused if they are large enough */
  into?: Mesh;
}

/** The shape of the lines of a wireframe. */
export type WireframeOptions = TubeOptions | RibbonOptions;

/** The default number of strips per patch in each direction. */
const DEFAULT_LINES = 4;
const DEFAULT_SIDES = 8;
const WIREFRAME_OPTIONS = ["lines", "radius", "sides", "width", "into"] as any;
/** The largest count that can be passed to the core, which has a lower limit of its own. */
const MAX_SIDES = 0xffffffff;

/**
 * The isocurves of all patches.
 *
 * @internal
 * @param writeSurface writes the surface to the arena
 * @param options `lines`: how many strips, 4 by default
 * @returns the control points of each
 */
export function isocurves(writeSurface: () => unknown, options?: { lines?: number }): Float64Array[] {
  const lines = linesOf(options);
  writeSurface();
  const numbers = surfacesModule.read(0, surfacesModule.functions.surface_isocurves(lines));
  surfacesModule.release();
  const curves: Float64Array[] = [];
  for (let at = 0; at < numbers.length; ) {
    const end = at + 1 + 3 * numbers[at];
    curves.push(numbers.slice(at + 1, end));
    at = end;
  }
  return curves;
}

/**
 * The number of strips, checked.
 *
 * @internal
 */
export function linesOf(options: { lines?: number } | undefined): number {
  return check.segmentCount(check.options(options, ["lines"]).lines ?? DEFAULT_LINES, "lines");
}

/**
 * See `Surface.wireframe`.
 *
 * @internal
 */
export function wireframe(writeSurface: () => unknown, options: WireframeOptions): Mesh {
  const { args, into } = wireframeArguments(options);
  writeSurface();
  surfacesModule.count(surfacesModule.functions.surface_wireframe(...args));
  return readMesh(into, { separatePatches: false });
}

/**
 * The checked options of a wireframe as arguments of the core: the lines, the radius with the sides, or the width with 0.
 *
 * @internal
 */
export function wireframeArguments(options: WireframeOptions): {
  args: [number, number, number];
  into: Mesh | undefined;
} {
  const checked = check.options(options, WIREFRAME_OPTIONS) as Record<string, any>;
  const { lines = DEFAULT_LINES, radius, sides = DEFAULT_SIDES, width, into } = checked;
  if ((radius === undefined) === (width === undefined)) {
    const got = radius === undefined ? "none of them" : "both";
    throw new TypeError(`options: expected either radius (tubes) or width (ribbons), got ${got}`);
  }
  if (width !== undefined && checked.sides !== undefined) {
    throw new TypeError("sides: expected radius (tubes have sides), got width");
  }
  check.segmentCount(lines, "lines");
  check.whole(sides, "sides", 3, MAX_SIDES);
  const size = width === undefined ? check.positive(radius, "radius") : check.positive(width, "width");
  return { args: [lines, size, width === undefined ? sides : 0], into: meshInto(into) };
}
