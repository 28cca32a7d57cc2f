// Passing numbers to the core and back.
import { arena, LARGE_RESULT, trimArena } from "./arena.js";
import { curvesModule } from "./curves-module.js";
import { unwrapCount } from "./errors.js";
import type { WasmModule } from "./wasm-module.js";

/** Up to this many numbers, single stores take less time than a call of `set`. */
const MAX_SINGLE_COPIES = 32;

/**
 * Control points that are already checked: constructors accept them from inside the package.
 *
 * @internal
 */
export class CheckedPoints {
  flat: Float64Array;
  dimension: 2 | 3;

  constructor(flat: Float64Array, dimension: 2 | 3) {
    this.flat = flat;
    this.dimension = dimension;
  }
}

/**
 * Writes numbers to the start of the arena and reserves room for `extra` more after them.
 *
 * @internal
 * @returns the arena
 */
export function writeArguments(numbers: Float64Array, extra = 0, wasmModule: WasmModule = curvesModule): Float64Array {
  const view = arena(numbers.length + extra, wasmModule);
  if (numbers.length > MAX_SINGLE_COPIES) view.set(numbers);
  else for (let i = 0; i < numbers.length; i++) view[i] = numbers[i];
  return view;
}

/**
 * Copies numbers from the arena to a new array.
 *
 * @internal
 * @param to the count that the call to the core returned, negative if the core reported an error
 * @throws {RangeError} with the core's message, if the core reported an error
 */
export function readResult(from: number, to: number, wasmModule: WasmModule = curvesModule): Float64Array {
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
 */
export function readLargeResult(length: number): Float64Array {
  const result = readResult(0, length);
  releaseMemory();
  return result;
}

/**
 * Reads a polyline from the arena.
 *
 * @internal
 */
export function readPolyline(vertices: number, dimension: 2 | 3): { points: Float64Array; ts: Float64Array } {
  const end = vertices * dimension;
  const polyline = { points: readResult(0, end), ts: readResult(end, end + vertices) };
  releaseMemory();
  return polyline;
}

/**
 * Copies the first numbers of the arena to an array that is long enough.
 *
 * @internal
 * @param length the count that the call to the core returned, negative if the core reported an error
 * @returns `into`
 * @throws {RangeError} with the core's message, if the core reported an error
 */
export function readResultInto(into: Float64Array, length: number): Float64Array {
  into.set(arena(unwrapCount(length)).subarray(0, length));
  if (length > LARGE_RESULT) releaseMemory();
  return into;
}

/**
 * Releases the memory of a large result after it was read.
 *
 * @internal
 */
export function releaseMemory(wasmModule: WasmModule = curvesModule) {
  if (wasmModule.view.length > LARGE_RESULT) trimArena(wasmModule);
}
