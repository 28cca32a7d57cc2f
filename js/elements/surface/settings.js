// The attributes as the drawing takes them: an unknown word or a number out of range counts as the default, as in HTML.

export const MODELS = /** @type {const} */ (["teapot", "teacup", "teaspoon", "patch"]);
export const SHADINGS = /** @type {const} */ (["smooth", "flat", "normals", "gaussian", "mean", "patches"]);
export const PARTS = /** @type {const} */ (["lid", "rim", "body", "handle", "spout", "bottom"]);
export const HEIGHTS = /** @type {const} */ (["squashed", "original"]);
export const AXES = /** @type {const} */ (["z", "y"]);
export const EVALUATIONS = /** @type {const} */ (["cpu", "forward", "gpu"]);
export const LAYERS = /** @type {const} */ ([
  "surface",
  "mesh",
  "isocurves",
  "tubes",
  "ribbons",
  "net",
  "casteljau",
  "place",
  "derivatives",
  "names",
]);

/** Cells along each direction of a patch. */
export const MOST_SEGMENTS = 64;
/** Strips of a patch each way that curves or tubes divide it into. */
export const MOST_LINES = 12;
/** A mesh finer than this on the screen shows nothing more. */
const LEAST_PIXELS = 0.05;
/** Of de Casteljau's algorithm: the first row, all rows, the curve across them, its point. */
export const STEPS = 4;

/** @typedef {typeof MODELS[number]} Model */
/** @typedef {typeof SHADINGS[number]} Shading */
/** @typedef {typeof PARTS[number]} Part */
/** @typedef {typeof LAYERS[number]} Layer */

/**
 * @typedef {object} Settings
 * @property {Model} model
 * @property {Set<Part>} parts
 * @property {"squashed" | "original"} height
 * @property {"z" | "y"} up
 * @property {number} segments
 * @property {Fineness} fineness
 * @property {number} lines
 * @property {Shading} shading
 * @property {Set<Layer>} layers
 * @property {"cpu" | "forward" | "gpu"} evaluation
 * @property {number} u
 * @property {number} v
 * @property {number} step
 * @property {boolean} swept
 * @property {number[] | null} probe
 */

/**
 * What makes the mesh as fine as it is: the recursion of the text, or pixels, or a tolerance, or segments, whichever comes
 * first in this order and is there.
 *
 * @typedef {{ segments: number } | { tolerance: number } | { pixels: number } | { flatness: number }} Fineness
 */

/** @typedef {Record<"model" | "parts" | "height" | "up" | "segments" | "tolerance" | "pixels" | "flatness" | "lines" | "shading" | "show" | "evaluation" | "u" | "v" | "step" | "swept" | "probe", unknown>} Attributes */

/**
 * @param {Attributes} given
 * @returns {Settings}
 */
export function settingsOf(given) {
  const segments = Math.round(number(given.segments, 1, MOST_SEGMENTS, 12));
  return {
    model: word(given.model, MODELS),
    parts: given.parts === null || given.parts === undefined ? new Set(PARTS) : words(given.parts, PARTS),
    height: word(given.height, HEIGHTS),
    up: word(given.up, AXES),
    segments,
    fineness: finenessOf(
      segments,
      number(given.tolerance, 0, Number.MAX_VALUE, 0),
      number(given.pixels, LEAST_PIXELS, 100, 0),
      number(given.flatness, 0, Number.MAX_VALUE, 0),
    ),
    lines: Math.round(number(given.lines, 1, MOST_LINES, 4)),
    shading: given.shading === "curvature" ? "gaussian" : word(given.shading, SHADINGS),
    layers: words(given.show ?? "surface", LAYERS),
    evaluation: word(given.evaluation, EVALUATIONS),
    u: number(given.u, 0, 1, 0.5),
    v: number(given.v, 0, 1, 0.5),
    step: Math.round(number(given.step, 1, STEPS, STEPS)),
    swept: Boolean(given.swept),
    probe: point(given.probe),
  };
}

/**
 * @param {number} segments
 * @param {number} tolerance
 * @param {number} pixels
 * @param {number} flatness
 * @returns {Fineness}
 */
function finenessOf(segments, tolerance, pixels, flatness) {
  return flatness > 0 ? { flatness } : pixels > 0 ? { pixels } : tolerance > 0 ? { tolerance } : { segments };
}

/**
 * @template {string} Word
 * @param {unknown} value
 * @param {readonly Word[]} known the first is the default
 * @returns {Word}
 */
function word(value, known) {
  return known.find((each) => each === value) ?? known[0];
}

/**
 * @template {string} Word
 * @param {unknown} value separated by spaces
 * @param {readonly Word[]} known
 * @returns {Set<Word>}
 */
function words(value, known) {
  const given = String(value).split(/\s+/);
  return new Set(known.filter((each) => given.includes(each)));
}

/**
 * @param {unknown} value
 * @param {number} least
 * @param {number} most
 * @param {number} otherwise
 */
function number(value, least, most, otherwise) {
  const given = value === null || value === undefined || value === "" ? NaN : Number(value);
  return Number.isNaN(given) ? otherwise : Math.min(Math.max(given, least), most);
}

/**
 * Three numbers; anything else is no point.
 *
 * @param {unknown} value
 * @returns {number[] | null}
 */
function point(value) {
  const numbers = String(value ?? "")
    .split(/[\s,]+/)
    .filter(Boolean)
    .map(Number);
  return numbers.length === 3 && numbers.every(Number.isFinite) ? numbers : null;
}

/**
 * A list of words as an attribute holds it, with one of them put in or taken out.
 *
 * @template {string} Word
 * @param {Set<Word>} chosen
 * @param {readonly Word[]} known
 * @param {Word} each
 * @param {boolean} on
 * @returns {string}
 */
export function toggled(chosen, known, each, on) {
  return known.filter((one) => (one === each ? on : chosen.has(one))).join(" ");
}
