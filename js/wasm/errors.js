import { arena, LARGE_RESULT, trimArena } from "./arena.js";
import { curves } from "./curves-module.js";
import { memory } from "./init.js";

/** @import { Gate } from "./wasm-module.js" */

/** The number of parts of a message, two numbers each; see `Error::parts` in src/geometry/error.rs. */
const PARTS = 11;

/**
 * What a call to the core returned; a count of −1 says that it refused and left a message.
 *
 * @internal
 * @param {number} count
 * @param {Gate} [gate] where the call went
 * @returns {number} the count
 * @throws {RangeError} with the core's message, when it refused
 */
export function done(count, gate = curves) {
  if (count < 0) throw refusal(gate);
  return count;
}

/**
 * The message that the core left in place of a result: words by address and length, numbers with −1 behind them.
 *
 * @param {Gate} gate
 * @returns {RangeError}
 */
function refusal(gate) {
  gate.view = new Float64Array(0); // the call may have made the arena longer, and moved it, before it refused
  const parts = arena(2 * PARTS, gate);
  let message = "";
  for (let i = 0; i < 2 * PARTS; i += 2) {
    const [value, length] = [parts[i], parts[i + 1]];
    message += length < 0 ? value : new TextDecoder().decode(new Uint8Array(memory(gate).buffer, value, length));
  }
  if (parts.length > LARGE_RESULT) trimArena(gate);
  // The core names parameters as Rust does: degree_u is degreeU here.
  return new RangeError(message.replace(/_([a-z])/g, (_, letter) => letter.toUpperCase()));
}
