// What a page can set: each value is checked, and becomes a new state.
import { finiteNumber, kindOf } from "../editor/check.js";
import { withJoints } from "../editor/commands.js";
import { POINTS_PER_SEGMENT, pointsArray } from "../editor/plane.js";
import * as states from "../editor/state.js";
import type { State } from "../editor/state.js";

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

/** In the order of the switch. */
export const JOINT_MODES: readonly JointMode[] = ["free", "g1", "c1"];
export const LAYER_NAMES = ["polygon", "hull", "construction", "halves"] as const;
/** One cubic: what `m` leaves. */
export const MIN_POINTS = 4;

/** Other points, taken as they are; a joint mode holds from the next move on. */
export function withPoints(state: State, value: unknown): State {
  const points = pointsArray(value);
  const all = state.shown !== MIN_POINTS || state.points.length === MIN_POINTS;
  return { ...state, points, shown: all ? points.length : MIN_POINTS };
}

export function withShown(state: State, count: unknown): State {
  const max = state.points.length;
  const shown = finiteNumber(count, "visiblePoints", `a number of points from 4 to ${max}: 4, 7, 10 …`);
  if (shown < MIN_POINTS || shown > max || (shown - 1) % POINTS_PER_SEGMENT !== 0) {
    throw new RangeError(`visiblePoints: expected a number of points from 4 to ${max} (4, 7, 10 …), got ${shown}`);
  }
  return { ...state, shown };
}

/** Another joint mode; it is enforced at once, at every inner joint. */
export function withJoint(state: State, mode: unknown): State {
  const known = JOINT_MODES.find((candidate) => candidate === mode);
  if (known) return withJoints(state, [known]);
  const Refusal = typeof mode === "string" ? RangeError : TypeError;
  throw new Refusal(`joint: expected "free", "g1" or "c1", got ${kindOf(mode)}`);
}

export function withT(state: State, t: unknown): State {
  const value = finiteNumber(t, "t", "a number from 0 to 1");
  if (value < 0 || value > 1) throw new RangeError(`t: expected a number from 0 to 1, got ${value}`);
  return { ...state, t: value };
}

/** Which layers are drawn. */
export function layersOf({ layers }: State): Layers {
  return Object.fromEntries(LAYER_NAMES.map((name) => [name, layers.has(name)])) as unknown as Layers;
}

/** @param changes some of the layers */
export function withLayers(state: State, changes: unknown): State {
  if (typeof changes !== "object" || !changes) {
    throw new TypeError(`layers: expected an object such as { hull: true }, got ${kindOf(changes)}`);
  }
  const layers = layersOf(state);
  for (const [name, value] of Object.entries(changes)) {
    if (Object.hasOwn(layers, name) && typeof value === "boolean") continue;
    throw new TypeError(`layers: expected booleans named ${LAYER_NAMES.join(", ")}, got ${name}: ${kindOf(value)}`);
  }
  const all = { ...layers, ...changes };
  return states.withLayers(
    state,
    LAYER_NAMES.filter((name) => all[name]),
  );
}
