import { core, instance, memory } from "./init.js";

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
 * @returns {Float64Array}
 */
export function arena(length) {
  const view = instance.view;
  return view.length >= length ? view : reserve(length);
}

/**
 * @param {number} length
 * @returns {Float64Array}
 */
function reserve(length) {
  const address = core().arena_reserve(length);
  return (instance.view = new Float64Array(memory().buffer, address, core().arena_length()));
}

/**
 * Gives the memory of a large result back to the core's allocator. Every earlier view is void: ask again.
 *
 * @internal
 */
export function trimArena() {
  core().arena_trim();
  instance.view = new Float64Array(0);
}
