import { decode } from "./decode-bytes.js";

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
 * The way to a wasm module: how it is linked, its bytes where they travel with the package, and, once it runs, its
 * exports and the view of its arena. All state of the package is in its gates.
 *
 * @internal
 * @typedef {object} Gate
 * @property {(source: { module: WebAssembly.Module }) => unknown} link makes the one instance of the module
 * @property {(() => Uint8Array<ArrayBuffer>) | null} bytes null in the slim bundle
 * @property {Functions | null} functions
 * @property {WebAssembly.Memory | null} memory
 * @property {Float64Array} view see `arena`
 * @property {CubicEval | null} cubicEval
 */

/**
 * The gates in use. A bundler drops the gate of a part that nothing needs, and with it its bytes.
 *
 * @internal
 * @type {Gate[]}
 */
export const gates = [];

/**
 * @internal
 * @param {Gate["link"]} link
 * @param {{ text: string, alphabet: string, frequent: number[], length: number } | null} inlined
 * @returns {Gate}
 */
export function gate(link, inlined) {
  const bytes = inlined && (() => decode(inlined.text, inlined.alphabet, inlined.frequent, inlined.length));
  /** @type {Gate} */
  const made = { link, bytes, functions: null, memory: null, view: new Float64Array(0), cubicEval: null };
  gates.push(made);
  return made;
}
