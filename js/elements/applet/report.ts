// What is shown, as the page and the companions read it.
import { bounded } from "../../layers/bounded.js";
import { treeOf } from "../../layers/halving.js";
import type { State } from "../../editor/state.js";
import type { Figure } from "../../editor/figure.js";

export type Continuity = ReturnType<import("../../index.js").Spline["continuity"]>;

/**
 * What holds at each inner joint.
 *
 * @returns none where there is no chain
 */
export function continuityOf({ spline }: Figure): Continuity[] {
  return spline ? Array.from({ length: spline.segmentCount - 1 }, (_, k) => spline.continuity(k + 1)) : [];
}

export function reportOf(state: State, figure: Figure) {
  const { pieces, spline, names, kinds, degree, matrix } = figure;
  return {
    points: figure.points.map(([x, y]) => [x, y] as [number, number]),
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
