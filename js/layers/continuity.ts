// What is true at each joint now, written beside it.
import { jointsOf, shortWords } from "../editor/joints.js";
import { mark } from "./draw-context.js";
import type { DrawContext } from "./draw-context.js";
import type { Figure } from "../editor/figure.js";
import type { State } from "../editor/state.js";

const DISTANCE = 24;
/** With more joints, their labels overlap. */
const MAX_JOINTS = 12;

export const continuityLabels = {
  derive(figure: Figure, { basis }: State) {
    if (basis !== "bezier" || figure.degree < 2 || figure.pieces.length > MAX_JOINTS) return []; // corners of a polygon need no words
    return jointsOf(figure).map((facts, k) => {
      const { curve } = figure.pieces[k + 1];
      const { x, y } = curve.tangent(0);
      return {
        text: shortWords(facts),
        at: curve.eval(0),
        away: (x || y ? [-y, x] : [0, 1]) as [number, number],
      };
    });
  },

  draw(context: DrawContext, data: { text: string; at: { x: number; y: number }; away: [number, number] }[]) {
    for (const { text, at, away } of data) {
      const place = mark(context, at.x, at.y, 0);
      if (place) context.words.push({ text, at: place, away, gap: DISTANCE, rank: 1 });
    }
  },
};
