// Lines instead of the curve, and how far they are from it: recursive halving with its tree, and even steps of t.
import { stroke } from "../ui/pen.js";
import { short } from "./features.js";
import { deviation, treeOf } from "./halving.js";
import { addThrough, hollows, through } from "./draw-context.js";
import { hue } from "./theme.js";
import { drawDiagram } from "./tree.js";
import { translated } from "../editor/translations.js";
import type { DrawContext } from "./draw-context.js";
import type { Figure } from "../editor/figure.js";
import type { State } from "../editor/state.js";

const WIDTH = 2;
/** More hollow marks than these would hide the line. */
const MAX_MARKS = 300;

export const tree = {
  name: "tree",
  title: () => translated("Recursive halving"),
  costly: true as const,

  derive: (figure: Figure, state: State) => treeOf(figure, state),

  draw(context: DrawContext, { leaves, roots }: ReturnType<typeof treeOf>, figure: Figure) {
    const deepest = Math.max(0, ...leaves.map(({ depth }) => depth));
    for (let depth = 0; depth <= deepest; depth++) {
      through(context, []);
      for (const leaf of leaves) if (leaf.depth === depth) addThrough(context, leaf.chord);
      stroke(context, hue(context.theme, depth + 1), WIDTH);
    }
    if (leaves.length <= MAX_MARKS)
      for (const { chord, depth } of leaves) hollows(context, chord, hue(context.theme, depth + 1));
    drawDiagram(context, roots, figure);
  },

  describe: ({ segments, error, tolerance }: ReturnType<typeof treeOf>) =>
    translated(
      "Halved until D1 − D2 < {0}: {1}, greatest error {2} px",
      Number(tolerance.toPrecision(3)),
      count(segments),
      small(error),
    ),
};

export const segments = {
  name: "segments",
  title: () => translated("Polyline of even steps"),
  costly: true as const,

  derive({ pieces }: Figure, { segments }: State) {
    const ts = Float64Array.from({ length: segments + 1 }, (_, k) => k / segments);
    const lines = pieces.map(({ curve }) => curve.sample(segments));
    const error = pieces.reduce((max, { curve }) => Math.max(max, deviation(curve, ts)), 0);
    return { lines, error, segments: segments * pieces.length };
  },

  draw(context: DrawContext, { lines, segments }: { lines: Float64Array[]; segments: number }) {
    through(context, []);
    for (const flat of lines) addThrough(context, flat);
    stroke(context, context.theme.handle, WIDTH);
    if (segments <= MAX_MARKS) for (const flat of lines) hollows(context, flat, context.theme.handle);
  },

  describe: ({ segments, error }: { segments: number; error: number }) =>
    translated("Even steps of t: {0}, greatest error {1} px", count(segments), small(error)),
};

function count(segments: number) {
  return segments === 1 ? translated("1 segment") : translated("{0} segments", segments);
}

function small(error: number) {
  return error >= 100 ? short(error) : String(Number(error.toPrecision(2)));
}
