// Strokes, dashes, offsets of regions and rounded corners: the arguments of the methods of Path, and the calls of the core.
import * as check from "../check.js";
import { coordinatesOf } from "./path-value.js";
import { core } from "../../wasm/init.js";
import { regionsModule } from "../../wasm/regions-module.js";
import { unwrapCount } from "../../wasm/errors.js";
import { readPath, writePaths } from "./path-boolean.js";

/** @import { PointLike } from "../check.js" */

/**
 * What corners of a stroke look like: the outer sides extended to their intersection, an arc, or a straight line.
 *
 * @typedef {"miter" | "round" | "bevel"} StrokeJoin
 */

/**
 * What the ends of open subpaths look like: cut at the end, a half disk, or half a square beyond the end.
 *
 * @typedef {"butt" | "round" | "square"} StrokeCap
 */

/**
 * The options of a region's offset.
 *
 * @typedef {object} RegionOffsetOptions
 * @property {StrokeJoin} [join] "miter" by default
 * @property {number} [miterLimit] a miter that reaches farther from its corner than this many distances becomes a bevel: 4
 *   by default, at least 1
 * @property {number} [tolerance] the largest distance of the boundary from the exact one, by default 1e-4 of the size
 */

/**
 * How a stroke looks; the defaults are those of SVG.
 *
 * @typedef {object} StrokeShape
 * @property {StrokeJoin} [join] "miter" by default
 * @property {StrokeCap} [cap] "butt" by default
 * @property {number} [miterLimit] a miter that reaches farther from its corner than this many half widths becomes a bevel:
 *   4 by default, at least 1
 * @property {ArrayLike<number>} [dash] the lengths of dashes and gaps, see `dash`; none by default
 * @property {number} [dashOffset] the length in the pattern at which each subpath starts: 0 by default
 */

/**
 * The options of a stroke. `tolerance` is the largest distance of the boundary from the exact one, by default 1e-4 of the
 * diagonal of the control points' box plus the width. `simple` tells whether the result has no overlaps, true by default.
 *
 * @typedef {StrokeShape & { tolerance?: number, simple?: boolean }} StrokeOptions
 */

/** @type {readonly StrokeJoin[]} in the order of the core */
const JOINS = ["miter", "round", "bevel"];
/** @type {readonly StrokeCap[]} in the order of the core */
const CAPS = ["butt", "round", "square"];
const SHAPE = /** @type {const} */ (["join", "cap", "miterLimit", "dash", "dashOffset"]);

/**
 * @param {unknown} lengths
 * @param {string} name
 * @returns {Float64Array} finite numbers
 */
function lengthsOf(lengths, name) {
  const list = Array.isArray(lengths) || ArrayBuffer.isView(lengths);
  if (!list) {
    const hint = typeof lengths === "number" ? `; did you mean [${lengths}]?` : "";
    throw new TypeError(`${name}: expected an array of lengths, got ${check.describe(lengths)}${hint}`);
  }
  return Float64Array.from(/** @type {ArrayLike<number>} */ (lengths), (length, k) =>
    check.finite(length, `${name}[${k}]`),
  );
}

/**
 * Writes a path and the numbers of its stroke to the arena.
 *
 * @param {Float64Array} path
 * @param {Partial<StrokeOptions>} options
 * @returns {{ join: number, cap: number, dashes: number }}
 */
function writeStroke(path, options) {
  const { join = "miter", cap = "butt", miterLimit = 4, dash = [], dashOffset = 0, tolerance } = options;
  check.oneOf(join, "join", JOINS);
  check.oneOf(cap, "cap", CAPS);
  const lengths = lengthsOf(dash, "dash");
  const numbers = [check.finite(miterLimit, "miterLimit"), check.finite(dashOffset, "dashOffset")];
  writePaths([path, Float64Array.of(...numbers, check.optionalTolerance(tolerance)), lengths]);
  return { join: JOINS.indexOf(join), cap: CAPS.indexOf(cap), dashes: lengths.length };
}

/**
 * @internal
 * @param {Float64Array} path
 * @param {number} width
 * @param {StrokeOptions} [options]
 * @returns {Float64Array} a packed path
 */
export function stroke(path, width, options) {
  const checked = check.options(options, [...SHAPE, "tolerance", "simple"]);
  const simple = check.optionalBoolean(checked.simple, "simple", true);
  check.finite(width, "width");
  const { join, cap, dashes } = writeStroke(path, checked);
  return readPath(core(regionsModule).region_stroke(width, join, cap, dashes, simple));
}

/**
 * @internal
 * @param {Float64Array} path
 * @param {PointLike} point
 * @param {number} width
 * @param {StrokeShape} [options]
 * @returns {boolean}
 */
export function strokeContains(path, point, width, options) {
  const checked = check.options(options, SHAPE);
  const [x, y] = coordinatesOf(point);
  check.finite(width, "width");
  const { join, cap, dashes } = writeStroke(path, checked);
  const contains = core(regionsModule).region_stroke_contains(x, y, width, join, cap, dashes);
  return unwrapCount(contains, regionsModule) === 1;
}

/**
 * @internal
 * @param {Float64Array} path
 * @param {ArrayLike<number>} pattern
 * @param {number} [offset]
 * @returns {Float64Array} a packed path
 */
export function dash(path, pattern, offset = 0) {
  const lengths = lengthsOf(pattern, "pattern");
  check.finite(offset, "offset");
  writePaths([path, lengths]);
  return readPath(core(regionsModule).region_dash(lengths.length, offset));
}

/**
 * @internal
 * @param {Float64Array} path
 * @param {number} distance
 * @param {RegionOffsetOptions} [options]
 * @returns {Float64Array} a packed path
 */
export function offset(path, distance, options) {
  const { join = "miter", miterLimit = 4, tolerance } = check.options(options, ["join", "miterLimit", "tolerance"]);
  check.finite(distance, "distance");
  check.oneOf(join, "join", JOINS);
  check.finite(miterLimit, "miterLimit");
  const maxError = check.optionalTolerance(tolerance);
  writePaths([path]);
  return readPath(core(regionsModule).region_offset(distance, JOINS.indexOf(join), miterLimit, maxError));
}

/**
 * @internal
 * @param {Float64Array} path
 * @param {number} radius
 * @returns {Float64Array} a packed path
 */
export function roundCorners(path, radius) {
  check.finite(radius, "radius");
  writePaths([path]);
  return readPath(core(regionsModule).region_round_corners(radius));
}
