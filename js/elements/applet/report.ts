// What is shown, as the page and the companions read it.
import { bounded } from "../../layers/bounded.js";
import { continuityOf } from "../../editor/figure.js";
import { treeOf } from "../../layers/halving.js";
import type { State } from "../../editor/state.js";
import type { Figure } from "../../editor/figure.js";

export function publicFigure(state: State, figure: Figure) {
  const { pieces, rational, weights, spline, names, kinds, degree, matrix } = figure;
  return {
    points: figure.points.map(([x, y]) => [x, y] as [number, number]),
    shown: state.shown,
    basis: state.basis,
    degree,
    matrix,
    t: state.t,
    segment: Math.min(state.segment, Math.max(0, pieces.length + rational.length - 1)),
    names,
    kinds,
    pieces,
    rational,
    weights: weights ? [...weights] : null,
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
