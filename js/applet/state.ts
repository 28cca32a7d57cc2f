// What the applet shows, as one immutable value. Every change goes through a function here and returns a new state;
// where curves are concerned the core does the work.
import { finiteNumber, kindOf, pointsArray } from "../editor/check.js";
import { cubics, firstPoints, pairs, POINTS_PER_SEGMENT } from "../editor/plane.js";
import { randomChain, roomiestAmong } from "../editor/random.js";
import type { Spline } from "../index.js";
import type { Box } from "../editor/plane.js";

export type JointMode = "free" | "g1" | "c1";

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
/** The joint modes in the order of the switch. */
export const JOINT_MODES: readonly JointMode[] = ["free", "g1", "c1"];

export function firstState(box: Box): State {
  const points = firstPoints(box);
  return {
    spline: cubics(points),
    shown: points.length,
    joint: "free",
    t: 0.5,
    layers: Object.freeze({ polygon: true, hull: false, construction: false, halves: false }),
    box,
  };
}

export function pointCount(state: State): number {
  return state.spline.controlPoints().length / 2;
}

/** All points, as fresh arrays. */
export function pointsOf(state: State): [number, number][] {
  return pairs(state.spline.controlPoints());
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

/** All points at random places inside the box, the lock held, by which no point leaves the box either. */
export function randomized(state: State, random: () => number): State {
  const segments = (pointCount(state) - 1) / POINTS_PER_SEGMENT;
  return { ...state, spline: randomChain(state.box, segments, () => state.joint, random) };
}

/** The place of a coarse grid that is farthest from all points: where there is room for a new one. */
export function roomiestPlace(state: State): [number, number] {
  return roomiestAmong(state.box, pointsOf(state));
}
