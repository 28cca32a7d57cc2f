import { curves } from "./curves-module.js";
import { gates } from "./wasm-module.js";

/**
 * @import { CubicEval, Gate } from "./wasm-module.js"
 * @import { Functions } from "../glue/functions.js"
 */

/**
 * Where the wasm module comes from: compiled, as bytes, as an HTTP answer, as a URL to fetch, or a promise of these.
 *
 * @typedef {WebAssembly.Module | BufferSource | Response | URL} WasmSource
 */

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
  const waiting = gates.filter((gate) => !gate.functions);
  if (given === undefined) return void (await Promise.all(waiting.map(compileInlined)));
  if (!waiting.length) return;
  const module = await compile(given);
  for (const gate of waiting) if (!gate.functions) start(gate, module);
}

/**
 * The functions of the Rust core, started at the first call. A count of −1 says that the core refused (see `take`).
 *
 * @internal
 * @param {Gate} [gate]
 * @returns {Functions}
 * @throws {Error} with `casteljau/slim`, before `init` has ended
 */
export function core(gate = curves) {
  return gate.functions ?? startNow(gate);
}

/**
 * The one function of the core that is exported without a wrapper.
 *
 * @internal
 * @returns {CubicEval}
 */
export function cubicEval() {
  if (!curves.cubicEval) startNow(curves);
  return /** @type {CubicEval} */ (curves.cubicEval);
}

/**
 * The core's memory. Views of it die when it grows: never keep one across a call.
 *
 * @internal
 * @param {Gate} [gate]
 * @returns {WebAssembly.Memory}
 */
export function memory(gate = curves) {
  if (!gate.memory) startNow(gate);
  return /** @type {WebAssembly.Memory} */ (gate.memory);
}

/**
 * @param {Gate} gate
 * @returns {Functions}
 */
function startNow(gate) {
  if (!gate.bytes) {
    throw new Error("casteljau/slim carries no wasm: await init(module, bytes or response) before the first call");
  }
  return start(gate, new WebAssembly.Module(gate.bytes()));
}

/**
 * @param {Gate} gate
 * @param {WebAssembly.Module} module
 * @returns {Functions}
 */
function start(gate, module) {
  const exports = /** @type {any} */ (gate.link({ module }));
  gate.memory = exports.memory;
  gate.cubicEval = exports.cubic_eval;
  gate.functions = exports;
  return exports;
}

/** @param {Gate} gate */
async function compileInlined(gate) {
  if (!gate.bytes) {
    throw new TypeError("casteljau/slim: init expects a WebAssembly.Module, bytes, a Response or a URL, got nothing");
  }
  const module = await compile(gate.bytes());
  if (!gate.functions) start(gate, module); // a synchronous first call may have come in between
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
