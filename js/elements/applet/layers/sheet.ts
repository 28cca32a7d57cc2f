// What the layers draw on, and the few ways in which all of them do.
import { DASH, hollow, stroke } from "../../../applet/pen.js";
import { Lens } from "./lens.js";
import type { Curve } from "../../../index.js";
import type { Theme } from "./theme.js";
import type { Role } from "./theme.js";
import type { Word } from "./words.js";
import type { State } from "../state.js";

export type Place = [number, number];

/** A paper with a lens before it. Paths go through the lens; marks and words stand on the picture, at `lens.place`. */
export interface Sheet {
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
  taken: number[];
}

export function sheetOn({ ctx, theme, px }: import("../../../applet/pen.js").Paper<Role>, state: State): Sheet {
  return { ctx, theme, px, lens: new Lens(ctx, state), box: state.box, words: [], taken: [] };
}

/** Begins a path along curves. */
export function along({ lens }: Sheet, curves: readonly Curve[]) {
  lens.beginPath();
  for (const curve of curves) lens.curve(curve.controlPoints());
}

/** Begins a path through points. */
export function through(sheet: Sheet, flat: ArrayLike<number>) {
  sheet.lens.beginPath();
  addThrough(sheet, flat);
}

export function addThrough({ lens }: Sheet, flat: ArrayLike<number>) {
  for (let i = 0; i < flat.length; i += 2) {
    if (i) lens.lineTo(flat[i], flat[i + 1]);
    else lens.moveTo(flat[0], flat[1]);
  }
}

/** Separate lines: four numbers each. */
export function lines({ lens }: Sheet, flat: ArrayLike<number>) {
  lens.beginPath();
  for (let i = 0; i < flat.length; i += 4) {
    lens.moveTo(flat[i], flat[i + 1]);
    lens.lineTo(flat[i + 2], flat[i + 3]);
  }
}

/** The path that there is, dashed. */
export function dashed(sheet: Sheet, colour: string, width: number) {
  sheet.ctx.setLineDash(DASH.map((length) => length * sheet.px));
  stroke(sheet, colour, width);
  sheet.ctx.setLineDash([]);
}

/** Faintly, what is drawn meanwhile. */
export function faint({ ctx }: Sheet, opacity: number, draw: () => void) {
  ctx.globalAlpha = opacity;
  draw();
  ctx.globalAlpha = 1;
}

/** Hollow marks at points. */
export function hollows(sheet: Sheet, flat: ArrayLike<number>, colour: string) {
  for (let i = 0; i < flat.length; i += 2) {
    const at = mark(sheet, flat[i], flat[i + 1], HOLLOW_ROOM);
    if (at) hollow(sheet, at, colour);
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
export function mark(sheet: Sheet, x: number, y: number, radius: number): Place | null {
  const at = sheet.lens.place(x, y);
  if (!isSeen(sheet, at)) return null;
  take(sheet, at, radius);
  return at;
}

/**
 * Keeps words away.
 *
 * @param radius in CSS pixels
 */
export function take({ taken, px }: Sheet, [x, y]: Place, radius: number) {
  if (radius > 0) taken.push(x, y, radius * px, radius * px);
}

/** What lies this far outside, in CSS pixels, shows nothing of itself inside. */
const OUTSIDE = 200;

export function isSeen({ box, px }: Pick<Sheet, "box" | "px">, [x, y]: Place) {
  const most = OUTSIDE * px;
  return x >= -most && y >= -most && x <= box.width + most && y <= box.height + most;
}

/**
 * @param flat points of the plane
 * @returns their places on the picture
 */
export function onPicture({ lens }: Sheet, flat: ArrayLike<number>): number[] {
  const places: number[] = [];
  for (let i = 0; i < flat.length; i += 2) places.push(...lens.place(flat[i], flat[i + 1]));
  return places;
}
