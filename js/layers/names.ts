// Names in the construction at t, in the notation of the labels.
import * as pen from "../ui/pen.js";
import { isSeen } from "./draw-context.js";
import { selected } from "./weights.js";
import { translated } from "../editor/translations.js";
import type { DrawContext } from "./draw-context.js";
import type { Figure } from "../editor/figure.js";
import type { DrawnState, State } from "../editor/state.js";
import type { Labels } from "../editor/state.js";
import type { Curve } from "../index.js";

export type Name = { text: string; at: ArrayLike<number>; away: [number, number] };

const DISTANCE = 16;
/** Names double with every level: above these degrees there is no room. */
const MAX_DEGREE = { P0: 4, P1: 4, b0: 8, p0: 3, none: 0 };

export const names = {
  name: "names",
  title: () => translated("Names in the construction"),

  derive: (figure: Figure, state: State) => namesOf(figure, state),

  draw(context: DrawContext, data: Name[]) {
    for (const { text, at, away } of data) {
      const place = context.lens.place(at[0], at[1]);
      if (isSeen(context, place)) context.words.push({ text, at: place, away, gap: DISTANCE, rank: 2 });
    }
  },
};

/** A name appears when the pointer is this near to its point, in CSS pixels. */
const HOVER_RADIUS = 14;

/** Without the layer of names: the name of the construction's point that is under the pointer. */
export const hoveredName = {
  costly: true as const,

  derive(figure: Figure, state: DrawnState): Name[] {
    if (!state.pointer || state.layers.has("names")) return [];
    const layers = new Set([...state.layers].filter((name) => name !== "halves"));
    return namesOf(figure, { ...state, layers });
  },

  draw(context: DrawContext, data: Name[], _: Figure, { pointer }: DrawnState) {
    if (!pointer) return;
    const here = context.lens.place(...pointer);
    const distances = data.map(({ at }) => {
      const [x, y] = context.lens.place(at[0], at[1]);
      return Math.hypot(x - here[0], y - here[1]);
    });
    const min = Math.min(...distances);
    if (min <= HOVER_RADIUS * context.px) names.draw(context, [data[distances.indexOf(min)]]);
  },
};

/** With the halves shown, the points of both: q and r, of the selected piece. Else the points of the construction. */
export function namesOf(figure: Figure, { layers, labels, basis, segment, t }: State): Name[] {
  if (labels === "none") return [];
  if (layers.has("halves")) {
    const piece = selected(figure, segment);
    return piece && piece.curve.degree <= MAX_DEGREE.b0 ? halfNames(piece.curve.split(t)) : [];
  }
  if (!layers.has("construction") || basis !== "bezier" || figure.degree > MAX_DEGREE[labels]) return [];
  return figure.pieces.flatMap(({ curve, indices }) => constructionNames(curve.deCasteljau(t), labels, indices[0]));
}

function halfNames(halves: Curve[]): Name[] {
  return halves.flatMap((half, side) => {
    const flat = half.controlPoints();
    return Array.from({ length: flat.length / 2 }, (_, i) => {
      const place = (k: number) => (k in flat ? [flat[k], flat[k + 1]] : undefined) as [number, number] | undefined;
      const atCut = side === 0 ? 2 * i + 2 === flat.length : i === 0;
      const neighbours = atCut ? [acrossCut(halves, side)] : [place(2 * i - 2), place(2 * i + 2)];
      const away = pen.awayFrom([flat[2 * i], flat[2 * i + 1]], neighbours);
      return { text: `${"qr"[side]}${i}`, at: flat.subarray(2 * i, 2 * i + 2), away };
    });
  });
}

/**
 * The point next to the cut in the other half: the names of the two points at the cut keep away from it, each on its own side.
 */
function acrossCut(halves: Curve[], side: number): [number, number] {
  const other = halves[1 - side].controlPoints();
  const k = side === 0 ? 2 : other.length - 4;
  return [other[k], other[k + 1]];
}

/**
 * @param first the index of the piece's first point
 */
function constructionNames(levels: Float64Array[], labels: Labels, first: number): Name[] {
  return levels.slice(1).flatMap((flat, k) =>
    Array.from({ length: flat.length / 2 }, (_, i) => ({
      text: nameAt(labels, k + 1, first + i, k + 2 === levels.length),
      at: flat.subarray(2 * i, 2 * i + 2),
      away: awayFrom(levels[k], flat, i),
    })),
  );
}

/** Across the line on which the point lies, to the side where the level below is not. */
function awayFrom(below: Float64Array, flat: Float64Array, i: number): [number, number] {
  const [dx, dy] = [below[2 * i + 2] - below[2 * i], below[2 * i + 3] - below[2 * i + 1]];
  const length = Math.hypot(dx, dy) || 1;
  const next = flat.length > 2 ? (i ? i - 1 : 1) : i;
  const [x, y] = [flat[2 * next] - flat[2 * i], flat[2 * next + 1] - flat[2 * i + 1]];
  const side = dx * y - dy * x > 0 ? 1 : -1;
  return length > 0 && (dx || dy) ? [(side * dy) / length, (-side * dx) / length] : [0, -1];
}

/**
 * The name of a point of the construction: P12, P1223; b₁²; p12, p12-23. The last one is the curve's own.
 *
 * @param level from 1
 * @param index of the first point that it comes from
 */
export function nameAt(labels: Labels, level: number, index: number, last: boolean): string {
  if (labels === "b0") return `b${digits(index, SUBSCRIPTS)}${digits(level, SUPERSCRIPTS)}`;
  if (last) return "B(t)";
  if (labels === "p0") return `p${chained(level, index, "-")}`;
  return `P${chained(level, index + (labels === "P1" ? 1 : 0), "")}`;
}

function chained(level: number, index: number, between: string): string {
  if (level === 1) return `${index}${index + 1 > 9 ? "," : ""}${index + 1}`;
  return chained(level - 1, index, between) + between + chained(level - 1, index + 1, between);
}

const SUBSCRIPTS = "₀₁₂₃₄₅₆₇₈₉";
const SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹";

function digits(number: number, alphabet: string) {
  return [...String(number)].map((digit) => alphabet[Number(digit)]).join("");
}
