// What is shown, as the page and the companions read it.
import { bounded } from "./layers/bounded.js";
import { treeOf } from "./layers/halving.js";

/** @typedef {import("./state.js").State} State */
/** @typedef {import("./figure.js").Figure} Figure */
/** @typedef {ReturnType<import("../../index.js").Spline["continuity"]>} Continuity */

/**
 * What holds at each inner joint.
 *
 * @param {Figure} figure
 * @returns {Continuity[]} none where there is no chain
 */
export function continuityOf({ spline }) {
  return spline ? Array.from({ length: spline.segmentCount - 1 }, (_, k) => spline.continuity(k + 1)) : [];
}

/**
 * @param {State} state
 * @param {Figure} figure
 */
export function reportOf(state, figure) {
  const { pieces, spline, names, kinds, degree, matrix } = figure;
  return {
    points: figure.points.map(([x, y]) => /** @type {[number, number]} */ ([x, y])),
    shown: state.shown,
    basis: state.basis,
    degree,
    matrix,
    t: state.t,
    segment: Math.min(state.segment, Math.max(0, pieces.length - 1)),
    names,
    kinds,
    pieces,
    spline,
    get continuity() {
      return continuityOf(figure);
    },
    get tree() {
      if (!state.layers.has("tree")) return null;
      const { segments, error } = treeOf(bounded(figure), state);
      return { segments, error };
    },
  };
}
