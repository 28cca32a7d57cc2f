// The data of surfaces: reading it from the arena, and the models that the core contains.
import * as check from "../check.js";
import { parseSurface } from "../../io/surface-text.js";
import { core, writeArguments, readResult, releaseMemory } from "../../wasm/surfaces-transfer.js";

/**
 * The parts of the teapot, its height and the axis that points up.
 *
 * @typedef {object} TeapotOptions
 * @property {boolean} [rim] true by default, as all parts
 * @property {boolean} [body]
 * @property {boolean} [handle]
 * @property {boolean} [spout]
 * @property {boolean} [lid]
 * @property {boolean} [bottom]
 * @property {"squashed" | "original"} [height] "squashed" (3.15) by default; "original" is 4/3 as tall
 * @property {"z" | "y"} [up] "z" by default
 */

/**
 * The nets of a surface: the vertices; for each vertex the index of the first one that had the same position when the
 * surface was created (`joined`); two degrees for each patch; the vertex indices of all nets, one net after the other.
 *
 * @typedef {{ vertices: Float64Array, joined: Float64Array, degrees: number[], indices: Uint32Array }} Network
 */

/** In the order of the core's bits. */
const PARTS = /** @type {const} */ (["rim", "body", "handle", "spout", "lid", "bottom"]);
const TEAPOT_OPTIONS = /** @type {const} */ ([...PARTS, "height", "up"]);

/**
 * A network that is already checked: constructors accept it from inside the package.
 *
 * @internal
 */
export class CheckedNetwork {
  /** @param {Network} network */
  constructor(network) {
    this.network = network;
  }
}

/**
 * See `Surface.teapot`.
 *
 * @internal
 * @param {TeapotOptions} [options]
 * @returns {Network}
 */
export function teapotNetwork(options) {
  const checked = check.options(options, TEAPOT_OPTIONS);
  const height = check.oneOf(checked.height ?? "squashed", "height", ["squashed", "original"]);
  const up = upAxis(checked.up);
  const bits = PARTS.reduce(
    (sum, part, k) => (check.optionalBoolean(checked[part], part, true) ? sum | (1 << k) : sum),
    0,
  );
  return readNetwork(core().surface_teapot(bits, height === "original", up === "y"));
}

/**
 * See `Surface.teacup` and `Surface.teaspoon`.
 *
 * @internal
 * @param {boolean} isSpoon
 * @param {{ up?: "z" | "y" }} [options]
 * @returns {Network}
 */
export function teasetNetwork(isSpoon, options) {
  return readNetwork(core().surface_teaset(isSpoon, upAxis(check.options(options, ["up"]).up) === "y"));
}

/**
 * See `Surface.parse`.
 *
 * @internal
 * @param {string} text
 * @returns {Network}
 */
export function parsedNetwork(text) {
  if (typeof text !== "string") throw new TypeError(`text: expected a string, got ${check.describe(text)}`);
  return parseSurface(text, joinedOf);
}

/**
 * Reads a surface from the arena, see `write` in src/wasm/surface.rs.
 *
 * @param {number} length
 * @returns {Network}
 */
function readNetwork(length) {
  const numbers = readResult(0, length);
  const [vertices, patches, joined] = numbers;
  const from = 3 + 2 * patches;
  const to = from + 3 * vertices;
  const end = numbers.length - joined;
  return {
    degrees: [...numbers.subarray(3, from)],
    vertices: numbers.slice(from, to),
    indices: Uint32Array.from(numbers.subarray(to, end)),
    joined: numbers.slice(end),
  };
}

/**
 * For each vertex the index of the first one with the same position.
 *
 * @internal
 * @param {Float64Array} vertices
 * @returns {Float64Array}
 */
export function joinedOf(vertices) {
  writeArguments(vertices);
  const joined = readResult(0, core().points_joined(vertices.length / 3));
  releaseMemory();
  return joined;
}

/** @param {unknown} up */
function upAxis(up = "z") {
  return check.oneOf(up, "up", ["z", "y"]);
}
