// Paths as lists of segments (the `getPathData` of browsers) and as the `shape()` of CSS.
import * as check from "../geometry/check.js";
import { checkTolerance, draw, roundTrip, shortNumber } from "./svg-write.js";
import { CommandBuilder } from "./command-builder.js";
import { ARGUMENT_COUNTS } from "./svg-read.js";
import type { FillRule } from "../geometry/path/fill-rule.js";

/** One command of path data: its letter and its numbers. */
export interface PathSegment {
  /** A letter of SVG path data, lower case for relative coordinates */
  type: string;
  /** The numbers of one command: 2 for M, L and T, 1 for H and V, 6 for C, 4 for S and Q, 7 for A, none for Z */
  values: ArrayLike<number>;
}

/** How `toCSS` writes. */
export interface CssOptions {
  /** 0 to 100, the maximum number of digits after the decimal point; by default as many as round-trip */
  precision?: number;
  /** The largest distance of the cubics that replace segments of degrees above 3 */
  tolerance?: number;
  /** "evenodd" is written; "nonzero" is the default of CSS */
  fillRule?: FillRule;
}

/**
 * Reads the segments of `getPathData()`.
 *
 * @internal
 * @param tolerance for arcs, 0 for the default
 * @returns a packed path
 */
export function readPathData(segments: ArrayLike<PathSegment>, tolerance: number): Float64Array {
  if (!Array.isArray(segments)) {
    throw new TypeError(`segments: expected an array of {type, values}, got ${check.describe(segments)}`);
  }
  const builder = new CommandBuilder(tolerance);
  for (const [k, segment] of segments.entries()) {
    const name = `segments[${k}]`;
    const { type, values } = Object(segment) as { type?: unknown; values?: unknown };
    const code = typeof type === "string" && type.length === 1 ? type.charCodeAt(0) : 0;
    const count = code < 128 ? ARGUMENT_COUNTS[code] : -1;
    if (count < 0) throw new RangeError(`${name}.type: expected a command of path data, got ${check.describe(type)}`);
    if (k === 0 && type !== "M" && type !== "m") {
      throw new RangeError(`${name}.type: expected "M" or "m", got ${check.describe(type)}`);
    }
    const numbers = check.numbers(values ?? [], `${name}.values`);
    if (numbers.length !== count) {
      throw new RangeError(`${name}.values: expected ${count} numbers for ${type}, got ${numbers.length}`);
    }
    builder.args.set(numbers);
    if (count === 0) builder.close();
    else if (!builder.draw(code)) {
      throw new RangeError(`${name}: expected coordinates from -2^500 to 2^500 (3.27e150), got ${numbers.join(" ")}`);
    }
  }
  builder.end(false);
  return builder.packed();
}

const COMMANDS = ["", "L", "Q", "C"];

/**
 * See `Path.toPathData`.
 *
 * @internal
 */
export function pathDataOf(packed: Float64Array, options: { tolerance?: number } | undefined): PathSegment[] {
  const tolerance = check.optionalTolerance(check.options(options, ["tolerance"]).tolerance);
  checkTolerance(packed, tolerance);
  const segments: PathSegment[] = [];
  const sink = {
    move: (x: number, y: number) => void segments.push({ type: "M", values: [x, y] }),
    curve: (degree: number, list: Float64Array, at: number) =>
      void segments.push({ type: COMMANDS[degree], values: [...list.subarray(at, at + 2 * degree)] }),
    close: () => void segments.push({ type: "Z", values: [] }),
  };
  draw(packed, sink, tolerance, false);
  return segments;
}

/**
 * See `Path.toCSS`.
 *
 * @internal
 */
export function cssOf(packed: Float64Array, options: CssOptions | undefined): string {
  const { precision, tolerance, fillRule = "nonzero" } = check.options(options, ["precision", "tolerance", "fillRule"]);
  if (precision !== undefined) check.whole(precision, "precision", 0, 100);
  check.oneOf(fillRule, "fillRule", ["nonzero", "evenodd"]);
  const maxError = check.optionalTolerance(tolerance);
  checkTolerance(packed, maxError);
  const length = (x: number) => `${precision === undefined ? roundTrip(x) : shortNumber(x, precision)}px`;
  const point = (list: ArrayLike<number>, at: number) => `${length(list[at])} ${length(list[at + 1])}`;
  const commands: string[] = [];
  const sink = {
    move: (x: number, y: number) => void commands.push(`${commands.length ? "move to" : "from"} ${point([x, y], 0)}`),
    curve: (degree: number, list: Float64Array, at: number) => {
      const end = point(list, at + 2 * degree - 2);
      if (degree === 1) commands.push(`line to ${end}`);
      else if (degree === 2) commands.push(`curve to ${end} with ${point(list, at)}`);
      else commands.push(`curve to ${end} with ${point(list, at)} / ${point(list, at + 2)}`);
    },
    close: () => void commands.push("close"),
  };
  draw(packed, sink, maxError, false);
  if (commands.length === 0) return "none";
  return `shape(${fillRule === "evenodd" ? "evenodd " : ""}${commands.join(", ")})`;
}
