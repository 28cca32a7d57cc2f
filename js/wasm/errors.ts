// Errors that the core reports.
import { arena, LARGE_RESULT, trimArena } from "./arena.js";
import { curvesModule } from "./curves-module.js";
import { memory } from "./init.js";
import type { WasmModule } from "./wasm-module.js";

/** The number of parts of a message, two numbers each; see `Error::parts` in src/geometry/error.rs. */
const MESSAGE_PARTS = 11;

/**
 * Checks the count that a call to the core returned: −1 says that the core left an error message instead of a result.
 *
 * @internal
 * @param wasmModule the module that was called
 * @returns the count
 * @throws {RangeError} with the core's message
 */
export function unwrapCount(count: number, wasmModule: WasmModule = curvesModule): number {
  if (count < 0) throw coreError(wasmModule);
  return count;
}

/**
 * The error whose message is in the arena. A part of the message is a string (address and length) or a number (the
 * number and −1).
 */
function coreError(wasmModule: WasmModule): RangeError {
  wasmModule.view = new Float64Array(0); // the call may have moved the arena before it failed
  const parts = arena(2 * MESSAGE_PARTS, wasmModule);
  let message = "";
  for (let i = 0; i < 2 * MESSAGE_PARTS; i += 2) {
    const [value, length] = [parts[i], parts[i + 1]];
    message += length < 0 ? value : new TextDecoder().decode(new Uint8Array(memory(wasmModule).buffer, value, length));
  }
  if (parts.length > LARGE_RESULT) trimArena(wasmModule);
  // The core uses Rust's names of parameters: degree_u is degreeU in JavaScript.
  return new RangeError(message.replace(/_([a-z])/g, (_, letter) => letter.toUpperCase()));
}
