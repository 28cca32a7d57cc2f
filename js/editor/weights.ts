// Weights of control points as places on the legs of the control polygon, which can be dragged.
import { wholeIn } from "./check.js";
import { MAX_WEIGHT, MIN_WEIGHT, placeIn } from "./state.js";
import type { Figure } from "./figure.js";
import type { Point2 } from "./state.js";
import type { State } from "./state.js";

/** A weight changes by this factor with an arrow key. */
const STEP_FACTOR = 1.05;
/** Digits of a weight that is dragged: a change of the next digit moves nothing that can be seen. */
const DIGITS = 4;

/**
 * Farin's points (wᵢPᵢ + wᵢ₊₁Pᵢ₊₁) / (wᵢ + wᵢ₊₁), one on each leg from Pᵢ to Pᵢ₊₁ of the control polygons.
 *
 * The point on leg i is the handle of the weight wᵢ₊₁ alone. In textbooks, dragging it multiplies all later weights by a common
 * factor, which leaves the other points where they are; here one handle changes one number, the one that its label shows, and
 * only the point on the next leg follows. The first weight needs no handle: a common factor of all weights changes nothing.
 */
export function weightPoints({ points, weights, rational }: Figure): Point2[] {
  if (!weights || !rational.length) return [];
  const legs = rational.length * rational[0].curve.degree;
  return Array.from({ length: legs }, (_, i) => {
    const share = weights[i + 1] / (weights[i] + weights[i + 1]);
    return [0, 1].map((axis) => points[i][axis] + share * (points[i + 1][axis] - points[i][axis])) as Point2;
  });
}

/** The weight of a point whose handle, on the leg before it, is dragged to a place; beside the leg, the nearest one on it counts. */
export function withWeightPointAt(state: State, index: number, to: unknown): State {
  const [x, y] = placeIn(to, "point");
  const [[x0, y0], [x1, y1]] = [state.points[index - 1], state.points[index]];
  const [dx, dy] = [x1 - x0, y1 - y0];
  const square = dx * dx + dy * dy;
  if (square === 0) return state; // two points at one place have no leg
  const share = Math.min(Math.max(((x - x0) * dx + (y - y0) * dy) / square, 0), 1);
  return withWeight(state, index, (state.weights[index - 1] * share) / (1 - share)); // Infinity at the end is limited
}

/** Another weight of a point, limited to the range of weights. */
export function withWeight(state: State, index: number, weight: number): State {
  const at = wholeIn(index, "index", 0, state.weights.length - 1);
  const value = Number(Math.min(Math.max(weight, MIN_WEIGHT), MAX_WEIGHT).toPrecision(DIGITS));
  return { ...state, weights: state.weights.map((each, i) => (i === at ? value : each)) };
}

/** @param steps as many as an arrow key has; negative ones make the weight smaller */
export function steppedWeight(state: State, index: number, steps: number): State {
  return withWeight(state, index, state.weights[index] * STEP_FACTOR ** steps);
}
