// Boolean operations: the arguments of the methods of Path, and the calls of the core.
import * as check from "../check.js";
import { core } from "../../wasm/init.js";
import { packedPath } from "../brand.js";
import { describe } from "../describe.js";
import { extentAt } from "../../wasm/packed-path.js";
import { isEvenOdd } from "./path-measures.js";
import { regionsModule } from "../../wasm/regions-module.js";
import { readResult, releaseMemory, writeArguments } from "../../wasm/transfer.js";

/** @import { RegionOptions } from "./path-measures.js" */

/**
 * How `Path.combine` combines regions: the points in at least one of them, in all of them, or in an odd number of them.
 *
 * @typedef {"union" | "intersect" | "exclude"} BooleanOperation
 */

/** @type {readonly BooleanOperation[]} in the order of the core */
const OPERATIONS = ["union", "intersect", "exclude"];

/**
 * @param {unknown} value
 * @param {string} name
 * @returns {Float64Array}
 */
function packedOf(value, name) {
  const packed = packedPath(value);
  if (!packed) throw new TypeError(`${name}: expected a Path, got ${describe(value)}`);
  return packed;
}

/**
 * @param {unknown} paths
 * @returns {Float64Array[]}
 */
function packedList(paths) {
  if (!Array.isArray(paths)) throw new TypeError(`paths: expected an array of paths, got ${describe(paths)}`);
  return Array.from(paths, (path, k) => packedOf(path, `paths[${k}]`));
}

/**
 * @param {Float64Array} numbers
 * @param {number} start of a packed path
 * @returns {number} the index after it
 */
function endOfPath(numbers, start) {
  let at = start + 1;
  for (let k = 0; k < numbers[start]; k++) at = extentAt(numbers, at).end;
  return at;
}

/**
 * Writes paths and other numbers to the arena of the module of regions, one after the other.
 *
 * @internal
 * @param {Float64Array[]} packed
 */
export function writePaths(packed) {
  const numbers = new Float64Array(packed.reduce((length, path) => length + path.length, 0));
  let at = 0;
  for (const path of packed) {
    numbers.set(path, at);
    at += path.length;
  }
  writeArguments(numbers, 0, regionsModule);
}

/**
 * @internal
 * @param {number} end what a function of the core returned
 * @returns {Float64Array} a packed path
 */
export function readPath(end) {
  const packed = readResult(0, end, regionsModule);
  releaseMemory(regionsModule);
  return packed;
}

/**
 * @internal
 * @param {unknown} paths
 * @param {BooleanOperation} operation
 * @param {RegionOptions} [options]
 * @returns {Float64Array} a packed path
 */
export function combine(paths, operation, options) {
  const packed = packedList(paths);
  check.oneOf(operation, "operation", OPERATIONS);
  const evenOdd = isEvenOdd(options);
  writePaths(packed);
  return readPath(core(regionsModule).region_combine(OPERATIONS.indexOf(operation), packed.length, evenOdd));
}

/**
 * @internal
 * @param {Float64Array} path
 * @param {unknown} other
 * @param {BooleanOperation} operation
 * @param {readonly unknown[]} further paths, and at last the options, if there are any
 * @returns {Float64Array} a packed path
 */
export function combineWith(path, other, operation, further) {
  const last = further.length - 1;
  const hasOptions = last >= 0 && !packedPath(further[last]);
  const evenOdd = isEvenOdd(hasOptions ? /** @type {RegionOptions} */ (further[last]) : undefined);
  const others = further.slice(0, hasOptions ? last : undefined).map((value, k) => packedOf(value, `paths[${k + 1}]`));
  const all = [path, packedOf(other, "other"), ...others];
  writePaths(all);
  return readPath(core(regionsModule).region_combine(OPERATIONS.indexOf(operation), all.length, evenOdd));
}

/**
 * @internal
 * @param {Float64Array} path
 * @param {unknown} other
 * @param {RegionOptions} [options]
 * @returns {Float64Array} a packed path
 */
export function subtract(path, other, options) {
  const evenOdd = isEvenOdd(options);
  writePaths([path, packedOf(other, "other")]);
  return readPath(core(regionsModule).region_subtract(evenOdd));
}

/**
 * @internal
 * @param {Float64Array} path
 * @param {RegionOptions} [options]
 * @returns {Float64Array} a packed path
 */
export function removeOverlaps(path, options) {
  const evenOdd = isEvenOdd(options);
  writePaths([path]);
  return readPath(core(regionsModule).region_combine(0, 1, evenOdd));
}

/**
 * @internal
 * @param {unknown} paths
 * @param {RegionOptions} [options]
 * @returns {{ packed: Float64Array, inside: boolean[] }[]}
 */
export function faces(paths, options) {
  const packed = packedList(paths);
  const evenOdd = isEvenOdd(options);
  writePaths(packed);
  const count = packed.length;
  const numbers = readPath(core(regionsModule).region_faces(count, evenOdd));
  const found = [];
  for (let at = 0; at < numbers.length; ) {
    const inside = Array.from(numbers.subarray(at, at + count), (flag) => flag === 1);
    const end = endOfPath(numbers, at + count);
    found.push({ packed: numbers.slice(at + count, end), inside });
    at = end;
  }
  return found;
}

/**
 * @internal
 * @param {Float64Array} path
 * @param {unknown} other
 * @param {RegionOptions} [options]
 * @returns {Float64Array[]} packed paths
 */
export function divide(path, other, options) {
  const evenOdd = isEvenOdd(options);
  writePaths([path, packedOf(other, "other")]);
  const numbers = readPath(core(regionsModule).region_divide(evenOdd));
  const parts = [];
  for (let at = 0, end = 0; at < numbers.length; at = end) {
    end = endOfPath(numbers, at);
    parts.push(numbers.slice(at, end));
  }
  return parts;
}

/**
 * @internal
 * @param {Float64Array} path
 * @param {unknown} region
 * @param {RegionOptions} [options]
 * @returns {Float64Array} a packed path
 */
export function clip(path, region, options) {
  const evenOdd = isEvenOdd(options);
  writePaths([path, packedOf(region, "region")]);
  return readPath(core(regionsModule).region_clip(evenOdd));
}
