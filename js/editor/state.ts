// What `<bezier-applet>` shows, as one immutable value. Every change goes through a function here, in schema.ts or in
// commands.ts and returns a new state; what is refused changes nothing.
import { kindOf } from "./check.js";
import { DEFAULT_BOX, firstPoints, pointPair } from "./plane.js";
import { translatedTable } from "./translations.js";

export type JointMode = "free" | "g1" | "c1" | "c2" | "g2" | "auto";
export type Basis = (typeof BASES)[number];
export type Labels = (typeof LABELS)[number];
export type LayerName = (typeof LAYER_NAMES)[number];
/** In the box's units, y down */
export type Point2 = [number, number];
/** The part of the plane that is seen */
export type View = { x: number; y: number; width: number; height: number };

export interface State {
  /** The picture's own size */
  box: { width: number; height: number };
  /** What is seen of the plane, with the box's proportions */
  view: View;
  /** All of them, also the hidden ones */
  points: readonly Point2[];
  /** How many points are shown */
  shown: number;
  basis: Basis;
  /** Of the points, as many as these, for rational curves of the basis "bezier"; none for curves without weights */
  weights: readonly number[];
  /** 16 numbers, row-major, for the basis "matrix" */
  matrix: readonly number[];
  /** "n": one curve through the first point to the last */
  degree: number | "n";
  /** Of the inner joints; the last holds for all further ones */
  joints: readonly JointMode[];
  t: number;
  /** The piece that t, split and insert are about */
  segment: number;
  layers: ReadonlySet<LayerName>;
  /** The notation */
  labels: Labels;
  /** Of the subdivision, in the box's units */
  tolerance: number;
  /** Of the uniform polyline */
  segments: number;
  /** Distance of the parallel */
  offset: number;
  /** Parts of equal length */
  ticks: number;
}

/** A state with the place in the plane where the user points, which is no part of the document. */
export type DrawnState = State & { pointer?: Point2 | null };

export const BASES = ["bezier", "hermite", "b-spline", "catmull-rom", "natural", "centripetal", "matrix"] as const;
export const BASIS_NAMES: Record<Basis, string> = /* @__PURE__ */ translatedTable({
  bezier: "Bézier",
  hermite: "Hermite",
  "b-spline": "B-spline",
  "catmull-rom": "Catmull–Rom",
  natural: "natural spline",
  centripetal: "centripetal",
  matrix: "own matrix",
});
export const MODES = ["free", "g1", "c1", "c2", "g2", "auto"] as readonly JointMode[];
export const LABELS = ["P0", "P1", "b0", "p0", "none"] as const;
export const LAYER_NAMES = [
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
] as const;

/** The largest degree of the core. */
export const MAX_DEGREE = 64;
/** The largest number of control points, each of which has a handle. */
export const MAX_POINTS = 500;
/** Points farther away than this cannot be seen from anywhere near the picture. */
const FARTHEST = 1e6;
/** Larger and smaller weights draw the same picture. */
export const MAX_WEIGHT = 1000;
export const MIN_WEIGHT = 1 / MAX_WEIGHT;
/** So far beyond both ends t goes where the extrapolation is shown. */
export const BEYOND = 0.5;
/** The closest view, as a share of the box: nearer than this, neighbouring numbers lie visibly apart. */
const CLOSEST = 1e-9;
/** The widest view, in boxes. */
const WIDEST = 100;

const BEZIER: readonly number[] = [-1, 3, -3, 1, 3, -6, 3, 0, -3, 3, 0, 0, 1, 0, 0, 0];

/** The two cubics of the web lesson. */
export function firstState(box: State["box"] = DEFAULT_BOX): State {
  const points = firstPoints(box);
  return {
    box,
    view: { x: 0, y: 0, ...box },
    points,
    shown: points.length,
    basis: "bezier",
    weights: [],
    matrix: BEZIER,
    degree: 3,
    joints: ["free"],
    t: 0.5,
    segment: 0,
    layers: new Set(["polygon"] as const),
    labels: "P0",
    tolerance: 0.5,
    segments: 4,
    offset: 30,
    ticks: 10,
  };
}

/**
 * Other points. Where all were shown all are shown, else as many as before.
 *
 * @param value an array of [x, y]
 */
export function withPoints(state: State, value: unknown): State {
  if (!Array.isArray(value)) throw new TypeError(`points: expected an array of [x, y], got ${kindOf(value)}`);
  if (value.length < 2 || value.length > MAX_POINTS)
    throw new RangeError(`points: expected 2 to ${MAX_POINTS} points, got ${value.length}`);
  const points = Array.from(value, (point, i) => placeIn(point, `points[${i}]`));
  const shown = state.shown === state.points.length ? points.length : Math.min(state.shown, points.length);
  return { ...state, points, shown, weights: resizedWeights(state.weights, points.length) };
}

/** A weight for each point: further points get 1. No weights stay none. */
export function resizedWeights(weights: readonly number[], count: number): readonly number[] {
  if (!weights.length || weights.length === count) return weights;
  return Array.from({ length: count }, (_, i) => weights[i] ?? 1);
}

/** The weights that are in use; null for curves without weights. */
export function weightsOf({ basis, weights }: Pick<State, "basis" | "weights">): readonly number[] | null {
  return basis === "bezier" && weights.length ? weights : null;
}

export function placeIn(value: unknown, name: string): Point2 {
  const place = pointPair(value, name);
  const far = place.find((x) => Math.abs(x) > FARTHEST);
  if (far !== undefined)
    throw new RangeError(`${name}: expected coordinates from −${FARTHEST} to ${FARTHEST}, got ${far}`);
  return place;
}

/** The range of t: beyond the ends where the extrapolation is shown. */
export function rangeOfT({ layers }: { layers: ReadonlySet<string> }): [number, number] {
  return layers.has("extrapolation") ? [-BEYOND, 1 + BEYOND] : [0, 1];
}

export function withLayers(state: State, names: Iterable<LayerName>): State {
  const layers = new Set(names);
  const [min, max] = rangeOfT({ layers });
  return { ...state, layers, t: Math.min(Math.max(state.t, min), max) };
}

export function withLayer(state: State, name: LayerName, on: boolean): State {
  return withLayers(
    state,
    LAYER_NAMES.filter((each) => (each === name ? on : state.layers.has(each))),
  );
}

/** Another part of the plane, made as wide or as high as the box's proportions want. */
export function withView(state: State, { x, y, width, height }: View): State {
  const { box } = state;
  const scale = Math.min(Math.max(width / box.width, height / box.height, CLOSEST), WIDEST);
  const size = { width: box.width * scale, height: box.height * scale };
  return { ...state, view: { x: x + (width - size.width) / 2, y: y + (height - size.height) / 2, ...size } };
}

export function withHome(state: State): State {
  return { ...state, view: { x: 0, y: 0, ...state.box } };
}

/** Enlarged about a place, which stays where it is. */
export function zoomed(state: State, factor: number, [x, y]: Point2): State {
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

/** Few points when there are more to see, else all; nothing is deleted. */
export function allPointsToggled(state: State): State {
  const few = minPoints(state);
  return { ...state, shown: state.shown === few ? state.points.length : few, segment: 0 };
}

/** The points of one curve. */
export function minPoints({ basis, degree, points }: State) {
  const count = (basis === "bezier" || basis === "b-spline") && degree !== "n" ? degree + 1 : 4;
  return Math.min(count, points.length);
}

/** How much of the box is seen: 1 at first, less when it is enlarged. */
export function scaleOf({ view, box }: State) {
  return view.width / box.width;
}

/** Whether the whole box is seen and nothing else. */
export function isHome({ view, box }: State) {
  return view.x === 0 && view.y === 0 && view.width === box.width;
}

/**
 * @param place in the box as it is seen
 * @returns in the plane
 */
export function toPlane({ view, box }: State, [x, y]: readonly number[]): Point2 {
  return [view.x + (x * view.width) / box.width, view.y + (y * view.height) / box.height];
}
