import { functions, initSync } from "./glue/core.js";
import { wasmBytes } from "./wasm-bytes.js";

/**
 * Where the wasm module comes from: compiled, as bytes, as an HTTP answer, as a URL to fetch, or a promise of these.
 *
 * @typedef {WebAssembly.Module | BufferSource | Response | URL} WasmSource
 */

/**
 * One coordinate at t of a cubic with the coordinates a, b, c and d.
 *
 * @internal
 * @typedef {(a: number, b: number, c: number, d: number, t: number) => number} CubicEval
 */

/**
 * The one running instance of the core, and the arena's view (see `arena`). All state of the package is here.
 *
 * @internal
 * @type {{ functions: typeof functions | null, memory: WebAssembly.Memory | null, view: Float64Array,
 *   cubicEval: CubicEval | null }}
 */
export const instance = { functions: null, memory: null, view: new Float64Array(0), cubicEval: null };

/**
 * Compiles the core ahead of its first use, without blocking. Never needed with `casteljau`, where the first call
 * does the same synchronously; needed once with `casteljau/slim`, which carries no wasm and must be given it:
 *
 *     await init(fetch(new URL("casteljau/casteljau.wasm", import.meta.url)));
 *
 * Further calls do nothing. After a failure it can be called again.
 *
 * @param {WasmSource | PromiseLike<WasmSource>} [source] with `casteljau`, left out: the bytes inside the package
 * @returns {Promise<void>}
 * @throws {TypeError} when the source is of none of these kinds, or is missing where it is needed
 */
export async function init(source) {
  const given = await source; // awaited in any case, so that a failed fetch is never left unhandled
  if (instance.functions) return;
  const module = await compile(given ?? inlined());
  if (!instance.functions) start(module); // a synchronous first call may have come in between
}

/**
 * The functions of the Rust core, started at the first call. A count of −1 says that the core refused (see `take`).
 *
 * @internal
 * @returns {typeof functions}
 * @throws {Error} with `casteljau/slim`, before `init` has ended
 */
export function core() {
  return instance.functions ?? startNow();
}

/**
 * The one function of the core that is exported without a wrapper.
 *
 * @internal
 * @returns {CubicEval}
 */
export function cubicEval() {
  return instance.cubicEval ?? (startNow(), /** @type {CubicEval} */ (/** @type {unknown} */ (instance.cubicEval)));
}

/**
 * The core's memory. Views of it die when it grows: never keep one across a call.
 *
 * @internal
 * @returns {WebAssembly.Memory}
 */
export function memory() {
  return instance.memory ?? (startNow(), /** @type {WebAssembly.Memory} */ (/** @type {unknown} */ (instance.memory)));
}

/** @returns {typeof functions} */
function startNow() {
  if (!wasmBytes) {
    throw new Error("casteljau/slim carries no wasm: await init(module, bytes or response) before the first call");
  }
  return start(new WebAssembly.Module(wasmBytes()));
}

/**
 * @param {WebAssembly.Module} module
 * @returns {typeof functions}
 */
function start(module) {
  const exports = initSync({ module });
  instance.memory = exports.memory;
  instance.cubicEval = exports.cubic_eval;
  return (instance.functions = functions);
}

/** @returns {Uint8Array<ArrayBuffer>} */
function inlined() {
  if (wasmBytes) return wasmBytes();
  throw new TypeError("casteljau/slim: init expects a WebAssembly.Module, bytes, a Response or a URL, got nothing");
}

/**
 * @param {WasmSource} source
 * @returns {Promise<WebAssembly.Module>}
 */
async function compile(source) {
  if (source instanceof WebAssembly.Module) return source;
  if (source instanceof ArrayBuffer || ArrayBuffer.isView(source)) return WebAssembly.compile(source);
  if (typeof URL === "function" && source instanceof URL) return compileResponse(await fetch(source));
  if (typeof Response === "function" && source instanceof Response) return compileResponse(source);
  throw new TypeError(
    `init: source must be a WebAssembly.Module, bytes, a Response or a URL, or a promise of one, got ${kindOf(source)}`,
  );
}

/**
 * Compiles while it arrives, where the server names the type of wasm files; else from the whole body.
 *
 * @param {Response} response
 * @returns {Promise<WebAssembly.Module>}
 */
async function compileResponse(response) {
  if (!response.ok) throw new Error(`init: ${response.url} was answered with ${response.status}`);
  const typed = response.headers.get("Content-Type")?.startsWith("application/wasm");
  if (typed && WebAssembly.compileStreaming) return WebAssembly.compileStreaming(response);
  return WebAssembly.compile(await response.arrayBuffer());
}

/**
 * @param {unknown} value
 * @returns {string}
 */
function kindOf(value) {
  return typeof value === "object" && value ? (value.constructor?.name ?? "an object") : typeof value;
}
