// Boolean operations: the arguments of the methods of Path, and the calls of the core.
import * as check from "../check.js";
import { packedPath, pathData } from "../brand.js";
import { describe } from "../describe.js";
import { extentAt } from "../../wasm/packed-path.js";
import { isEvenOdd } from "./fill-rule.js";
import { regionsModule } from "../../wasm/regions-module.js";
import type { RegionOptions } from "./fill-rule.js";

/**
 * How `Path.combine` combines regions: the points in at least one of them, in all of them, or in an odd number of them.
 */
export type BooleanOperation = "union" | "intersect" | "exclude";

/** In the order of the core */
const OPERATIONS: readonly BooleanOperation[] = ["union", "intersect", "exclude"];

function packedList(paths: unknown): Float64Array[] {
  if (!Array.isArray(paths)) throw new TypeError(`paths: expected an array of paths, got ${describe(paths)}`);
  return Array.from(paths, (path, k) => pathData(path, `paths[${k}]`));
}

/**
 * Where a packed path among numbers ends.
 *
 * @internal
 * @param start of a packed path
 * @returns the index after it
 */
export function endOfPath(numbers: Float64Array, start: number): number {
  let at = start + 1;
  for (let k = 0; k < numbers[start]; k++) at = extentAt(numbers, at).end;
  return at;
}

/**
 * Writes paths and other numbers to the arena of the module of regions, one after the other.
 *
 * @internal
 */
export function writePaths(packed: Float64Array[]) {
  const numbers = new Float64Array(packed.reduce((length, path) => length + path.length, 0));
  let at = 0;
  for (const path of packed) {
    numbers.set(path, at);
    at += path.length;
  }
  regionsModule.write(numbers);
}

/**
 * Reads a packed path from the arena, and releases the memory.
 *
 * @internal
 * @param end what a function of the core returned
 * @returns a packed path
 */
export function readPath(end: number): Float64Array {
  const packed = regionsModule.read(0, end);
  regionsModule.release();
  return packed;
}

/**
 * `Path.combine`.
 *
 * @internal
 * @returns a packed path
 */
export function combine(paths: unknown, operation: BooleanOperation, options?: RegionOptions): Float64Array {
  const packed = packedList(paths);
  check.oneOf(operation, "operation", OPERATIONS);
  const evenOdd = isEvenOdd(options);
  writePaths(packed);
  return readPath(regionsModule.functions.region_combine(OPERATIONS.indexOf(operation), packed.length, evenOdd));
}

/**
 * The methods of `Path` that combine it with others.
 *
 * @internal
 * @param further paths, and at last the options, if there are any
 * @returns a packed path
 */
export function combineWith(
  path: Float64Array,
  other: unknown,
  operation: BooleanOperation,
  further: readonly unknown[],
): Float64Array {
  const last = further.length - 1;
  const hasOptions = last >= 0 && !packedPath(further[last]);
  const evenOdd = isEvenOdd(hasOptions ? (further[last] as RegionOptions) : undefined);
  const others = further.slice(0, hasOptions ? last : undefined).map((value, k) => pathData(value, `paths[${k + 1}]`));
  const all = [path, pathData(other, "other"), ...others];
  writePaths(all);
  return readPath(regionsModule.functions.region_combine(OPERATIONS.indexOf(operation), all.length, evenOdd));
}

/**
 * `Path.subtract`.
 *
 * @internal
 * @returns a packed path
 */
export function subtract(path: Float64Array, other: unknown, options?: RegionOptions): Float64Array {
  const evenOdd = isEvenOdd(options);
  writePaths([path, pathData(other, "other")]);
  return readPath(regionsModule.functions.region_subtract(evenOdd));
}

/**
 * `Path.removeOverlaps`.
 *
 * @internal
 * @returns a packed path
 */
export function removeOverlaps(path: Float64Array, options?: RegionOptions): Float64Array {
  const evenOdd = isEvenOdd(options);
  writePaths([path]);
  return readPath(regionsModule.functions.region_combine(0, 1, evenOdd));
}

/**
 * See `Path.faces`.
 *
 * @internal
 */
export function faces(paths: unknown, options?: RegionOptions): { packed: Float64Array; inside: boolean[] }[] {
  const packed = packedList(paths);
  const evenOdd = isEvenOdd(options);
  writePaths(packed);
  const count = packed.length;
  const numbers = readPath(regionsModule.functions.region_faces(count, evenOdd));
  const found: { packed: Float64Array; inside: boolean[] }[] = [];
  for (let at = 0; at < numbers.length; ) {
    const inside = Array.from(numbers.subarray(at, at + count), (flag) => flag === 1);
    const end = endOfPath(numbers, at + count);
    found.push({ packed: numbers.slice(at + count, end), inside });
    at = end;
  }
  return found;
}

/**
 * `Path.divide`.
 *
 * @internal
 * @returns packed paths
 */
export function divide(path: Float64Array, other: unknown, options?: RegionOptions): Float64Array[] {
  const evenOdd = isEvenOdd(options);
  writePaths([path, pathData(other, "other")]);
  const numbers = readPath(regionsModule.functions.region_divide(evenOdd));
  const parts: Float64Array[] = [];
  for (let at = 0, end = 0; at < numbers.length; at = end) {
    end = endOfPath(numbers, at);
    parts.push(numbers.slice(at, end));
  }
  return parts;
}

/**
 * `Path.clip`.
 *
 * @internal
 * @returns a packed path
 */
export function clip(path: Float64Array, region: unknown, options?: RegionOptions): Float64Array {
  const evenOdd = isEvenOdd(options);
  writePaths([path, pathData(region, "region")]);
  return readPath(regionsModule.functions.region_clip(evenOdd));
}
