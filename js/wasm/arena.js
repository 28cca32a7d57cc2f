import { curves } from "./curves-module.js";
import { core, memory } from "./init.js";

/** @import { Gate } from "./wasm-module.js" */

/** Above this many numbers the arena gives its memory back after a result was read. */
export const LARGE_RESULT = 1 << 20;

/**
 * A view of at least `length` numbers over the arena, the block of wasm memory through which all numbers pass:
 * write the arguments from its start, call the core, read the result from its start.
 *
 *     const a = arena(8);
 *     a.set(points);
 *     core().curve_tangent(2, 4, t);
 *     return { x: a[0], y: a[1] };
 *
 * Where a call may allocate or its result may be longer than the view, ask again with the result's length before
 * reading: growing memory empties every view of it (so that its length, 0, is too small here), and a longer arena
 * may lie elsewhere. The contents survive. Never hand a view out.
 *
 * @internal
 * @param {number} length
 * @param {Gate} [gate] whose arena
 * @returns {Float64Array}
 */
export function arena(length, gate = curves) {
  const view = gate.view;
  return view.length >= length ? view : reserve(length, gate);
}

/**
 * @param {number} length
 * @param {Gate} gate
 * @returns {Float64Array}
 */
function reserve(length, gate) {
  const address = core(gate).arena_reserve(length) >>> 0; // above 2 GiB it comes as a negative number
  const view = new Float64Array(memory(gate).buffer, address, core(gate).arena_length());
  gate.view = view;
  return view;
}

/**
 * Gives the memory of a large result back to the core's allocator. Every earlier view is void: ask again.
 *
 * @internal
 * @param {Gate} [gate]
 */
export function trimArena(gate = curves) {
  core(gate).arena_trim();
  gate.view = new Float64Array(0);
}
