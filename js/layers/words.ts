// Where words stand: beside what they name, clear of marks and of each other where there is room.
import { label } from "../ui/pen.js";
import type { DrawContext, Word } from "./draw-context.js";

export type Point2 = [number, number];

/** About the size of a character, in CSS pixels: of the names of the control points, and of all else. */
const CHARACTER = { width: 8.5, height: 16 };
const LIGHT_WIDTH = 7.5;
/** Turns of the best direction that are tried, in this order, in eighths of a circle. */
const TURNS = [0, 1, -1, 2, -2, 3, -3, 4];
/** How far away, in gaps. */
const RINGS = [1, 1.5, 2.1];
/** Words keep this far from the edge of the picture, in CSS pixels. */
const MARGIN = 11;
/** The font of all but the names of the control points: weight and size. */
const LIGHT = [450, 12] as const;
/** Beyond so many words the picture is full anyway. */
const MAX_WORDS = 120;

/** Places all words of a context and writes them. */
export function writeWords(context: DrawContext) {
  const words = context.words.sort((a, b) => a.rank - b.rank).slice(0, MAX_WORDS);
  const { reserved: taken } = context;
  for (const word of words) {
    const halfWidth = ((word.rank ? LIGHT_WIDTH : CHARACTER.width) * [...word.text].length * context.px) / 2;
    const halfHeight = (CHARACTER.height * context.px) / 2;
    const at = bestPlace(context, word, taken, halfWidth, halfHeight);
    taken.push(at[0], at[1], halfWidth, halfHeight);
    label(context, word.text, at, word.rank ? LIGHT : undefined);
  }
}

/** The first free place; where none is, the one that overlaps least. */
function bestPlace(
  { box, px }: DrawContext,
  { at, away, gap }: Word,
  taken: number[],
  halfWidth: number,
  halfHeight: number,
): Point2 {
  let best: Point2 = at;
  let min = Infinity;
  for (const ring of RINGS) {
    for (const turn of TURNS) {
      const [c, s] = [Math.cos((turn * Math.PI) / 4), Math.sin((turn * Math.PI) / 4)];
      const [dx, dy] = [c * away[0] - s * away[1], s * away[0] + c * away[1]];
      const long = Math.max(0, halfWidth - MARGIN * px) * Math.abs(dx);
      const distance = gap * px * ring + long;
      const place = inside(box, [at[0] + dx * distance, at[1] + dy * distance], halfWidth, MARGIN * px);
      const cost = overlap(taken, place[0], place[1], halfWidth, halfHeight, min);
      if (cost < min) [best, min] = [place, cost];
      if (min === 0) return best;
    }
  }
  return best;
}

/**
 * @param across how far from the left and the right edge
 * @param down from the upper and the lower one
 */
function inside({ width, height }: DrawContext["box"], [x, y]: Point2, across: number, down: number): Point2 {
  return [Math.max(Math.min(x, width - across), across), Math.max(Math.min(y, height - down), down)];
}

/**
 * The area that a box shares with those that are taken.
 *
 * @param max the sum stops here
 */
function overlap(taken: number[], x: number, y: number, halfWidth: number, halfHeight: number, max: number): number {
  let sum = 0;
  for (let i = 0; i < taken.length && sum < max; i += 4) {
    const width = halfWidth + taken[i + 2] - Math.abs(x - taken[i]);
    const height = halfHeight + taken[i + 3] - Math.abs(y - taken[i + 1]);
    if (width > 0 && height > 0) sum += width * height;
  }
  return sum;
}
