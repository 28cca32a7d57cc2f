// What is always drawn: the curve, the points with their names and tangents, the point at t.
import * as pen from "../ui/pen.js";
import { along, dashed, isSeen, lines, mark, onPicture, reserve } from "./draw-context.js";
import type { DrawContext } from "./draw-context.js";
import type { Figure } from "../editor/figure.js";
import type { State } from "../editor/state.js";
import type { Curve } from "../index.js";

export type Point2 = [number, number];

const LABEL_DISTANCE = 19;
/** Words keep this far from the middle of a point, in CSS pixels. */
const POINT_ROOM = 8;
/** Where pieces meet: half the length of the stroke across, in CSS pixels. */
const JOINT_HALF = 9;
const ARROW_HEAD = 9;
const WAITING_OPACITY = 0.55;
/** Words keep clear of so many places of the curve, on all pieces together. */
const CURVE_PLACES = 96;
/** Half the width that is kept clear, in CSS pixels. */
const CURVE_ROOM = 2;

export const curve = {
  derive: ({ pieces }: Figure) => pieces.map((piece) => piece.curve),

  draw(context: DrawContext, curves: Curve[]) {
    along(context, curves);
    pen.stroke(context, context.theme.curve, pen.CURVE_WIDTH);
    const steps = Math.ceil(CURVE_PLACES / curves.length);
    for (const each of curves.slice(0, CURVE_PLACES)) {
      for (let i = 0; i <= steps; i++) {
        const { x, y } = each.eval(i / steps);
        reserve(context, context.lens.place(x, y), CURVE_ROOM);
      }
    }
  },
};

/** Whose inner points are ends of tangents. */
const TANGENT_BASES = new Set(["bezier", "hermite"]);

/** From the ends of each piece to their neighbours off the curve; Hermite's vectors are arrows. */
export const handles = {
  derive({ pieces, points, degree }: Figure, { basis }: State) {
    if (!TANGENT_BASES.has(basis) || degree < 2) return { flat: [], arrows: false };
    const flat = pieces.flatMap(({ indices }) => [
      ...points[indices[0]],
      ...points[indices[1]],
      ...points[indices[indices.length - 2]],
      ...points[indices[indices.length - 1]],
    ]);
    return { flat, arrows: basis === "hermite" };
  },

  draw(context: DrawContext, { flat, arrows }: { flat: number[]; arrows: boolean }) {
    lines(context, flat);
    pen.stroke(context, context.theme.handle, pen.TANGENT_WIDTH);
    if (arrows) arrowheads(context, onPicture(context, flat), context.theme.handle, pen.DISC_RADIUS);
  },
};

/**
 * Heads at the ends of lines that are vectors.
 *
 * @param flat four numbers for each line, on the picture
 * @param back how far before the end the tip is, in CSS pixels
 */
export function arrowheads(context: DrawContext, flat: ArrayLike<number>, colour: string, back = 0) {
  const { ctx, px } = context;
  ctx.beginPath();
  for (let i = 0; i < flat.length; i += 4) {
    const [toX, toY] = [flat[i + 2], flat[i + 3]];
    const length = Math.hypot(toX - flat[i], toY - flat[i + 1]);
    if (!(length > (ARROW_HEAD + back) * px) || !isSeen(context, [toX, toY])) continue;
    const [dx, dy] = [((toX - flat[i]) / length) * px, ((toY - flat[i + 1]) / length) * px];
    const [x, y] = [toX - back * dx, toY - back * dy];
    const [long, wide] = [ARROW_HEAD, ARROW_HEAD / 2.4];
    ctx.moveTo(x, y);
    ctx.lineTo(x - long * dx - wide * dy, y - long * dy + wide * dx);
    ctx.lineTo(x - long * dx + wide * dy, y - long * dy - wide * dx);
    ctx.closePath();
  }
  ctx.fillStyle = colour;
  ctx.fill();
}

/** Whose pieces meet where no control point need be. */
const KNOT_BASES = new Set(["b-spline", "catmull-rom", "natural", "centripetal"]);

/** A short stroke across where pieces meet. */
export const joints = {
  derive({ pieces }: Figure, { basis }: State) {
    if (!KNOT_BASES.has(basis)) return [];
    return pieces.slice(1).flatMap(({ curve }) => {
      const { x, y } = curve.eval(0);
      const tangent = curve.tangent(0);
      return [x, y, -tangent.y, tangent.x];
    });
  },

  /**
   * @param data a point and a direction each
   */
  draw(context: DrawContext, data: number[]) {
    strokesAcross(context, data, JOINT_HALF);
    pen.stroke(context, context.theme.curve, pen.TANGENT_WIDTH);
  },
};

/**
 * Begins a path of short strokes on the picture.
 *
 * @param data a point and a unit direction each
 * @param half of their length, in CSS pixels
 */
export function strokesAcross({ ctx, lens, px, box }: DrawContext, data: ArrayLike<number>, half: number) {
  ctx.beginPath();
  for (let i = 0; i < data.length; i += 4) {
    const at = lens.place(data[i], data[i + 1]);
    if (!isSeen({ box, px }, at)) continue;
    const [dx, dy] = [data[i + 2] * half * px, data[i + 3] * half * px];
    pen.line(ctx, [at[0] - dx, at[1] - dy], [at[0] + dx, at[1] + dy]);
  }
}

/** The control points and their names. */
export const points = {
  derive: ({ points, kinds, names }: Figure) => ({ points, kinds, names }),

  draw(
    context: DrawContext,
    { points, kinds, names }: Pick<Figure, "points" | "kinds" | "names">,
    _: Figure,
    { labels }: State,
  ) {
    const places = points.map(([x, y]) => context.lens.place(x, y));
    places.forEach((place, i) => drawPoint(context, place, kinds[i]));
    if (labels === "none") return;
    places.forEach((place, i) => {
      const at = pen.atEdge(context.box, place, pen.DISC_RADIUS * context.px);
      const away = pen.awayFrom(place, [places[i - 1], places[i + 1]]);
      context.words.push({ text: names[i], at, away, gap: LABEL_DISTANCE, rank: 0 });
    });
  },
};

/**
 * A disc on the curve, a square off it; hollow at the edge where the point itself lies outside; faint while it waits for
 * others.
 */
function drawPoint(context: DrawContext, place: Point2, kind: Figure["kinds"][number]) {
  const { ctx, theme, px, box } = context;
  const at = pen.atEdge(box, place, pen.DISC_RADIUS * px);
  const inside = place[0] >= 0 && place[1] >= 0 && place[0] <= box.width && place[1] <= box.height;
  const colour = { on: theme.curve, off: theme.handle, wait: theme.quiet }[kind];
  if (kind === "wait") ctx.globalAlpha = WAITING_OPACITY;
  pen.controlPoint(context, at, kind === "on", colour, inside && kind !== "wait");
  ctx.globalAlpha = 1;
  reserve(context, at, POINT_ROOM);
}

/** The point at t of each piece. */
export const atT = {
  derive: ({ pieces }: Figure, { t }: State) => pieces.flatMap(({ curve }) => Object.values(curve.eval(t))),

  draw(context: DrawContext, flat: number[]) {
    for (let i = 0; i < flat.length; i += 2) {
      const at = mark(context, flat[i], flat[i + 1], POINT_ROOM);
      if (at) pen.diamond(context, at);
    }
  },
};

/** The way from the user's last point to those that wait is not drawn as a polygon, but hinted at. */
export const waiting = {
  derive({ points, kinds }: Figure) {
    const first = kinds.indexOf("wait");
    return first < 0 ? [] : points.slice(Math.max(0, first - 1)).flat();
  },

  draw(context: DrawContext, flat: number[]) {
    context.lens.beginPath();
    for (let i = 0; i < flat.length; i += 2) context.lens[i ? "lineTo" : "moveTo"](flat[i], flat[i + 1]);
    dashed(context, context.theme.quiet, pen.POLYGON_WIDTH);
  },
};
