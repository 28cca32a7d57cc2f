// Long chains of high degrees: what layers ask of each piece stays a matter of a few frames.
import { Spline } from "../geometry/spline/spline.js";
import type { Figure } from "../editor/figure.js";

/** What the core does takes about so long as the degrees squared, summed: this much is a tenth of a second at worst. */
const MAX_WORK = 2e4;

/**
 * The figure without the pieces that are too many.
 *
 * @returns the same one where there are not
 */
export function bounded(figure: Figure): Figure {
  const work = (figure.degree + 1) ** 2;
  const count = Math.max(1, Math.floor(MAX_WORK / work));
  if (Math.max(figure.pieces.length, figure.rational.length) <= count) return figure;
  const pieces = figure.pieces.slice(0, count);
  const rational = figure.rational.slice(0, count);
  return { ...figure, pieces, rational, spline: figure.spline && Spline.fromCurves(pieces.map(({ curve }) => curve)) };
}
