import { decodeBytes } from "./decode-bytes.js";

/**
 * @import { Functions } from "../glue/functions.js"
 */

/**
 * One coordinate at t of a cubic with the coordinates a, b, c and d.
 *
 * @internal
 * @typedef {(a: number, b: number, c: number, d: number, t: number) => number} CubicEval
 */

/**
 * A wasm module: its linker, its bytes if the package contains them, and, once it is instantiated, its exports and the
 * view of its arena. All state of the package is in its modules.
 *
 * @internal
 * @typedef {object} WasmModule
 * @property {(source: { module: WebAssembly.Module }) => unknown} link creates the only instance
 * @property {(() => Uint8Array<ArrayBuffer>) | null} bytes null in the slim bundle
 * @property {Functions | null} functions
 * @property {WebAssembly.Memory | null} memory
 * @property {Float64Array} view see `arena`
 * @property {CubicEval | null} cubicEval
 */

/**
 * The registered modules. A bundler drops a module that nothing uses, together with its bytes.
 *
 * @internal
 * @type {WasmModule[]}
 */
export const wasmModules = [];

/**
 * @internal
 * @param {WasmModule["link"]} link
 * @param {{ text: string, alphabet: string, frequent: number[], length: number } | WasmModule["bytes"]} source the bytes as
 *   text, or a function that gives them
 * @returns {WasmModule}
 */
export function registerModule(link, source) {
  const bytes =
    source && "text" in source
      ? () => decodeBytes(source.text, source.alphabet, source.frequent, source.length)
      : source;
  /** @type {WasmModule} */
  const wasmModule = { link, bytes, functions: null, memory: null, view: new Float64Array(0), cubicEval: null };
  wasmModules.push(wasmModule);
  return wasmModule;
}
