import { decodeBytes } from "./decode-bytes.js";
import type { Functions } from "../glue/functions.js";

/**
 * One coordinate at t of a cubic with the coordinates a, b, c and d.
 *
 * @internal
 */
export type CubicEval = (a: number, b: number, c: number, d: number, t: number) => number;

/** The memory of a result with more numbers than this is released after it was read. */
const LARGE_RESULT = 1 << 20;

/** Up to this many numbers, single stores take less time than a call of `set`. */
const MAX_SINGLE_COPIES = 32;

/** The number of parts of a message, two numbers each; see `Error::parts` in src/geometry/error.rs. */
const MESSAGE_PARTS = 11;

/**
 * A wasm module: its functions, and the arena, the block of its memory through which all numbers pass. Write the arguments
 * from its start, call the function, read the result from its start:
 *
 *     curvesModule.write(points);
 *     return curvesModule.read(0, curvesModule.functions.curve_derivative(2, 8));
 *
 * The first use instantiates it. All state of the package is in its modules.
 *
 * @internal
 */
export class WasmModule {
  /** Null in the slim bundle */
  bytes;
  /** Creates the only instance */
  #link;
  #functions: Functions | null = null;
  #memory: WebAssembly.Memory | null = null;
  #cubicEval: CubicEval | null = null;
  #view = new Float64Array(0);

  constructor(
    link: (source: { module: WebAssembly.Module }) => unknown,
    bytes: (() => Uint8Array<ArrayBuffer>) | null,
  ) {
    this.#link = link;
    this.bytes = bytes;
  }

  get isInstantiated() {
    return this.#functions !== null;
  }

  instantiate(module: WebAssembly.Module): Functions {
    const functions = this.#link({ module }) as any;
    this.#memory = functions.memory;
    this.#cubicEval = functions.cubic_eval;
    this.#functions = functions;
    return functions;
  }

  /**
   * The functions. A count of −1 means an error (see `count`).
   *
   * @throws {Error} with `casteljau/slim`, before the promise of `init` is fulfilled
   */
  get functions(): Functions {
    return this.#functions ?? this.#instantiateSync();
  }

  /** The only function that is called without the wrapper of wasm-bindgen. */
  get cubicEval(): CubicEval {
    if (!this.#cubicEval) this.#instantiateSync();
    return this.#cubicEval as CubicEval;
  }

  /** The memory. When it grows, its views are detached: never keep a view across a call. */
  get memory(): WebAssembly.Memory {
    if (!this.#memory) this.#instantiateSync();
    return this.#memory as WebAssembly.Memory;
  }

  #instantiateSync(): Functions {
    if (!this.bytes) {
      throw new Error("casteljau/slim carries no wasm: await init(module, bytes or response) before the first call");
    }
    return this.instantiate(compileSync(this.bytes()));
  }

  /**
   * A view of at least `length` numbers of the arena.
   *
   * If a call may allocate, or its result may be longer than the view, call `arena` again with the length of the result
   * before reading it: growing the memory detaches every view (the length of a detached view is 0, so it is too short
   * here), and a longer arena may have another address. The contents are kept. Never return a view to the user.
   */
  arena(length: number): Float64Array {
    return this.#view.length >= length ? this.#view : this.#reserve(length);
  }

  #reserve(length: number): Float64Array {
    const address = this.functions.arena_reserve(length) >>> 0; // addresses above 2 GiB are returned as negative numbers
    this.#view = new Float64Array(this.memory.buffer, address, this.functions.arena_length());
    return this.#view;
  }

  /** Returns the memory of a large result to the allocator. Earlier views are no longer valid: call `arena` again. */
  trim() {
    this.functions.arena_trim();
    this.#view = new Float64Array(0);
  }

  /** Releases the memory of a large result after it was read. */
  release() {
    if (this.#view.length > LARGE_RESULT) this.trim();
  }

  /**
   * Writes numbers to the start of the arena and reserves room for `extra` more after them.
   *
   * @returns the arena
   */
  write(numbers: Float64Array, extra = 0): Float64Array {
    const view = this.arena(numbers.length + extra);
    if (numbers.length > MAX_SINGLE_COPIES) view.set(numbers);
    else for (let i = 0; i < numbers.length; i++) view[i] = numbers[i];
    return view;
  }

  /**
   * Copies numbers from the arena to a new array.
   *
   * @param to the count that the call returned, negative for an error
   * @throws {RangeError} with the message of the error
   */
  read(from: number, to: number): Float64Array {
    const view = this.arena(this.count(to));
    if (to - from > MAX_SINGLE_COPIES) return new Float64Array(view.subarray(from, to)); // a little faster than slice()
    const numbers = new Float64Array(to - from);
    for (let i = 0; i < numbers.length; i++) numbers[i] = view[from + i];
    return numbers;
  }

  /** Copies a result that may be large from the start of the arena, and releases its memory. */
  readLarge(length: number): Float64Array {
    const result = this.read(0, length);
    this.release();
    return result;
  }

  /** Reads a polyline: the coordinates of its vertices and their parameters. */
  readPolyline(vertices: number, dimension: 2 | 3): { points: Float64Array; ts: Float64Array } {
    const end = vertices * dimension;
    const polyline = { points: this.read(0, end), ts: this.read(end, end + vertices) };
    this.release();
    return polyline;
  }

  /**
   * Copies the first numbers of the arena to an array that is long enough.
   *
   * @param length the count that the call returned, negative for an error
   * @returns `into`
   * @throws {RangeError} with the message of the error
   */
  readInto(into: Float64Array, length: number): Float64Array {
    into.set(this.arena(this.count(length)).subarray(0, length));
    if (length > LARGE_RESULT) this.release();
    return into;
  }

  /**
   * Checks the count that a call returned: −1 says that there is an error message in the arena instead of a result.
   *
   * @returns the count
   * @throws {RangeError} with the message of the error
   */
  count(count: number): number {
    if (count < 0) throw this.#error();
    return count;
  }

  /**
   * The error whose message is in the arena. A part of the message is a string (address and length) or a number (the
   * number and −1).
   */
  #error(): RangeError {
    this.#view = new Float64Array(0); // the call may have moved the arena before it failed
    const parts = this.arena(2 * MESSAGE_PARTS);
    let message = "";
    for (let i = 0; i < 2 * MESSAGE_PARTS; i += 2) {
      const [value, length] = [parts[i], parts[i + 1]];
      message += length < 0 ? value : new TextDecoder().decode(new Uint8Array(this.memory.buffer, value, length));
    }
    this.release();
    // The core uses Rust's names of parameters: degree_u is degreeU in JavaScript.
    return new RangeError(message.replace(/_([a-z])/g, (_, letter) => letter.toUpperCase()));
  }
}

/**
 * The registered modules. A bundler drops a module that nothing uses, together with its bytes.
 *
 * @internal
 */
export const wasmModules: WasmModule[] = [];

/**
 * Registers a wasm module, which is compiled before its first use.
 *
 * @internal
 * @param source the bytes as text, or a function that gives them
 */
export function registerModule(
  link: (source: { module: WebAssembly.Module }) => unknown,
  source: { text: string; alphabet: string; frequent: number[]; length: number } | WasmModule["bytes"],
): WasmModule {
  const bytes =
    source && "text" in source
      ? () => decodeBytes(source.text, source.alphabet, source.frequent, source.length)
      : source;
  const wasmModule = new WasmModule(link, bytes);
  wasmModules.push(wasmModule);
  return wasmModule;
}

/** @param bytes inlined ones */
function compileSync(bytes: BufferSource) {
  try {
    return new WebAssembly.Module(bytes);
  } catch (cause) {
    throw refusal(cause);
  }
}

/**
 * The error for inlined bytes that are not compiled. They are valid, so a policy forbids it.
 *
 * @internal
 */
export function refusal(cause: unknown) {
  const policy = "a Content-Security-Policy needs script-src 'wasm-unsafe-eval'";
  return new Error(`casteljau: WebAssembly is refused here; ${policy}`, { cause });
}
