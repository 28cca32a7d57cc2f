// Isocurves of a surface, and meshes of tubes or ribbons along them.
import * as check from "./check.js";
import { Mesh, readMesh } from "./mesh.js";
import { core, unwrapCount, readResult, releaseMemory } from "../wasm/surfaces-transfer.js";

/**
 * Lines as tubes.
 *
 * @typedef {object} TubeOptions
 * @property {number} radius of the tubes, in the surface's unit
 * @property {number} [sides] of the cross-section, at least 3; 8 by default
 * @property {number} [lines] strips per patch in each direction, 4 by default
 * @property {Mesh} [into] an earlier mesh, whose arrays are reused if they are large enough
 */

/**
 * Lines as ribbons that lie in the surface.
 *
 * @typedef {object} RibbonOptions
 * @property {number} width of the ribbons, in the surface's unit
 * @property {number} [lines] strips per patch in each direction, 4 by default
 * @property {Mesh} [into] an earlier mesh, whose arrays are reused if they are large enough
 */

/**
 * The shape of the lines of a wireframe.
 *
 * @typedef {TubeOptions | RibbonOptions} WireframeOptions
 */

/** The default number of strips per patch in each direction. */
const DEFAULT_LINES = 4;
const DEFAULT_SIDES = 8;
const WIREFRAME_OPTIONS = /** @type {any} */ (["lines", "radius", "sides", "width", "into"]);
/** The largest count that can be passed to the core, which has a lower limit of its own. */
const MAX_SIDES = 0xffffffff;

/**
 * @internal
 * @param {() => unknown} writeSurface writes the surface to the arena
 * @param {{ lines?: number }} [options] `lines`: how many strips, 4 by default
 * @returns {Float64Array[]} the control points of each
 */
export function isocurves(writeSurface, options) {
  const lines = check.segmentCount(check.options(options, ["lines"]).lines ?? DEFAULT_LINES, "lines");
  writeSurface();
  const numbers = readResult(0, core().surface_isocurves(lines));
  releaseMemory();
  const curves = [];
  for (let at = 0; at < numbers.length; ) {
    const end = at + 1 + 3 * numbers[at];
    curves.push(numbers.slice(at + 1, end));
    at = end;
  }
  return curves;
}

/**
 * @internal
 * @param {() => unknown} writeSurface
 * @param {WireframeOptions} options
 * @returns {Mesh}
 */
export function wireframe(writeSurface, options) {
  const checked = /** @type {Record<string, any>} */ (check.options(options, WIREFRAME_OPTIONS));
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
  const earlier = into === undefined ? into : check.instanceOf(into, "into", Mesh, "a Mesh");
  writeSurface();
  unwrapCount(core().surface_wireframe(lines, size, width === undefined ? sides : 0));
  return readMesh(earlier, { separatePatches: false });
}
