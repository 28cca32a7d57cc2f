import { arena, LARGE_RESULT, trimArena } from "./arena.js";
import { curves } from "./curves-module.js";
import { done } from "./errors.js";

/** @import { Gate } from "./wasm-module.js" */

/**
 * Control points that were checked: what the constructors take from inside the package.
 *
 * @internal
 */
export class Checked {
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
 * Writes numbers at the start of the arena, with room for `extra` more behind them.
 *
 * @internal
 * @param {Float64Array} flat
 * @param {number} [extra]
 * @param {Gate} [gate]
 * @returns {Float64Array} the arena
 */
export function load(flat, extra = 0, gate = curves) {
  const view = arena(flat.length + extra, gate);
  // A call of `set` costs more than a few stores.
  if (flat.length > 32) view.set(flat);
  else for (let i = 0; i < flat.length; i++) view[i] = flat[i];
  return view;
}

/**
 * Reads numbers from the arena into a new array.
 *
 * @internal
 * @param {number} from
 * @param {number} to as a call to the core returned it: negative when the core refused
 * @param {Gate} [gate]
 * @returns {Float64Array}
 * @throws {RangeError} with the core's message, when it refused
 */
export function take(from, to, gate = curves) {
  const view = arena(done(to, gate), gate);
  if (to - from > 32) return new Float64Array(view.subarray(from, to)); // a little faster than slice()
  // As in `load`.
  const numbers = new Float64Array(to - from);
  for (let i = 0; i < numbers.length; i++) numbers[i] = view[from + i];
  return numbers;
}

/**
 * Reads the first numbers of the arena into an array that is long enough.
 *
 * @internal
 * @param {Float64Array} into
 * @param {number} length as a call to the core returned it: negative when the core refused
 * @returns {Float64Array} `into`
 * @throws {RangeError} with the core's message, when it refused
 */
export function takeInto(into, length) {
  into.set(arena(done(length)).subarray(0, length));
  if (length > LARGE_RESULT) trim();
  return into;
}

/**
 * Gives the memory of a large result back, after it was read.
 *
 * @internal
 * @param {Gate} [gate]
 */
export function trim(gate = curves) {
  if (gate.view.length > LARGE_RESULT) trimArena(gate);
}
