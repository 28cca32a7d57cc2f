// Everything that is shown and is not in the state: asked of the core, once a frame.
import { FEWEST_POINTS } from "./state.js";
import { cubics, pairs } from "../editor/plane.js";
import type { State } from "./state.js";
import type { Curve } from "../index.js";
import type { Spline } from "../index.js";

export type Continuity = ReturnType<Spline["continuity"]>;

export interface Derived {
  /** The shown control points */
  points: [number, number][];
  /** The shown part of the spline */
  curve: Spline;
  /** The point at t of each segment */
  atT: [number, number][];
  /** Of each segment, where shown */
  hulls: Float64Array[];
  /** Of each segment, where shown: the levels from the points to the point at t */
  constructions: Float64Array[][];
  /** Of each segment, where shown */
  halves: [Curve, Curve][];
  /** At P3; null where P3 is an end */
  continuity: Continuity | null;
}

export function derive(state: State): Derived {
  const { layers, t, shown } = state;
  const points = pairs(state.spline.controlPoints().subarray(0, 2 * shown));
  const curve = cubics(points);
  const segments = curve.segments();
  return {
    points,
    curve,
    atT: segments.map((segment) => segment.eval(t)).map(({ x, y }) => [x, y]),
    hulls: layers.hull ? segments.map((segment) => segment.hull()) : [],
    constructions: layers.construction ? segments.map((segment) => segment.deCasteljau(t)) : [],
    halves: layers.halves ? segments.map((segment) => segment.split(t)) : [],
    continuity: continuityAtP3(state),
  };
}

export function continuityAtP3(state: State): Continuity | null {
  return state.shown > FEWEST_POINTS ? state.spline.continuity(1) : null;
}
