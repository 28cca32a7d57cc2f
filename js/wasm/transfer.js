// Passing numbers to the core and back.
import { arena, LARGE_RESULT, trimArena } from "./arena.js";
import { curvesModule } from "./curves-module.js";
import { unwrapCount } from "./errors.js";

/** @import { WasmModule } from "./wasm-module.js" */

/** Up to this many numbers, single stores take less time than a call of `set`. */
const MAX_SINGLE_COPIES = 32;

/**
 * Control points that are already checked: constructors accept them from inside the package.
 *
 * @internal
 */
export class CheckedPoints {
  /**
   * @param {Float64Array} flat
   * @param {2 | 3} dimension
   */
  constructor(flat, dimension) {
    this.flat = flat;
    this.dimension = dimension;
  }
}

/**
 * Writes numbers to the start of the arena and reserves room for `extra` more after them.
 *
 * @internal
 * @param {Float64Array} numbers
 * @param {number} [extra]
 * @param {WasmModule} [wasmModule]
 * @returns {Float64Array} the arena
 */
export function writeArguments(numbers, extra = 0, wasmModule = curvesModule) {
  const view = arena(numbers.length + extra, wasmModule);
  if (numbers.length > MAX_SINGLE_COPIES) view.set(numbers);
  else for (let i = 0; i < numbers.length; i++) view[i] = numbers[i];
  return view;
}

/**
 * Copies numbers from the arena to a new array.
 *
 * @internal
 * @param {number} from
 * @param {number} to the count that the call to the core returned, negative if the core reported an error
 * @param {WasmModule} [wasmModule]
 * @returns {Float64Array}
 * @throws {RangeError} with the core's message, if the core reported an error
 */
export function readResult(from, to, wasmModule = curvesModule) {
  const view = arena(unwrapCount(to, wasmModule), wasmModule);
  if (to - from > MAX_SINGLE_COPIES) return new Float64Array(view.subarray(from, to)); // a little faster than slice()
  const numbers = new Float64Array(to - from);
  for (let i = 0; i < numbers.length; i++) numbers[i] = view[from + i];
  return numbers;
}

/**
 * Copies a result that may be large from the start of the arena, and releases its memory.
 *
 * @internal
 * @param {number} length
 * @returns {Float64Array}
 */
export function readLargeResult(length) {
  const result = readResult(0, length);
  releaseMemory();
  return result;
}

/**
 * Reads a polyline from the arena.
 *
 * @internal
 * @param {number} vertices
 * @param {2 | 3} dimension
 * @returns {{ points: Float64Array, ts: Float64Array }}
 */
export function readPolyline(vertices, dimension) {
  const end = vertices * dimension;
  const polyline = { points: readResult(0, end), ts: readResult(end, end + vertices) };
  releaseMemory();
  return polyline;
}

/**
 * Copies the first numbers of the arena to an array that is long enough.
 *
 * @internal
 * @param {Float64Array} into
 * @param {number} length the count that the call to the core returned, negative if the core reported an error
 * @returns {Float64Array} `into`
 * @throws {RangeError} with the core's message, if the core reported an error
 */
export function readResultInto(into, length) {
  into.set(arena(unwrapCount(length)).subarray(0, length));
  if (length > LARGE_RESULT) releaseMemory();
  return into;
}

/**
 * Releases the memory of a large result after it was read.
 *
 * @internal
 * @param {WasmModule} [wasmModule]
 */
export function releaseMemory(wasmModule = curvesModule) {
  if (wasmModule.view.length > LARGE_RESULT) trimArena(wasmModule);
}
