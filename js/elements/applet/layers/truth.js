// What is true at each joint now, written beside it.
import { jointsOf, shortWords } from "../joints.js";
import { mark } from "./sheet.js";

/** @typedef {import("./sheet.js").Sheet} Sheet */
/** @typedef {import("../figure.js").Figure} Figure */
/** @typedef {import("../state.js").State} State */

const DISTANCE = 24;
/** More would say nothing. */
const MOST_JOINTS = 12;

export const truth = {
  /**
   * @param {Figure} figure
   * @param {State} state
   */
  derive(figure, { basis }) {
    if (basis !== "bezier" || figure.degree < 2 || figure.pieces.length > MOST_JOINTS) return []; // corners of a polygon need no words
    return jointsOf(figure).map((facts, k) => {
      const { curve } = figure.pieces[k + 1];
      const { x, y } = curve.tangent(0);
      return {
        text: shortWords(facts),
        at: curve.eval(0),
        away: /** @type {[number, number]} */ (x || y ? [-y, x] : [0, 1]),
      };
    });
  },

  /**
   * @param {Sheet} sheet
   * @param {{ text: string, at: { x: number, y: number }, away: [number, number] }[]} data
   */
  draw(sheet, data) {
    for (const { text, at, away } of data) {
      const place = mark(sheet, at.x, at.y, 0);
      if (place) sheet.words.push({ text, at: place, away, gap: DISTANCE, rank: 1 });
    }
  },
};
