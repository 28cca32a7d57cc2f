// How much each point counts at t: discs whose areas are the weights.
import { RIM_WIDTH, stroke } from "../ui/pen.js";
import { Curve } from "../geometry/curve/curve.js";
import { isSeen } from "./draw-context.js";
import { translated } from "../editor/translations.js";
import type { DrawContext } from "./draw-context.js";
import type { Figure } from "../editor/figure.js";
import type { Piece } from "../editor/figure.js";
import type { State } from "../editor/state.js";

/** The radius of a disc of weight 1, in CSS pixels. */
const WHOLE_RADIUS = 34;
const OPACITY = 0.22;
/** Smaller ones read 0.00. */
const MIN_READ = 0.005;

export const weights = {
  name: "weights",
  title: () => translated("Weights at t"),

  derive: (figure: Figure, state: State) => weightsAt(figure, state),

  draw(context: DrawContext, { flat, values }: ReturnType<typeof weightsAt>) {
    values.forEach((value, i) => drawDisc(context, flat[2 * i], flat[2 * i + 1], value));
  },

  describe: ({ values }: ReturnType<typeof weightsAt>) =>
    values.length ? translated("Weights at t: {0}", [...values].map(read).join(", ")) : "",
};

/** The points of the selected piece and their weights, which sum to the point at t. */
export function weightsAt(
  figure: Figure,
  { basis, segment, t }: State,
): {
  flat: ArrayLike<number>;
  values: readonly number[] | Float64Array;
} {
  const piece = selected(figure, segment);
  if (!piece) return { flat: [], values: [] };
  const own = () => piece.indices.flatMap((i) => figure.points[i]);
  if (figure.matrix) return { flat: own(), values: blend(figure.matrix, t) };
  if (basis === "b-spline") return { flat: own(), values: uniformBSpline(figure.degree, t) };
  return { flat: piece.curve.controlPoints(), values: Curve.bernstein(piece.curve.degree, t) };
}

export function selected({ pieces }: Figure, segment: number): Piece | undefined {
  return pieces[Math.min(segment, pieces.length - 1)];
}

/** [t³ t² t 1]·M. */
function blend(m: ArrayLike<number>, t: number) {
  return [0, 1, 2, 3].map((k) => ((m[k] * t + m[4 + k]) * t + m[8 + k]) * t + m[12 + k]);
}

/**
 * The blending functions of the uniform B-spline, by the recursion of Cox and de Boor: t in the window's own span.
 *
 * @returns the oldest point's first
 */
function uniformBSpline(degree: number, t: number): number[] {
  let values = [1];
  for (let d = 1; d <= degree; d++) {
    const next = new Array(d + 1).fill(0);
    values.forEach((value, j) => {
      const share = (t + d - 1 - j) / d;
      next[j] += (1 - share) * value;
      next[j + 1] += share * value;
    });
    values = next;
  }
  return values;
}

/** A negative weight is a hollow disc: it pushes the curve away. */
function drawDisc(context: DrawContext, x: number, y: number, value: number) {
  const { ctx, theme, px } = context;
  const at = context.lens.place(x, y);
  if (!isSeen(context, at)) return;
  const colour = value < 0 ? theme.handle : theme.curve;
  ctx.beginPath();
  ctx.arc(at[0], at[1], WHOLE_RADIUS * Math.sqrt(Math.min(Math.abs(value), MAX_DRAWN)) * px, 0, 2 * Math.PI);
  ctx.globalAlpha = value < 0 ? 0 : OPACITY;
  ctx.fillStyle = colour;
  ctx.fill();
  ctx.globalAlpha = 1;
  stroke(context, colour, RIM_WIDTH);
  if (Math.abs(value) >= MIN_READ)
    context.words.push({ text: read(value), at, away: [0, 1], gap: NUMBER_DISTANCE, rank: 1 });
}

/** Outside of [0, 1] weights of high degrees are larger than any picture. */
const MAX_DRAWN = 9;
const NUMBER_DISTANCE = 19;

function read(value: number) {
  return (Math.abs(value) < 1000 ? value.toFixed(2) : value.toExponential(1)).replace("-", "−");
}
