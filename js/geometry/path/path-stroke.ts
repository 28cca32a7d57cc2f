// Strokes, dashes, offsets of regions and rounded corners: the arguments of the methods of Path, and the calls of the core.
import * as check from "../check.js";
import { joinCode } from "../joins.js";
import { CorePath, coordinatesOf, pathFrom } from "./core-path.js";
import { regionsModule } from "../../wasm/regions-module.js";
import { readPath, writePaths } from "./path-boolean.js";
import type { PointLike } from "../check.js";
import type { StrokeJoin } from "../joins.js";
import type { PathTime } from "./path-queries.js";

/** What the ends of open subpaths look like: cut at the end, a half disk, or half a square beyond the end. */
export type StrokeCap = "butt" | "round" | "square";

/** The options of a region's offset. */
export interface RegionOffsetOptions {
  /** "miter" by default */
  join?: StrokeJoin;
  /** A miter that reaches farther from its corner than this many distances becomes a bevel: 4 by default, at least 1 */
  miterLimit?: number;
  /** The largest distance of the boundary from the exact one, by default 1e-4 of the size */
  tolerance?: number;
}

/** How a stroke looks; the defaults are those of SVG. */
export interface StrokeShape {
  /** "miter" by default */
  join?: StrokeJoin;
  /** "butt" by default */
  cap?: StrokeCap;
  /**
   * A miter that reaches farther from its corner than this many half widths becomes a bevel: 4 by default, at least 1
   */
  miterLimit?: number;
  /** The lengths of dashes and gaps, see `dash`; none by default */
  dash?: ArrayLike<number>;
  /** The length in the pattern at which each subpath starts: 0 by default */
  dashOffset?: number;
}

/**
 * The options of a stroke. `tolerance` is the largest distance of the boundary from the exact one, by default 1e-4 of the
 * diagonal of the control points' box plus the width. `simple` tells whether the result has no overlaps, true by default.
 */
export type StrokeOptions = StrokeShape & { tolerance?: number; simple?: boolean };

/**
 * Widths along each subpath: pairs of a position and a width. Positions ascend from 0, the start of the subpath, to 1, its
 * end. Before the first stop the width is that of the first one, after the last stop that of the last one.
 */
export interface WidthProfile {
  /** Pairs `[position, width]` */
  stops: readonly (readonly number[])[];
  /** Whether positions are fractions of the arc length or of t: "length" by default */
  at?: "length" | "t";
  /** "linear" by default; "smooth" has no kinks and exceeds no width */
  interpolation?: "linear" | "smooth";
}

/**
 * The radius of `roundCorners`: one for all corners, a list with one for each corner in the order of the path, or a function
 * of the corner and its index in this order. 0 leaves a corner.
 */
export type CornerRadius = number | ArrayLike<number> | ((corner: PathTime, index: number) => number);

/** The widths of a stroke on the left of the path, where its normals point (x right, y up), and on the right. */
export interface SideWidths {
  left: number;
  right: number;
}

/** The width of a stroke everywhere, at positions along each subpath, or on both sides. */
type StrokeWidth = number | WidthProfile | SideWidths;

/** The options of `roundCorners`. */
export interface CornerOptions {
  /** The largest distance of the cubics from the arcs, 1e-9 of the radius by default */
  tolerance?: number;
  /** The corners that are rounded, `{subpath, t}` with the t of a joint: all by default */
  corners?: readonly PathTime[];
}

/** The largest index that the core accepts. */
const MAX_INDEX = 2 ** 32 - 1;

/** In the order of the core */
const CAPS: readonly StrokeCap[] = ["butt", "round", "square"];
const POSITIONS = ["length", "t"] as const;
const INTERPOLATIONS = ["linear", "smooth"] as const;
const SHAPE = ["join", "cap", "miterLimit", "dash", "dashOffset"] as const;

/**
 * @returns finite numbers
 */
function lengthsOf(lengths: unknown, name: string): Float64Array {
  const list = Array.isArray(lengths) || ArrayBuffer.isView(lengths);
  if (!list) {
    const hint = typeof lengths === "number" ? `; did you mean [${lengths}]?` : "";
    throw new TypeError(`${name}: expected an array of lengths, got ${check.describe(lengths)}${hint}`);
  }
  return Float64Array.from(lengths as ArrayLike<number>, (length, k) => check.finite(length, `${name}[${k}]`));
}

function isSides(width: unknown): width is SideWidths {
  return "left" in Object(width) || "right" in Object(width);
}

/** @throws {TypeError} for a list */
function isProfile(width: unknown): width is WidthProfile {
  if (Array.isArray(width)) {
    const hint = "; did you mean { stops: [[0, 1], …] } or { left, right }?";
    throw new TypeError(`width: expected a number or a profile, got ${check.describe(width)}${hint}`);
  }
  return typeof width === "object" && width !== null;
}

/** The stops of a profile as pairs of numbers, and its kind as the core expects it; the core checks the order. */
function widthsOf(profile: WidthProfile): { stops: Float64Array; kind: number } {
  const { stops, at = "length", interpolation = "linear" } = check.options(profile, ["stops", "at", "interpolation"]);
  check.oneOf(at, "at", POSITIONS);
  check.oneOf(interpolation, "interpolation", INTERPOLATIONS);
  if (!Array.isArray(stops))
    throw new TypeError(`stops: expected a list of [position, width], got ${check.describe(stops)}`);
  const numbers = stops.flatMap((stop: unknown, k) => {
    if (!Array.isArray(stop) || stop.length !== 2)
      throw new TypeError(`stops[${k}]: expected [position, width], got ${check.describe(stop)}`);
    return [check.finite(stop[0], `stops[${k}][0]`), check.finite(stop[1], `stops[${k}][1]`)];
  });
  return { stops: Float64Array.from(numbers), kind: POSITIONS.indexOf(at) + 2 * INTERPOLATIONS.indexOf(interpolation) };
}

/** Writes a path, the numbers of its stroke and the stops of its widths to the arena. */
function writeStroke(
  path: Float64Array,
  options: Partial<StrokeOptions>,
  stops: Float64Array<ArrayBufferLike> = new Float64Array(0),
): { join: number; cap: number; dashes: number } {
  const { join = "miter", cap = "butt", miterLimit = 4, dash = [], dashOffset = 0, tolerance } = options;
  const code = joinCode(join);
  check.oneOf(cap, "cap", CAPS);
  const lengths = lengthsOf(dash, "dash");
  const numbers = [check.finite(miterLimit, "miterLimit"), check.finite(dashOffset, "dashOffset")];
  writePaths([path, Float64Array.of(...numbers, check.optionalTolerance(tolerance)), lengths, stops]);
  return { join: code, cap: CAPS.indexOf(cap), dashes: lengths.length };
}

/**
 * `Path.stroke`.
 *
 * @internal
 * @returns a packed path
 */
export function stroke(path: Float64Array, width: StrokeWidth, options?: StrokeOptions): Float64Array {
  const checked = check.options(options, [...SHAPE, "tolerance", "simple"]);
  const simple = check.optionalBoolean(checked.simple, "simple", true);
  if (isSides(width)) {
    const { left, right } = check.options(width, ["left", "right"]);
    const [a, b] = [check.finite(left, "left"), check.finite(right, "right")];
    const { join, cap, dashes } = writeStroke(path, checked);
    return readPath(regionsModule.functions.region_stroke_sides(a, b, join, cap, dashes, simple));
  }
  if (isProfile(width)) {
    const { stops, kind } = widthsOf(width);
    const { join, cap, dashes } = writeStroke(path, checked, stops);
    return readPath(regionsModule.functions.region_stroke_with(stops.length / 2, kind, join, cap, dashes, simple));
  }
  check.finite(width, "width");
  const { join, cap, dashes } = writeStroke(path, checked);
  return readPath(regionsModule.functions.region_stroke(width, join, cap, dashes, simple));
}

/**
 * See `Path.strokeContains`.
 *
 * @internal
 */
export function strokeContains(
  path: Float64Array,
  point: PointLike,
  width: StrokeWidth,
  options?: StrokeShape,
): boolean {
  const checked = check.options(options, SHAPE);
  const [x, y] = coordinatesOf(point);
  if (isSides(width)) return pathFrom(CorePath, stroke(path, width, { ...checked, simple: false })).contains(point);
  if (isProfile(width)) {
    const { stops, kind } = widthsOf(width);
    const { join, cap, dashes } = writeStroke(path, checked, stops);
    const module = regionsModule.functions;
    const answer = module.region_stroke_contains_with(x, y, stops.length / 2, kind, join, cap, dashes);
    return regionsModule.count(answer) === 1;
  }
  check.finite(width, "width");
  const { join, cap, dashes } = writeStroke(path, checked);
  const contains = regionsModule.functions.region_stroke_contains(x, y, width, join, cap, dashes);
  return regionsModule.count(contains) === 1;
}

/**
 * `Path.dash`.
 *
 * @internal
 * @returns a packed path
 */
export function dash(path: Float64Array, pattern: ArrayLike<number>, offset = 0): Float64Array {
  const lengths = lengthsOf(pattern, "pattern");
  check.finite(offset, "offset");
  writePaths([path, lengths]);
  return readPath(regionsModule.functions.region_dash(lengths.length, offset));
}

/**
 * `Path.offset`.
 *
 * @internal
 * @returns a packed path
 */
export function offset(path: Float64Array, distance: number, options?: RegionOffsetOptions): Float64Array {
  const { join = "miter", miterLimit = 4, tolerance } = check.options(options, ["join", "miterLimit", "tolerance"]);
  check.finite(distance, "distance");
  const code = joinCode(join);
  check.finite(miterLimit, "miterLimit");
  const maxError = check.optionalTolerance(tolerance);
  writePaths([path]);
  return readPath(regionsModule.functions.region_offset(distance, code, miterLimit, maxError));
}

/**
 * `Path.roundCorners`.
 *
 * @internal
 * @returns a packed path
 */
export function roundCorners(path: Float64Array, radius: CornerRadius, options?: CornerOptions): Float64Array {
  const { tolerance, corners } = check.options(options, ["tolerance", "corners"]);
  const maxError = check.optionalTolerance(tolerance);
  if (typeof radius === "number" && corners === undefined) {
    check.finite(radius, "radius");
    writePaths([path]);
    return readPath(regionsModule.functions.region_round_corners(radius, maxError, -1));
  }
  const places = corners === undefined ? cornersOf(path) : checkedCorners(corners);
  const radii = radiiAt(places, radius);
  writePaths([path, Float64Array.from(places.flatMap(({ subpath, t }, k) => [subpath, t, radii[k]]))]);
  return readPath(regionsModule.functions.region_round_corners(0, maxError, places.length));
}

/** The corners of a path that can be rounded, in its order. */
function cornersOf(path: Float64Array): PathTime[] {
  writePaths([path]);
  const numbers = readPath(regionsModule.functions.region_corners());
  return Array.from({ length: numbers.length / 2 }, (_, k) => ({ subpath: numbers[2 * k], t: numbers[2 * k + 1] }));
}

/** One radius for each corner; the core checks that those of a list are not negative. */
function radiiAt(places: PathTime[], radius: CornerRadius): ArrayLike<number> {
  if (typeof radius === "function")
    return places.map((place, k) => check.finite(radius({ ...place }, k), `radius[${k}]`));
  if (!check.isList(radius)) {
    const one = check.finite(radius, "radius");
    if (one < 0) throw new RangeError(`radius: expected a finite number, at least 0, got ${one}`);
    return places.map(() => one);
  }
  const radii = check.numbers(radius, "radius");
  if (radii.length === places.length) return radii;
  throw new RangeError(`radius: expected ${places.length} radii, one for each corner, got ${radii.length}`);
}

/** Copies of the locations of corners; the core checks whether they exist. */
function checkedCorners(corners: unknown): PathTime[] {
  if (!Array.isArray(corners))
    throw new TypeError(`corners: expected an array of locations {subpath, t}, got ${check.describe(corners)}`);
  return Array.from(corners, (corner, k) => {
    const { subpath, t } = Object(corner) as { subpath?: unknown; t?: unknown };
    return {
      subpath: check.whole(subpath, `corners[${k}].subpath`, 0, MAX_INDEX),
      t: check.finite(t, `corners[${k}].t`),
    };
  });
}
