// Everything that is shown and is not in the state: asked of the core, once a frame.
import { cubics, FEWEST_POINTS, pairs } from "./state.js";

/** @typedef {import("./state.js").State} State */
/** @typedef {import("../index.js").Curve} Curve */
/** @typedef {import("../index.js").Spline} Spline */
/** @typedef {ReturnType<Spline["continuity"]>} Continuity */

/**
 * @typedef {object} Derived
 * @property {[number, number][]} points the shown control points
 * @property {Spline} curve the shown part of the spline
 * @property {[number, number][]} atT the point at t of each segment
 * @property {Float64Array[]} hulls of each segment, where shown
 * @property {Float64Array[][]} constructions of each segment, where shown: the levels from the points to the point at t
 * @property {[Curve, Curve][]} halves of each segment, where shown
 * @property {Continuity | null} continuity at P3; null where P3 is an end
 */

/**
 * @param {State} state
 * @returns {Derived}
 */
export function derive(state) {
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

/**
 * @param {State} state
 * @returns {Continuity | null}
 */
export function continuityAtP3(state) {
  return state.shown > FEWEST_POINTS ? state.spline.continuity(1) : null;
}
