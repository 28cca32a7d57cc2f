import { decode } from "./decode.js";
import { alphabet, frequent, length, text } from "./glue/bytes.js";

/**
 * The wasm module that travels inside the JavaScript; the slim bundle has `null` here (see xtask/bundle.js).
 *
 * @internal
 * @type {(() => Uint8Array<ArrayBuffer>) | null}
 */
export const wasmBytes = () => decode(text, alphabet, frequent, length);
