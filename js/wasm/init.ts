import { refusal, wasmModules } from "./wasm-module.js";
import type { WasmModule } from "./wasm-module.js";

/**
 * Where the wasm module comes from: compiled, as bytes, as an HTTP answer, as a URL to fetch, or a promise of these.
 */
export type WasmSource = WebAssembly.Module | BufferSource | Response | URL;

/**
 * Compiles the core before its first use, asynchronously. With `casteljau` this is optional, because the first call
 * compiles it synchronously. With `casteljau/slim`, which does not contain the wasm module, call it once:
 *
 *     await init(fetch(new URL("casteljau/casteljau.wasm", import.meta.url)));
 *
 * Further calls do nothing. After a failure, it can be called again.
 *
 * @param source optional with `casteljau`, whose default is the bytes in the package
 * @throws {TypeError} if the source is of another kind, or missing with `casteljau/slim`
 */
export async function init(source?: WasmSource | PromiseLike<WasmSource>): Promise<void> {
  const awaited = await source; // always awaited, so that a failed fetch never is an unhandled rejection
  const uncompiled = wasmModules.filter((wasmModule) => !wasmModule.isInstantiated);
  if (awaited === undefined) return void (await Promise.all(uncompiled.map(compileInlined)));
  if (!uncompiled.length) return;
  const module = await compile(awaited);
  for (const wasmModule of uncompiled) if (!wasmModule.isInstantiated) wasmModule.instantiate(module);
}

async function compileInlined(wasmModule: WasmModule) {
  if (!wasmModule.bytes) {
    throw new TypeError("casteljau/slim: init expects a WebAssembly.Module, bytes, a Response or a URL, got nothing");
  }
  const module = await compile(wasmModule.bytes()).catch((cause) => {
    throw refusal(cause);
  });
  if (!wasmModule.isInstantiated) wasmModule.instantiate(module); // a synchronous first call may have instantiated it meanwhile
}

async function compile(source: WasmSource): Promise<WebAssembly.Module> {
  if (source instanceof WebAssembly.Module) return source;
  if (source instanceof ArrayBuffer || ArrayBuffer.isView(source)) return WebAssembly.compile(source);
  if (typeof URL === "function" && source instanceof URL) return compileResponse(await fetch(source));
  if (typeof Response === "function" && source instanceof Response) return compileResponse(source);
  throw new TypeError(
    `init: source must be a WebAssembly.Module, bytes, a Response or a URL, or a promise of one, got ${kindOf(source)}`,
  );
}

/**
 * Compiles the response while it arrives if the server sends the media type of wasm; otherwise after all of it arrived.
 */
async function compileResponse(response: Response): Promise<WebAssembly.Module> {
  if (!response.ok) throw new Error(`init: ${response.url} was answered with ${response.status}`);
  const typed = response.headers.get("Content-Type")?.startsWith("application/wasm");
  if (typed && WebAssembly.compileStreaming) return WebAssembly.compileStreaming(response);
  return WebAssembly.compile(await response.arrayBuffer());
}

function kindOf(value: unknown): string {
  return typeof value === "object" && value
    ? Object.prototype.toString.call(value).slice("[object ".length, -1)
    : typeof value;
}
