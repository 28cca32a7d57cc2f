// What the layers draw on, and the few ways in which all of them do.
import { DASH, ring, stroke } from "../ui/pen.js";
import { Lens } from "./lens.js";
import type { Curve } from "../index.js";
import type { Theme } from "./theme.js";
import type { Role } from "./theme.js";
import type { State } from "../editor/state.js";
import type { PenContext } from "../ui/pen.js";

export type Point2 = [number, number];

/** A text that is placed when all is drawn. */
export interface Word {
  text: string;
  /** What is named, on the picture */
  at: Point2;
  /** The direction in which the word would best stand, of length 1 */
  away: Point2;
  /** From there to the middle of the word, in CSS pixels */
  gap: number;
  /** The smallest are placed first; from 1 on they are light */
  rank: number;
}

/** A canvas, and the lens that transforms the plane to it. Paths go through the lens; marks and words stand on the picture, at `lens.place`. */
export interface DrawContext {
  /** Scaled to the view box */
  ctx: CanvasRenderingContext2D;
  theme: Theme;
  /** The length of a CSS pixel on the picture */
  px: number;
  lens: Lens;
  box: State["box"];
  /** To be placed when all is drawn */
  words: Word[];
  /** What words keep clear of: the middle of a box and half its width and height, one after the other */
  reserved: number[];
}

export function contextOn({ ctx, theme, px }: PenContext<Role>, state: State): DrawContext {
  return { ctx, theme, px, lens: new Lens(ctx, state), box: state.box, words: [], reserved: [] };
}

/** A rational curve is drawn as cubics, which are so near to it on the picture, in its units. */
const TRACE_ERROR = 0.02;

type Rational = { cubics: (tolerance: number) => { controlPoints: () => Float64Array }[] };

/** Begins a path along curves. */
export function along({ lens }: DrawContext, curves: readonly Curve[]) {
  lens.beginPath();
  for (const curve of curves)
    for (const piece of "cubics" in curve ? (curve as Rational).cubics(TRACE_ERROR / lens.scale) : [curve])
      lens.curve(piece.controlPoints());
}

/** Begins a path through points. */
export function through(context: DrawContext, flat: ArrayLike<number>) {
  context.lens.beginPath();
  addThrough(context, flat);
}

export function addThrough({ lens }: DrawContext, flat: ArrayLike<number>) {
  for (let i = 0; i < flat.length; i += 2) {
    if (i) lens.lineTo(flat[i], flat[i + 1]);
    else lens.moveTo(flat[0], flat[1]);
  }
}

/** Separate lines: four numbers each. */
export function lines({ lens }: DrawContext, flat: ArrayLike<number>) {
  lens.beginPath();
  for (let i = 0; i < flat.length; i += 4) {
    lens.moveTo(flat[i], flat[i + 1]);
    lens.lineTo(flat[i + 2], flat[i + 3]);
  }
}

/** The path that there is, dashed. */
export function dashed(context: DrawContext, colour: string, width: number) {
  context.ctx.setLineDash(DASH.map((length) => length * context.px));
  stroke(context, colour, width);
  context.ctx.setLineDash([]);
}

/** Faintly, what is drawn meanwhile. */
export function faint({ ctx }: DrawContext, opacity: number, draw: () => void) {
  ctx.globalAlpha = opacity;
  draw();
  ctx.globalAlpha = 1;
}

/** Hollow marks at points. */
export function hollows(context: DrawContext, flat: ArrayLike<number>, colour: string) {
  for (let i = 0; i < flat.length; i += 2) {
    const at = mark(context, flat[i], flat[i + 1], HOLLOW_ROOM);
    if (at) ring(context, at, colour);
  }
}

/** Words keep this far from the middle of a hollow mark, in CSS pixels. */
const HOLLOW_ROOM = 5;

/**
 * The picture's place of a point, of which words will keep clear.
 *
 * @param radius in CSS pixels
 * @returns null where it is too far outside to be seen
 */
export function mark(context: DrawContext, x: number, y: number, radius: number): Point2 | null {
  const at = context.lens.place(x, y);
  if (!isSeen(context, at)) return null;
  reserve(context, at, radius);
  return at;
}

/**
 * Keeps words away.
 *
 * @param radius in CSS pixels
 */
export function reserve({ reserved, px }: DrawContext, [x, y]: Point2, radius: number) {
  if (radius > 0) reserved.push(x, y, radius * px, radius * px);
}

/** What lies this far outside, in CSS pixels, shows nothing of itself inside. */
const OUTSIDE = 200;

export function isSeen({ box, px }: Pick<DrawContext, "box" | "px">, [x, y]: Point2) {
  const max = OUTSIDE * px;
  return x >= -max && y >= -max && x <= box.width + max && y <= box.height + max;
}

/**
 * @param flat points of the plane
 * @returns their places on the picture
 */
export function onPicture({ lens }: DrawContext, flat: ArrayLike<number>): number[] {
  const places: number[] = [];
  for (let i = 0; i < flat.length; i += 2) places.push(...lens.place(flat[i], flat[i + 1]));
  return places;
}
