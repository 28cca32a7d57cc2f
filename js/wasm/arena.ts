import { curvesModule } from "./curves-module.js";
import { core, memory } from "./init.js";
import type { WasmModule } from "./wasm-module.js";

/** The memory of a result with more numbers than this is released after it was read. */
export const LARGE_RESULT = 1 << 20;

/**
 * A view of at least `length` numbers of the arena, the block of wasm memory through which all numbers pass: write the
 * arguments from its start, call the core, read the result from its start.
 *
 *     const a = arena(8);
 *     a.set(points);
 *     core().curve_tangent(2, 4, t);
 *     return { x: a[0], y: a[1] };
 *
 * If the call may allocate, or its result may be longer than the view, call `arena` again with the length of the result
 * before reading it: growing the memory detaches every view (the length of a detached view is 0, so it is too short
 * here), and a longer arena may have another address. The contents are kept. Never return a view to the user.
 *
 * @internal
 * @param wasmModule the module whose arena it is
 */
export function arena(length: number, wasmModule: WasmModule = curvesModule): Float64Array {
  const view = wasmModule.view;
  return view.length >= length ? view : reserve(length, wasmModule);
}

function reserve(length: number, wasmModule: WasmModule): Float64Array {
  const address = core(wasmModule).arena_reserve(length) >>> 0; // addresses above 2 GiB are returned as negative numbers
  const view = new Float64Array(memory(wasmModule).buffer, address, core(wasmModule).arena_length());
  wasmModule.view = view;
  return view;
}

/**
 * Returns the memory of a large result to the core's allocator. Earlier views are no longer valid: call `arena` again.
 *
 * @internal
 */
export function trimArena(wasmModule: WasmModule = curvesModule) {
  core(wasmModule).arena_trim();
  wasmModule.view = new Float64Array(0);
}
