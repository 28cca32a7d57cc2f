// The data of surfaces: reading it from the arena, and the models that the core contains.
import { surfacesModule } from "../../wasm/surfaces-module.js";
import * as check from "../check.js";
import { parseSurface } from "../../io/surface-text.js";
import type { Network } from "../brand.js";

/** The parts of the teapot, its height and the axis that points up. */
export interface TeapotOptions {
  /** True by default, as all parts */
  rim?: boolean;
  body?: boolean;
  handle?: boolean;
  spout?: boolean;
  lid?: boolean;
  bottom?: boolean;
  /** "squashed" (3.15) by default; "original" is 4/3 as tall */
  height?: "squashed" | "original";
  /** "z" by default */
  up?: "z" | "y";
}

/** In the order of the core's bits. */
const PARTS = ["rim", "body", "handle", "spout", "lid", "bottom"] as const;
const TEAPOT_OPTIONS = [...PARTS, "height", "up"] as const;

/**
 * See `Surface.teapot`.
 *
 * @internal
 */
export function teapotNetwork(options?: TeapotOptions): Network {
  const checked = check.options(options, TEAPOT_OPTIONS);
  const height = check.oneOf(checked.height ?? "squashed", "height", ["squashed", "original"]);
  const up = upAxis(checked.up);
  const bits = PARTS.reduce(
    (sum, part, k) => (check.optionalBoolean(checked[part], part, true) ? sum | (1 << k) : sum),
    0,
  );
  return readNetwork(surfacesModule.functions.surface_teapot(bits, height === "original", up === "y"));
}

/**
 * See `Surface.teacup` and `Surface.teaspoon`.
 *
 * @internal
 */
export function teasetNetwork(isSpoon: boolean, options?: { up?: "z" | "y" }): Network {
  return readNetwork(
    surfacesModule.functions.surface_teaset(isSpoon, upAxis(check.options(options, ["up"]).up) === "y"),
  );
}

/**
 * See `Surface.parse`.
 *
 * @internal
 */
export function parsedNetwork(text: string): Network {
  if (typeof text !== "string") throw new TypeError(`text: expected a string, got ${check.describe(text)}`);
  return parseSurface(text, joinedOf);
}

/** Reads a surface from the arena, see `write` in src/wasm/surface.rs. */
function readNetwork(length: number): Network {
  const numbers = surfacesModule.read(0, length);
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
 */
export function joinedOf(vertices: Float64Array): Float64Array {
  surfacesModule.write(vertices);
  const joined = surfacesModule.read(0, surfacesModule.functions.points_joined(vertices.length / 3));
  surfacesModule.release();
  return joined;
}

function upAxis(up: unknown = "z") {
  return check.oneOf(up, "up", ["z", "y"]);
}
