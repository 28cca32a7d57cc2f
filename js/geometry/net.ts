// Nets of patches as arguments: flat lists of points, or rows of points.
import * as check from "./check.js";
import { describe } from "./describe.js";
import { flatten } from "./points.js";
import type { PatchData } from "./brand.js";
import type { PointsLike } from "./check.js";

/**
 * The control points of a patch: a flat list in which u runs along the fast index (the point Pᵢⱼ has the index
 * j·(degreeU + 1) + i), or one array of degreeU + 1 points for each j.
 */
export type NetLike = PointsLike | ArrayLike<PointsLike>;

/**
 * The degree that the length of a list of rows, or of its first row, gives.
 *
 * @internal
 * @returns 3 for a flat list
 */
export function degreeOfRows(net: unknown, direction: "u" | "v"): number {
  if (!isNested(net)) return 3;
  const list = direction === "v" ? net : net[0];
  return check.isList(list) && list.length >= 2 && list.length <= 65 ? list.length - 1 : 3;
}

/**
 * The coordinates of a net, checked.
 *
 * @internal
 */
export function netNumbers(net: NetLike, degreeU: number, degreeV: number): Float64Array {
  const [columns, rows] = [degreeU + 1, degreeV + 1];
  const degrees = `degrees ${degreeU} × ${degreeV}`;
  if (isNested(net)) {
    if (net.length !== rows) {
      throw new RangeError(`net: expected ${rows} rows of ${columns} points (${degrees}), got ${net.length} rows`);
    }
    return flatRows(net, columns, "net");
  }
  const { flat } = flatten(net as PointsLike, 3, 3, "net");
  const [count, needed] = [flat.length / 3, columns * rows];
  if (count === needed) return flat;
  const order = `in rows of ${columns} along u`;
  throw new RangeError(`net: expected ${needed} control points ${order} (${degrees}), got ${count}`);
}

/**
 * Whether a net consists of rows: its elements are arrays of points, not of numbers.
 *
 * @internal
 */
export function isNested(net: unknown): net is ArrayLike<unknown> {
  if (!Array.isArray(net) || !Array.isArray(net[0])) return false;
  return check.isList(net[0][0]) || (typeof net[0][0] === "object" && net[0][0] !== null);
}

/**
 * The coordinates of rows of points, checked.
 *
 * @internal
 */
export function flatRows(rows: ArrayLike<unknown>, columns: number, name: string): Float64Array {
  const all = new Float64Array(3 * columns * rows.length);
  for (let j = 0; j < rows.length; j++) {
    const row = rows[j];
    if (!check.isList(row))
      throw new TypeError(`${name}[${j}]: expected a row of ${columns} points, got ${describe(row)}`);
    const { flat } = flatten(row as PointsLike, 3, 3, `${name}[${j}]`);
    if (flat.length !== 3 * columns) {
      throw new RangeError(`${name}[${j}]: expected a row of ${columns} points, got ${flat.length / 3}`);
    }
    all.set(flat, 3 * columns * j);
  }
  return all;
}

/**
 * The net and the degrees of the arguments of a constructor.
 *
 * @internal
 */
export function netData(net: NetLike, options?: { degreeU?: number; degreeV?: number }): PatchData {
  const { degreeU = degreeOfRows(net, "u"), degreeV = degreeOfRows(net, "v") } = check.options(options, [
    "degreeU",
    "degreeV",
  ]);
  check.whole(degreeU, "degreeU", 1, 64);
  check.whole(degreeV, "degreeV", 1, 64);
  return { flat: netNumbers(net, degreeU, degreeV), degreeU, degreeV };
}
