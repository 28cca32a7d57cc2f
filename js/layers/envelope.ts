// The curve from lines alone, and the curve beyond its ends.
import { CURVE_WIDTH, stroke } from "../ui/pen.js";
import { Curve } from "../geometry/curve/curve.js";
import { BEYOND } from "../editor/state.js";
import { along, dashed, faint, lines } from "./draw-context.js";
import { translated } from "../editor/translations.js";
import type { DrawContext } from "./draw-context.js";
import type { Figure } from "../editor/figure.js";

/** Strings on each piece, and on all together. */
const STRINGS = 32;
const MAX_STRINGS = 2000;
const STRING_OPACITY = 0.7;

/** The last line of the construction, at many t: the curve is what all of them touch. */
export const envelope = {
  name: "envelope",
  title: () => translated("String art"),
  costly: true as const,

  derive({ pieces }: Figure) {
    const count = Math.max(4, Math.min(STRINGS, Math.floor(MAX_STRINGS / pieces.length)));
    return pieces.map(({ curve }) => envelopeLines(curve, count));
  },

  draw(context: DrawContext, all: Float64Array[]) {
    for (const flat of all) {
      lines(context, flat);
      faint(context, STRING_OPACITY, () => stroke(context, context.theme.level1, 1));
    }
  },
};

/**
 * The ends of the last line but one level below the point: the curves of the first n and of the last n points.
 *
 * @returns four numbers for each string
 */
export function envelopeLines(curve: Curve, count: number): Float64Array {
  const points = curve.controlPoints();
  if (points.length === 4) return points;
  const from = new Curve(points.subarray(0, -2), { dimension: 2 }).sample(count);
  const to = new Curve(points.subarray(2), { dimension: 2 }).sample(count);
  const flat = new Float64Array(4 * (count + 1));
  for (let k = 0; k <= count; k++) flat.set([from[2 * k], from[2 * k + 1], to[2 * k], to[2 * k + 1]], 4 * k);
  return flat;
}

export const extrapolation = {
  name: "extrapolation",
  title: () => translated("Beyond 0 and 1"),
  costly: true as const,

  derive: ({ pieces }: Figure) =>
    pieces.flatMap(({ curve }) => [curve.subsegment(-BEYOND, 0), curve.subsegment(1, 1 + BEYOND)]),

  draw(context: DrawContext, curves: Curve[]) {
    along(context, curves);
    dashed(context, context.theme.curve, CURVE_WIDTH / 2);
  },
};
