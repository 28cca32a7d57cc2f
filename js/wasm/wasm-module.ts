import { decodeBytes } from "./decode-bytes.js";
import type { Functions } from "../glue/functions.js";

/**
 * One coordinate at t of a cubic with the coordinates a, b, c and d.
 *
 * @internal
 */
export type CubicEval = (a: number, b: number, c: number, d: number, t: number) => number;

/**
 * A wasm module: its linker, its bytes if the package contains them, and, once it is instantiated, its exports and the
 * view of its arena. All state of the package is in its modules.
 *
 * @internal
 */
export interface WasmModule {
  /** Creates the only instance */
  link: (source: { module: WebAssembly.Module }) => unknown;
  /** Null in the slim bundle */
  bytes: (() => Uint8Array<ArrayBuffer>) | null;
  functions: Functions | null;
  memory: WebAssembly.Memory | null;
  /** See `arena` */
  view: Float64Array;
  cubicEval: CubicEval | null;
}

/**
 * The registered modules. A bundler drops a module that nothing uses, together with its bytes.
 *
 * @internal
 */
export const wasmModules: WasmModule[] = [];

/**
 * @internal
 * @param source the bytes as text, or a function that gives them
 */
export function registerModule(
  link: WasmModule["link"],
  source: { text: string; alphabet: string; frequent: number[]; length: number } | WasmModule["bytes"],
): WasmModule {
  const bytes =
    source && "text" in source
      ? () => decodeBytes(source.text, source.alphabet, source.frequent, source.length)
      : source;
  const wasmModule: WasmModule = {
    link,
    bytes,
    functions: null,
    memory: null,
    view: new Float64Array(0),
    cubicEval: null,
  };
  wasmModules.push(wasmModule);
  return wasmModule;
}
