// What the applet shows, as one immutable value. Every change goes through a function here and returns a new state;
// where curves are concerned the core does the work.
import { Spline } from "../paths.js";
import { finiteNumber, kindOf, pointsArray } from "./check.js";

/** @typedef {"free" | "g1" | "c1"} JointMode */

/** @typedef {{ width: number, height: number }} Box the view box; coordinates are in its units, y down */

/**
 * What is drawn besides curve and points.
 *
 * @typedef {object} Layers
 * @property {boolean} polygon the control polygon
 * @property {boolean} hull the convex hull of each segment's control points
 * @property {boolean} construction de Casteljau's construction at t
 * @property {boolean} halves each segment's two halves, split at t, in two colours
 */

/**
 * @typedef {object} State
 * @property {Spline} spline all points, also the hidden ones
 * @property {number} shown how many points are shown: 4, 7, 10 …
 * @property {JointMode} joint what is held at every inner joint
 * @property {number} t in [0, 1], the same for every segment
 * @property {Readonly<Layers>} layers
 * @property {Box} box
 */

/** One cubic: what `m` leaves. */
export const FEWEST_POINTS = 4;
/** A further cubic shares its first point with the last one before it. */
export const POINTS_PER_SEGMENT = 3;

/** The joint modes in the order of the switch. @type {readonly JointMode[]} */
export const JOINT_MODES = ["free", "g1", "c1"];

/** The canvas of the web lesson; used where the canvas states no size of its own. @type {Box} */
export const DEFAULT_BOX = { width: 670, height: 480 };

/** Two cubics. P2, P3 and P4 lie on one line, but P3 is not half-way: G1 and not C1. */
const DEFAULT_POINTS = [
  [70, 330],
  [110, 90],
  [235, 120],
  [325, 230],
  [433, 362],
  [590, 400],
  [600, 130],
];

/**
 * @param {Box} box
 * @returns {State}
 */
export function firstState(box) {
  const [sx, sy] = [box.width / DEFAULT_BOX.width, box.height / DEFAULT_BOX.height];
  return {
    spline: cubics(DEFAULT_POINTS.map(([x, y]) => [x * sx, y * sy])),
    shown: DEFAULT_POINTS.length,
    joint: "free",
    t: 0.5,
    layers: Object.freeze({ polygon: true, hull: false, construction: false, halves: false }),
    box,
  };
}

/**
 * @param {ArrayLike<number>[]} points
 * @returns {Spline}
 */
export function cubics(points) {
  return new Spline(
    points.map((point) => Array.from(point)),
    { degree: 3, dimension: 2 },
  );
}

/**
 * @param {State} state
 * @returns {number}
 */
export function pointCount(state) {
  return state.spline.controlPoints().length / 2;
}

/**
 * All points, as fresh arrays.
 *
 * @param {State} state
 * @returns {[number, number][]}
 */
export function pointsOf(state) {
  return pairs(state.spline.controlPoints());
}

/**
 * @param {ArrayLike<number>} flat
 * @returns {[number, number][]}
 */
export function pairs(flat) {
  return Array.from({ length: flat.length / 2 }, (_, i) => [flat[2 * i], flat[2 * i + 1]]);
}

/**
 * The same state with other points, taken as they are; a lock holds from the next move on.
 *
 * @param {State} state
 * @param {unknown} points
 * @returns {State}
 */
export function withPoints(state, points) {
  const checked = pointsArray(points);
  const all = state.shown !== FEWEST_POINTS || pointCount(state) === FEWEST_POINTS;
  return { ...state, spline: cubics(checked), shown: all ? checked.length : FEWEST_POINTS };
}

/**
 * @param {State} state
 * @param {unknown} count
 * @returns {State}
 */
export function withShown(state, count) {
  const most = pointCount(state);
  const n = finiteNumber(count, "mode", `a number of points from 4 to ${most}: 4, 7, 10 …`);
  if (n < FEWEST_POINTS || n > most || (n - 1) % POINTS_PER_SEGMENT !== 0) {
    throw new RangeError(`mode: expected a number of points from 4 to ${most} (4, 7, 10 …), got ${n}`);
  }
  return { ...state, shown: n };
}

/**
 * Four points when there are more to see, else all.
 *
 * @param {State} state
 * @returns {State}
 */
export function toggled(state) {
  return { ...state, shown: state.shown === FEWEST_POINTS ? pointCount(state) : FEWEST_POINTS };
}

/**
 * Another lock; it is enforced at once, at every inner joint.
 *
 * @param {State} state
 * @param {unknown} mode
 * @returns {State}
 */
export function withJoint(state, mode) {
  const known = JOINT_MODES.find((candidate) => candidate === mode);
  if (!known) {
    const Refusal = typeof mode === "string" ? RangeError : TypeError;
    throw new Refusal(`joint: expected "free", "g1" or "c1", got ${kindOf(mode)}`);
  }
  return { ...state, joint: known, spline: locked(state.spline, known) };
}

/**
 * @param {Spline} spline
 * @param {JointMode} mode
 * @returns {Spline}
 */
export function locked(spline, mode) {
  const segments = (spline.controlPoints().length / 2 - 1) / POINTS_PER_SEGMENT;
  for (let joint = 1; joint < segments; joint++) spline = spline.setJoint(joint, mode);
  return spline;
}

/**
 * @param {State} state
 * @param {unknown} t
 * @returns {State}
 */
export function withT(state, t) {
  const value = finiteNumber(t, "t", "a number from 0 to 1");
  if (value < 0 || value > 1) throw new RangeError(`t: expected a number from 0 to 1, got ${value}`);
  return { ...state, t: value };
}

/**
 * @param {State} state
 * @param {unknown} changes some of the layers
 * @returns {State}
 */
export function withLayers(state, changes) {
  if (typeof changes !== "object" || !changes) {
    throw new TypeError(`layers: expected an object such as { hull: true }, got ${kindOf(changes)}`);
  }
  for (const [name, value] of Object.entries(changes)) {
    if (Object.hasOwn(state.layers, name) && typeof value === "boolean") continue;
    const names = Object.keys(state.layers).join(", ");
    throw new TypeError(`layers: expected booleans named ${names}, got ${name}: ${kindOf(value)}`);
  }
  return { ...state, layers: Object.freeze({ ...state.layers, ...changes }) };
}

/**
 * One point moved, the lock held.
 *
 * @param {State} state
 * @param {number} index
 * @param {[number, number]} to
 * @returns {State}
 */
export function withPointAt(state, index, to) {
  const segments = (pointCount(state) - 1) / POINTS_PER_SEGMENT;
  const joints = Array.from({ length: segments }, () => state.joint);
  return { ...state, spline: state.spline.movePoint(index, to, { joints }) };
}

/**
 * One more segment that ends at `point`; then all points are shown.
 *
 * @param {State} state
 * @param {[number, number]} point
 * @returns {State}
 */
export function appended(state, point) {
  const longer = state.spline.append(point);
  const joint = (pointCount(state) - 1) / POINTS_PER_SEGMENT;
  const spline = longer.setJoint(joint, state.joint);
  return { ...state, spline, shown: spline.controlPoints().length / 2 };
}

/**
 * The nearest place inside the view box.
 *
 * @param {Box & { x?: number, y?: number }} box
 * @param {ArrayLike<number>} point
 * @returns {[number, number]}
 */
export function clamped({ x = 0, y = 0, width, height }, point) {
  return [Math.min(Math.max(point[0], x), x + width), Math.min(Math.max(point[1], y), y + height)];
}

/**
 * @param {Box} box
 * @param {ArrayLike<number>} point
 * @returns {boolean}
 */
export function isInside({ width, height }, point) {
  return point[0] >= 0 && point[0] <= width && point[1] >= 0 && point[1] <= height;
}
