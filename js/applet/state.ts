// What the applet shows, as one immutable value. Every change goes through a function here and returns a new state;
// where curves are concerned the core does the work.
import { Spline } from "../paths.js";
import { finiteNumber, kindOf, pointsArray } from "./check.js";

export type JointMode = "free" | "g1" | "c1";

/** The view box; coordinates are in its units, y down */
export type Box = { width: number; height: number };

/** What is drawn besides curve and points. */
export interface Layers {
  /** The control polygon */
  polygon: boolean;
  /** The convex hull of each segment's control points */
  hull: boolean;
  /** De Casteljau's construction at t */
  construction: boolean;
  /** Each segment's two halves, split at t, in two colours */
  halves: boolean;
}

export interface State {
  /** All points, also the hidden ones */
  spline: Spline;
  /** How many points are shown: 4, 7, 10 … */
  shown: number;
  /** What is held at every inner joint */
  joint: JointMode;
  /** In [0, 1], the same for every segment */
  t: number;
  layers: Readonly<Layers>;
  box: Box;
}

/** One cubic: what `m` leaves. */
export const FEWEST_POINTS = 4;
/** A further cubic shares its first point with the last one before it. */
export const POINTS_PER_SEGMENT = 3;

/** The joint modes in the order of the switch. */
export const JOINT_MODES: readonly JointMode[] = ["free", "g1", "c1"];

/** The canvas of the web lesson; used where the canvas states no size of its own. */
export const DEFAULT_BOX: Box = { width: 670, height: 480 };

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

export function firstState(box: Box): State {
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

export function cubics(points: ArrayLike<number>[]): Spline {
  return new Spline(
    points.map((point) => Array.from(point)),
    { degree: 3, dimension: 2 },
  );
}

export function pointCount(state: State): number {
  return state.spline.controlPoints().length / 2;
}

/** All points, as fresh arrays. */
export function pointsOf(state: State): [number, number][] {
  return pairs(state.spline.controlPoints());
}

export function pairs(flat: ArrayLike<number>): [number, number][] {
  return Array.from({ length: flat.length / 2 }, (_, i) => [flat[2 * i], flat[2 * i + 1]]);
}

/** The same state with other points, taken as they are; a lock holds from the next move on. */
export function withPoints(state: State, points: unknown): State {
  const checked = pointsArray(points);
  const all = state.shown !== FEWEST_POINTS || pointCount(state) === FEWEST_POINTS;
  return { ...state, spline: cubics(checked), shown: all ? checked.length : FEWEST_POINTS };
}

export function withShown(state: State, count: unknown): State {
  const max = pointCount(state);
  const n = finiteNumber(count, "mode", `a number of points from 4 to ${max}: 4, 7, 10 …`);
  if (n < FEWEST_POINTS || n > max || (n - 1) % POINTS_PER_SEGMENT !== 0) {
    throw new RangeError(`mode: expected a number of points from 4 to ${max} (4, 7, 10 …), got ${n}`);
  }
  return { ...state, shown: n };
}

/** Four points when there are more to see, else all. */
export function allPointsToggled(state: State): State {
  return { ...state, shown: state.shown === FEWEST_POINTS ? pointCount(state) : FEWEST_POINTS };
}

/** Another lock; it is enforced at once, at every inner joint. */
export function withJoint(state: State, mode: unknown): State {
  const known = JOINT_MODES.find((candidate) => candidate === mode);
  if (!known) {
    const Refusal = typeof mode === "string" ? RangeError : TypeError;
    throw new Refusal(`joint: expected "free", "g1" or "c1", got ${kindOf(mode)}`);
  }
  return { ...state, joint: known, spline: locked(state.spline, known) };
}

export function locked(spline: Spline, mode: JointMode): Spline {
  const segments = (spline.controlPoints().length / 2 - 1) / POINTS_PER_SEGMENT;
  for (let joint = 1; joint < segments; joint++) spline = spline.setJoint(joint, mode);
  return spline;
}

export function withT(state: State, t: unknown): State {
  const value = finiteNumber(t, "t", "a number from 0 to 1");
  if (value < 0 || value > 1) throw new RangeError(`t: expected a number from 0 to 1, got ${value}`);
  return { ...state, t: value };
}

/**
 * @param changes some of the layers
 */
export function withLayers(state: State, changes: unknown): State {
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

/** One point moved, the lock held. */
export function withPointAt(state: State, index: number, to: [number, number]): State {
  const segments = (pointCount(state) - 1) / POINTS_PER_SEGMENT;
  const joints = Array.from({ length: segments }, () => state.joint);
  return { ...state, spline: state.spline.movePoint(index, to, { joints }) };
}

/** One more segment that ends at `point`; then all points are shown. */
export function appended(state: State, point: [number, number]): State {
  const longer = state.spline.append(point);
  const joint = (pointCount(state) - 1) / POINTS_PER_SEGMENT;
  const spline = longer.setJoint(joint, state.joint);
  return { ...state, spline, shown: spline.controlPoints().length / 2 };
}

/** The nearest place inside the view box. */
export function clamped(
  { x = 0, y = 0, width, height }: Box & { x?: number; y?: number },
  point: ArrayLike<number>,
): [number, number] {
  return [Math.min(Math.max(point[0], x), x + width), Math.min(Math.max(point[1], y), y + height)];
}

export function isInside({ width, height }: Box, point: ArrayLike<number>): boolean {
  return point[0] >= 0 && point[0] <= width && point[1] >= 0 && point[1] <= height;
}
