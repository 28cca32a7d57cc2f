// Lines and arcs that approximate a path.
import * as check from "../check.js";
import { regionsModule } from "../../wasm/regions-module.js";
import { readPath, writePaths } from "./path-boolean.js";
import type { Point } from "../points.js";

/** A line or an arc of a circle. */
export interface CircularArc {
  start: Point<2>;
  end: Point<2>;
  /** The centre of the circle; null for a line */
  center: Point<2> | null;
  /** The radius; infinite for a line */
  radius: number;
  /** The angle from the x-axis to the start as seen from the centre, from −π to π; 0 for a line */
  startAngle: number;
  /** The angle to the end: larger than `startAngle` for a counter-clockwise arc (x right, y up); 0 for a line */
  endAngle: number;
}

/** The numbers of an arc: start, end, centre, radius, angles. */
const NUMBERS = 9;

/**
 * The arcs of `Path.toArcs`.
 *
 * @internal
 * @returns a list for each subpath
 */
export function arcsOf(packed: Float64Array, tolerance: number): CircularArc[][] {
  check.positive(tolerance, "tolerance");
  writePaths([packed]);
  const numbers = readPath(regionsModule.functions.region_arcs(tolerance));
  const subpaths: CircularArc[][] = [];
  for (let at = 0; at < numbers.length; ) {
    const end = at + 1 + NUMBERS * numbers[at];
    const arcs: CircularArc[] = [];
    for (let k = at + 1; k < end; k += NUMBERS) arcs.push(arcAt(numbers, k));
    subpaths.push(arcs);
    at = end;
  }
  return subpaths;
}

function arcAt(numbers: Float64Array, at: number): CircularArc {
  const [x0, y0, x1, y1, cx, cy, radius, startAngle, endAngle] = numbers.subarray(at, at + NUMBERS);
  const center = radius === Infinity ? null : { x: cx, y: cy };
  return { start: { x: x0, y: y0 }, end: { x: x1, y: y1 }, center, radius, startAngle, endAngle };
}
