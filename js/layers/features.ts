// Places of the curve that stand out: its exact box, extrema, inflections.
import { POLYGON_WIDTH, stroke, TANGENT_WIDTH } from "../ui/pen.js";
import { strokesAcross } from "./base.js";
import { dashed, hollows } from "./draw-context.js";
import { pointsAndDirections } from "./directions.js";
import { translated } from "../editor/translations.js";
import type { Curve } from "../index.js";
import type { DrawContext } from "./draw-context.js";
import type { Figure } from "../editor/figure.js";

const EXTREMUM_HALF = 26;
const INFLECTION_HALF = 10;

export const bounds = {
  name: "bounds",
  title: () => translated("Exact boxes"),
  costly: true as const,

  derive: ({ pieces }: Figure) => ({
    boxes: pieces.map(({ curve }) => curve.bounds()),
    pointBoxes: pieces.map(({ curve }) => boxOf(curve.controlPoints())),
    touches: pieces.flatMap(({ curve }) => extremaOf(curve).points),
  }),

  draw(
    context: DrawContext,
    { boxes, pointBoxes, touches }: { boxes: ReturnType<Curve["bounds"]>[]; pointBoxes: Box[]; touches: number[] },
  ) {
    for (const [left, top, right, bottom] of pointBoxes) {
      context.lens.polygon([left, top, right, top, right, bottom, left, bottom]);
      stroke(context, context.theme.quiet, 1);
    }
    for (const { min, max } of boxes) {
      context.lens.polygon([min.x, min.y, max.x, min.y, max.x, max.y, min.x, max.y]);
      dashed(context, context.theme.quiet, POLYGON_WIDTH);
    }
    hollows(context, touches, context.theme.quiet);
  },

  describe({ boxes }: { boxes: ReturnType<Curve["bounds"]>[] }) {
    const range = (axis: "x" | "y") => [
      short(Math.min(...boxes.map(({ min }) => min[axis]))),
      short(Math.max(...boxes.map(({ max }) => max[axis]))),
    ];
    return boxes.length
      ? translated("Exact box: x from {0} to {1}, y from {2} to {3}", ...range("x"), ...range("y"))
      : "";
  },
};

/** Left, top, right, bottom */
type Box = [number, number, number, number];

/** The box of points, x and y in turn. */
function boxOf(points: Float64Array): Box {
  const [x, y] = [0, 1].map((axis) => points.filter((_, i) => i % 2 === axis));
  return [Math.min(...x), Math.min(...y), Math.max(...x), Math.max(...y)];
}

export const extrema = {
  name: "extrema",
  title: () => translated("Extrema"),
  costly: true as const,

  derive({ pieces }: Figure) {
    const found = pieces.map(({ curve }) => extremaOf(curve));
    return {
      points: found.flatMap(({ points }) => points),
      strokes: found.flatMap(({ strokes }) => strokes),
      ts: found.map(({ ts }) => ts),
    };
  },

  draw(context: DrawContext, { points, strokes }: { points: number[]; strokes: number[] }) {
    strokesAcross(context, strokes, EXTREMUM_HALF);
    stroke(context, context.theme.level1, TANGENT_WIDTH);
    hollows(context, points, context.theme.level1);
  },

  describe({ ts }: { ts: number[][] }) {
    const all = listed(ts);
    return all ? translated("Extrema at t = {0}", all) : translated("Extrema: none inside");
  },
};

/**
 * Inner extrema of x, then of y.
 *
 * @returns `strokes`: the points with the directions of their tangents
 */
export function extremaOf(curve: Curve): { ts: number[]; points: number[]; strokes: number[] } {
  const { x, y } = curve.extrema();
  const ts = [...x, ...y];
  const points = [...curve.evalAt(ts)];
  const strokes = ts.flatMap((_, k) => [points[2 * k], points[2 * k + 1], ...(k < x.length ? [0, 1] : [1, 0])]);
  return { ts, points, strokes };
}

export const inflections = {
  name: "inflections",
  title: () => translated("Inflections"),
  costly: true as const,

  derive({ pieces }: Figure) {
    const ts = pieces.map(({ curve }) => [...curve.inflections()]);
    const across = pieces.flatMap(({ curve }, k) => [...pointsAndDirections(curve, ts[k])]);
    return { ts, across, kinds: pieces.map(({ curve }) => curve.classify()) };
  },

  /** A stroke along the curve's normal, and a hollow mark. */
  draw(context: DrawContext, { across }: { across: number[] }) {
    const strokes = across.map((value, i) => (i % 4 === 2 ? -across[i + 1] : i % 4 === 3 ? across[i - 1] : value));
    strokesAcross(context, strokes, INFLECTION_HALF);
    stroke(context, context.theme.level2, 2);
    hollows(
      context,
      across.filter((_, i) => i % 4 < 2),
      context.theme.level2,
    );
  },

  describe({ ts, kinds }: { ts: number[][]; kinds: string[] }) {
    if (!kinds.length) return "";
    const all = listed(ts);
    const found = all ? translated("Inflections at t = {0}", all) : translated("Inflections: none inside");
    return `${found} (${few(kinds).join(", ")})`;
  },
};

/** More than these are not listed. */
const MAX_LISTED = 6;

/**
 * @param ts of each piece
 */
function listed(ts: number[][]) {
  const all = ts.flatMap((each, k) =>
    each.map((t) => (ts.length > 1 ? translated("{0} on piece {1}", t.toFixed(3), k + 1) : t.toFixed(3))),
  );
  return few(all).join(", ");
}

function few(all: string[]) {
  return all.length > MAX_LISTED ? [...all.slice(0, MAX_LISTED), "…"] : all;
}

export function short(value: number) {
  return String(Math.round(10 * value) / 10);
}
