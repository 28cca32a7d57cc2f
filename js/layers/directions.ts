// Directions along the curve: tangents, normals, and the comb of curvature on them.
import { stroke, TANGENT_WIDTH } from "../ui/pen.js";
import { arrowheads } from "./base.js";
import { addThrough, faint, isSeen, lines, through } from "./draw-context.js";
import { translated } from "../editor/translations.js";
import type { Curve } from "../index.js";
import type { DrawContext } from "./draw-context.js";
import type { Figure } from "../editor/figure.js";
import type { State } from "../editor/state.js";

/** Lengths of arrows at t and along the curve, in CSS pixels. */
const LONG = 64;
const SHORT = 22;
/** So many steps along each piece. */
const STEPS = 8;
/** No more arrows than these on all pieces together. */
const MAX_ARROWS = 400;

export const tangents = arrows(
  "tangents",
  () => translated("Tangents"),
  "handle",
  (tx, ty) => [tx, ty],
);
export const normals = arrows(
  "normals",
  () => translated("Normals"),
  "level1",
  (tx, ty) => [-ty, tx],
);

/** A layer of arrows: short ones at even steps of t, a long one at t. */
function arrows(
  name: string,
  title: () => string,
  role: "handle" | "level1",
  turned: (tx: number, ty: number) => [number, number],
) {
  return {
    name,
    title,

    derive({ pieces }: Figure, { t }: State) {
      const steps = Math.min(STEPS, Math.floor(MAX_ARROWS / pieces.length));
      const ts = Float64Array.from({ length: steps + 2 }, (_, k) => (k ? (k - 1) / steps : t));
      return pieces.map(({ curve }) => pointsAndDirections(curve, steps ? ts : ts.subarray(0, 1)));
    },

    draw(context: DrawContext, data: Float64Array[]) {
      const colour = context.theme[role];
      for (const flat of data) {
        drawArrows(context, flat.subarray(4), turned, SHORT, colour);
        drawArrows(context, flat.subarray(0, 4), turned, LONG, colour);
      }
    },
  };
}

/**
 * @param flat points and unit tangents
 */
function drawArrows(
  context: DrawContext,
  flat: Float64Array,
  turned: (tx: number, ty: number) => [number, number],
  length: number,
  colour: string,
) {
  const { ctx, lens, px } = context;
  const ends: number[] = [];
  ctx.beginPath();
  for (let i = 0; i < flat.length; i += 4) {
    const at = lens.place(flat[i], flat[i + 1]);
    if (!isSeen(context, at)) continue;
    const [dx, dy] = turned(flat[i + 2], flat[i + 3]);
    if (dx === 0 && dy === 0) continue;
    const [x, y] = [at[0] + dx * length * px, at[1] + dy * length * px];
    ctx.moveTo(...at);
    ctx.lineTo(x, y);
    ends.push(...at, x, y);
  }
  stroke(context, colour, TANGENT_WIDTH);
  arrowheads(context, ends, colour);
}

/**
 * Points and unit tangents at some parameters; where the derivative vanishes its limit, of a point none.
 *
 * @returns four numbers each
 */
export function pointsAndDirections(curve: Curve, ts: ArrayLike<number>): Float64Array {
  const at = curve.evalAt(ts);
  const by = curve.derivative().evalAt(ts);
  const flat = new Float64Array(4 * ts.length);
  for (let k = 0; k < ts.length; k++) {
    let [tx, ty] = [by[2 * k], by[2 * k + 1]];
    const length = Math.sqrt(tx * tx + ty * ty);
    if (length > 0) [tx, ty] = [tx / length, ty / length];
    else ({ x: tx, y: ty } = curve.tangent(ts[k]));
    flat[4 * k] = at[2 * k];
    flat[4 * k + 1] = at[2 * k + 1];
    flat[4 * k + 2] = tx;
    flat[4 * k + 3] = ty;
  }
  return flat;
}

/** Teeth of the comb on a piece, for each degree, and on all together. */
const TEETH = 16;
const MAX_TEETH = 2400;
const MAX_TEETH_OF_ONE = 200;
/** A tooth is as long as the curvature times this share of the box's width squared: 40 of 670 on a circle of radius 100. */
const COMB_SCALE = 4000 / 670 ** 2;
/** Longer teeth, before cusps, are cut: this share of the box's width. */
const LONGEST_TOOTH = 0.13;
const TOOTH_OPACITY = 0.55;

/** On the outer side of the bend; where two pieces meet the teeth tell how the curvature jumps. */
export const comb = {
  name: "comb",
  title: () => translated("Curvature comb"),
  costly: true as const,

  derive({ pieces, degree }: Figure, { box }: State) {
    const count = Math.max(
      4,
      Math.min(TEETH * Math.max(degree, 3), MAX_TEETH_OF_ONE, Math.floor(MAX_TEETH / pieces.length)),
    );
    const scale = COMB_SCALE * box.width ** 2;
    return combOf(
      pieces.map(({ curve }) => curve),
      count,
      scale,
      LONGEST_TOOTH * box.width,
    );
  },

  draw(context: DrawContext, { teeth, rims }: ReturnType<typeof combOf>) {
    for (const flat of teeth) {
      lines(context, flat);
      faint(context, TOOTH_OPACITY, () => stroke(context, context.theme.level2, 1));
    }
    through(context, []);
    for (const flat of rims) addThrough(context, flat);
    stroke(context, context.theme.level2, TANGENT_WIDTH);
  },

  describe: ({ sharpest }: ReturnType<typeof combOf>) =>
    sharpest > 0
      ? translated("Sharpest bend: radius {0} px", Number((1 / sharpest).toPrecision(3)))
      : translated("No bend"),
};

/**
 * @param count teeth on each, and one
 * @returns from the curve to the tips; the tips; the greatest curvature
 */
export function combOf(
  curves: Curve[],
  count: number,
  scale: number,
  longest: number,
): { teeth: Float64Array[]; rims: Float64Array[]; sharpest: number } {
  let sharpest = 0;
  const teeth = curves.map((curve) => {
    const [at, first] = [curve.sample(count), curve.derivative()];
    const [by, bend] = [first.sample(count), first.derivative().sample(count)];
    const flat = new Float64Array(4 * (count + 1));
    for (let k = 0; k <= count; k++) {
      let [x, y] = [by[2 * k], by[2 * k + 1]];
      const speed = Math.sqrt(x * x + y * y);
      let curvature = (x * bend[2 * k + 1] - y * bend[2 * k]) / speed ** 3;
      if (speed === 0) ({ x, y } = curve.tangent(k / count));
      else [x, y] = [x / speed, y / speed];
      if (!(curvature - curvature === 0)) curvature = curve.curvature(k / count) || 0;
      sharpest = Math.max(sharpest, Math.abs(curvature));
      const tooth = Math.min(Math.max(curvature * scale, -longest), longest);
      flat.set([at[2 * k], at[2 * k + 1], at[2 * k] + y * tooth, at[2 * k + 1] - x * tooth], 4 * k);
    }
    return flat;
  });
  return { teeth, rims: teeth.map((flat) => flat.filter((_, i) => i % 4 > 1)), sharpest };
}
