// What is measured on the curve: the point nearest to the pointer, the parallel, ticks of equal length.
import { SCAFFOLD_WIDTH, stroke, TANGENT_WIDTH } from "../ui/pen.js";
import { strokesAcross } from "./base.js";
import { short } from "./features.js";
import { along, dashed, hollows, lines } from "./draw-context.js";
import { pointsAndDirections } from "./directions.js";
import { translated } from "../editor/translations.js";
import type { Curve } from "../index.js";
import type { DrawContext } from "./draw-context.js";
import type { Figure } from "../editor/figure.js";
import type { DrawnState, State } from "../editor/state.js";

export type Found = { t: number; point: { x: number; y: number }; distance: number };

export const nearest = {
  name: "nearest",
  title: () => translated("Nearest to the pointer"),

  derive(
    { pieces, spline }: Figure,
    { pointer }: DrawnState,
  ): { pointer: readonly number[]; found: Found; pieces: number } | null {
    if (!pointer || !pieces.length) return null;
    const all = spline ? [spline.nearest(pointer)] : pieces.map(({ curve }, k) => behind(curve.nearest(pointer), k));
    const found = all.reduce((best, each) => (each.distance < best.distance ? each : best));
    return { pointer, found, pieces: pieces.length };
  },

  draw(context: DrawContext, data: { pointer: number[]; found: Found } | null) {
    if (!data) return;
    const { x, y } = data.found.point;
    lines(context, [...data.pointer, x, y]);
    dashed(context, context.theme.ink, TANGENT_WIDTH);
    hollows(context, [x, y], context.theme.ink);
  },

  describe(data: { found: Found; pieces: number } | null) {
    if (!data) return translated("Nearest point: point at a place of the picture");
    const { t, distance } = data.found;
    const k = Math.min(Math.floor(t), data.pieces - 1);
    const where = data.pieces > 1 ? translated("{0} on piece {1}", (t - k).toFixed(3), k + 1) : t.toFixed(3);
    return translated("Nearest point: t = {0}, {1} px away", where, short(distance));
  },
};

/**
 * @returns with t as a spline counts it
 */
function behind(found: Found, k: number): Found {
  return { ...found, t: found.t + k };
}

/** The parallel is right to this share of a pixel, but not to more than this in the plane. */
const OFFSET_PX = 0.05;
const FINEST_OFFSET = 1e-6;

export const offset = {
  name: "offset",
  title: () => translated("Offset curve"),
  costly: true as const,

  derive({ pieces, spline }: Figure, { offset, view, box }: State) {
    const tolerance = Math.max((OFFSET_PX * view.width) / box.width, FINEST_OFFSET);
    const splines = spline
      ? [spline.offset(offset, { tolerance })]
      : pieces.map(({ curve }) => curve.offset(offset, { tolerance }));
    return { curves: splines.flatMap((each) => each.segments()), distance: offset };
  },

  draw(context: DrawContext, { curves }: { curves: Curve[] }) {
    along(context, curves);
    stroke(context, context.theme.level1, SCAFFOLD_WIDTH);
  },

  describe: ({ curves, distance }: { curves: Curve[]; distance: number }) =>
    curves.length === 1
      ? translated("Offset curve at {0} px: one piece", short(distance))
      : translated("Offset curve at {0} px: {1} pieces", short(distance), curves.length),
};

const TICK_HALF = 7;

export const ticks = {
  name: "ticks",
  title: () => translated("Equal lengths"),
  costly: true as const,

  derive({ pieces, spline }: Figure, { ticks }: State) {
    if (!spline)
      return {
        across: pieces.flatMap(({ curve }) => [...pointsAndDirections(curve, curve.equidistantTimes(ticks))]),
        length: null,
        ticks,
      };
    const ts = spline.equidistantTimes(ticks);
    const across = pieces.flatMap(({ curve }, k) => {
      const last = k === pieces.length - 1;
      const own = ts.filter((t) => t >= k && (last || t < k + 1)).map((t) => t - k);
      return own.length ? [...pointsAndDirections(curve, own)] : [];
    });
    return { across, length: spline.length(), ticks };
  },

  /**
   * @param data points and unit tangents
   */
  draw(context: DrawContext, { across }: { across: number[] }) {
    const strokes = across.map((value, i) => (i % 4 === 2 ? -across[i + 1] : i % 4 === 3 ? across[i - 1] : value));
    strokesAcross(context, strokes, TICK_HALF);
    stroke(context, context.theme.ink, TANGENT_WIDTH);
  },

  describe: ({ length, ticks }: { length: number | null; ticks: number }) =>
    length === null ? "" : translated("Length {0} px, a tick every {1} px", short(length), short(length / ticks)),
};
