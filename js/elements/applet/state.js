// What `<bezier-applet>` shows, as one immutable value. Every change goes through a function here, in fields.js or in
// edits.js and returns a new state; what is refused changes nothing.
import { finiteNumber, kindOf, pointPair } from "../../applet/check.js";
import { DEFAULT_BOX, firstState as smallApplet, pointsOf } from "../../applet/state.js";

/** @typedef {import("../../index.js").Spline} Spline */
/** @typedef {"free" | "g1" | "c1" | "c2" | "g2" | "auto"} JointMode */
/** @typedef {typeof BASES[number]} Basis */
/** @typedef {typeof LABELS[number]} Labels */
/** @typedef {typeof LAYER_NAMES[number]} LayerName */
/** @typedef {[number, number]} Place in the box's units, y down */
/** @typedef {{ x: number, y: number, width: number, height: number }} View the part of the plane that is seen */

/**
 * @typedef {object} State
 * @property {{ width: number, height: number }} box the picture's own size
 * @property {View} view what is seen of the plane, with the box's proportions
 * @property {readonly Place[]} points all of them, also the hidden ones
 * @property {number} shown how many points are shown
 * @property {Basis} basis
 * @property {readonly number[]} matrix 16 numbers, row-major, for the basis "matrix"
 * @property {number | "n"} degree "n": one curve through the first point to the last
 * @property {readonly JointMode[]} joints of the inner joints; the last holds for all further ones
 * @property {number} t
 * @property {number} segment the piece that t, split and insert are about
 * @property {ReadonlySet<LayerName>} layers
 * @property {Labels} labels the notation
 * @property {number} tolerance of the subdivision, in the box's units
 * @property {number} segments of the uniform polyline
 * @property {number} offset distance of the parallel
 * @property {number} ticks parts of equal length
 * @property {Place | null} pointer where the user points
 */

export const BASES = /** @type {const} */ ([
  "bezier",
  "hermite",
  "b-spline",
  "catmull-rom",
  "natural",
  "centripetal",
  "matrix",
]);
/** @type {Record<Basis, string>} */
export const BASIS_NAMES = {
  bezier: "Bézier",
  hermite: "Hermite",
  "b-spline": "B-spline",
  "catmull-rom": "Catmull–Rom",
  natural: "natural spline",
  centripetal: "centripetal",
  matrix: "own matrix",
};
export const MODES = /** @type {readonly JointMode[]} */ (["free", "g1", "c1", "c2", "g2", "auto"]);
export const LABELS = /** @type {const} */ (["P0", "P1", "b0", "p0", "none"]);
export const LAYER_NAMES = /** @type {const} */ ([
  "polygon",
  "hull",
  "construction",
  "halves",
  "weights",
  "tangents",
  "normals",
  "comb",
  "bounds",
  "extrema",
  "inflections",
  "tree",
  "segments",
  "nearest",
  "offset",
  "ticks",
  "envelope",
  "extrapolation",
  "names",
]);

/** What the core goes up to. */
export const MOST_DEGREE = 64;
/** More handles than these would help nobody. */
export const MOST_POINTS = 500;
/** Points farther away than this cannot be seen from anywhere near the picture. */
const FARTHEST = 1e6;
/** So far beyond both ends t goes where the extrapolation is shown. */
export const BEYOND = 0.5;
/** The closest view, as a share of the box: nearer than this, neighbouring numbers lie visibly apart. */
const CLOSEST = 1e-9;
/** The widest view, in boxes. */
const WIDEST = 100;

/** @type {readonly number[]} */
const BEZIER = [-1, 3, -3, 1, 3, -6, 3, 0, -3, 3, 0, 0, 1, 0, 0, 0];

/**
 * The two cubics of the web lesson.
 *
 * @returns {State}
 */
export function firstState() {
  const points = pointsOf(smallApplet(DEFAULT_BOX));
  return {
    box: DEFAULT_BOX,
    view: { x: 0, y: 0, ...DEFAULT_BOX },
    points,
    shown: points.length,
    basis: "bezier",
    matrix: BEZIER,
    degree: 3,
    joints: ["free"],
    t: 0.5,
    segment: 0,
    layers: new Set(/** @type {const} */ (["polygon"])),
    labels: "P0",
    tolerance: 0.5,
    segments: 4,
    offset: 30,
    ticks: 10,
    pointer: null,
  };
}

/**
 * Other points. Where all were shown all are shown, else as many as before.
 *
 * @param {State} state
 * @param {unknown} value an array of [x, y]
 * @returns {State}
 */
export function withPoints(state, value) {
  if (!Array.isArray(value)) throw new TypeError(`points: expected an array of [x, y], got ${kindOf(value)}`);
  if (value.length < 2 || value.length > MOST_POINTS)
    throw new RangeError(`points: expected 2 to ${MOST_POINTS} points, got ${value.length}`);
  const points = Array.from(value, (point, i) => placeIn(point, `points[${i}]`));
  const shown = state.shown === state.points.length ? points.length : Math.min(state.shown, points.length);
  return { ...state, points, shown };
}

/**
 * @param {unknown} value
 * @param {string} name
 * @returns {Place}
 */
export function placeIn(value, name) {
  const place = pointPair(value, name);
  const far = place.find((x) => Math.abs(x) > FARTHEST);
  if (far !== undefined)
    throw new RangeError(`${name}: expected coordinates from −${FARTHEST} to ${FARTHEST}, got ${far}`);
  return place;
}

/**
 * @param {unknown} value
 * @param {string} name
 * @param {number} least
 * @param {number} most
 * @returns {number}
 */
export function numberIn(value, name, least, most) {
  const number = finiteNumber(value, name, `a number from ${least} to ${most}`);
  if (number < least || number > most)
    throw new RangeError(`${name}: expected a number from ${least} to ${most}, got ${number}`);
  return number;
}

/**
 * @param {unknown} value
 * @param {string} name
 * @param {number} least
 * @param {number} most
 * @returns {number}
 */
export function wholeIn(value, name, least, most) {
  const number = numberIn(value, name, least, most);
  if (!Number.isInteger(number)) throw new RangeError(`${name}: expected a whole number, got ${number}`);
  return number;
}

/**
 * @template {string} Word
 * @param {unknown} value
 * @param {string} name
 * @param {readonly Word[]} known
 * @returns {Word}
 */
export function wordIn(value, name, known) {
  const found = known.find((each) => each === value);
  if (found) return found;
  const Refusal = typeof value === "string" ? RangeError : TypeError;
  throw new Refusal(`${name}: expected ${known.join(", ")}, got ${brief(value)}`);
}

/** The most that a message shows of a refused text. */
const MOST_SHOWN = 40;

/**
 * @param {unknown} value
 * @returns {string}
 */
export function brief(value) {
  return kindOf(typeof value === "string" && value.length > MOST_SHOWN ? `${value.slice(0, MOST_SHOWN)}…` : value);
}

/**
 * The range of t: beyond the ends where the extrapolation is shown.
 *
 * @param {{ layers: ReadonlySet<string> }} state
 * @returns {[number, number]}
 */
export function rangeOfT({ layers }) {
  return layers.has("extrapolation") ? [-BEYOND, 1 + BEYOND] : [0, 1];
}

/**
 * @param {State} state
 * @param {Iterable<LayerName>} names
 * @returns {State}
 */
export function withLayers(state, names) {
  const layers = new Set(names);
  const [least, most] = rangeOfT({ layers });
  return { ...state, layers, t: Math.min(Math.max(state.t, least), most) };
}

/**
 * @param {State} state
 * @param {LayerName} name
 * @param {boolean} on
 * @returns {State}
 */
export function withLayer(state, name, on) {
  return withLayers(
    state,
    LAYER_NAMES.filter((each) => (each === name ? on : state.layers.has(each))),
  );
}

/**
 * Another part of the plane, made as wide or as high as the box's proportions want.
 *
 * @param {State} state
 * @param {View} view
 * @returns {State}
 */
export function withView(state, { x, y, width, height }) {
  const { box } = state;
  const scale = Math.min(Math.max(width / box.width, height / box.height, CLOSEST), WIDEST);
  const size = { width: box.width * scale, height: box.height * scale };
  return { ...state, view: { x: x + (width - size.width) / 2, y: y + (height - size.height) / 2, ...size } };
}

/**
 * @param {State} state
 * @returns {State}
 */
export function withHome(state) {
  return { ...state, view: { x: 0, y: 0, ...state.box } };
}

/**
 * Enlarged about a place, which stays where it is.
 *
 * @param {State} state
 * @param {number} factor
 * @param {Place} about
 * @returns {State}
 */
export function zoomed(state, factor, [x, y]) {
  const { view, box } = state;
  const ratio = Math.min(Math.max(1 / factor, (CLOSEST * box.width) / view.width), (WIDEST * box.width) / view.width);
  const next = {
    x: x + (view.x - x) * ratio,
    y: y + (view.y - y) * ratio,
    width: view.width * ratio,
    height: view.height * ratio,
  };
  return { ...state, view: next };
}

/**
 * Few points when there are more to see, else all; nothing is deleted.
 *
 * @param {State} state
 * @returns {State}
 */
export function toggled(state) {
  const few = fewest(state);
  return { ...state, shown: state.shown === few ? state.points.length : few, segment: 0 };
}

/**
 * The points of one curve.
 *
 * @param {State} state
 */
export function fewest({ basis, degree, points }) {
  const count = (basis === "bezier" || basis === "b-spline") && degree !== "n" ? degree + 1 : 4;
  return Math.min(count, points.length);
}

/** How much of the box is seen: 1 at first, less when it is enlarged. @param {State} state */
export function scaleOf({ view, box }) {
  return view.width / box.width;
}

/** Whether the whole box is seen and nothing else. @param {State} state */
export function isHome({ view, box }) {
  return view.x === 0 && view.y === 0 && view.width === box.width;
}

/**
 * @param {State} state
 * @param {readonly number[]} place in the box as it is seen
 * @returns {Place} in the plane
 */
export function toPlane({ view, box }, [x, y]) {
  return [view.x + (x * view.width) / box.width, view.y + (y * view.height) / box.height];
}
