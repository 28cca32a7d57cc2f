// All layers, and the picture that they make together. Drawing is a function of its arguments only.
import * as base from "./base.js";
import * as construction from "./construction.js";
import * as features from "./features.js";
import * as measures from "./measures.js";
import { names } from "./names.js";
import * as polylines from "./polylines.js";
import { bounded } from "./bounded.js";
import { sheetOn } from "./sheet.js";
import * as envelope from "./envelope.js";
import { truth } from "./truth.js";
import * as ways from "./ways.js";
import { weights } from "./weights.js";
import { writeWords } from "./words.js";

export { LEVELS, ROLES } from "./theme.js";

/** @typedef {import("./sheet.js").Sheet} Sheet */
/** @typedef {import("./theme.js").Role} Role */
/** @typedef {import("../figure.js").Figure} Figure */
/** @typedef {import("../state.js").State} State */
/** @typedef {import("../state.js").LayerName} LayerName */

/**
 * @typedef {object} Layer
 * @property {string} [name] by which it is switched; else it is always there
 * @property {string} [title] what a switch says
 * @property {(figure: Figure, state: State) => any} derive what is drawn, asked of the core, in the plane's numbers
 * @property {(sheet: Sheet, data: any, figure: Figure, state: State) => void} draw
 * @property {(data: any, state: State) => string} [tell] what it found, in words
 * @property {true} [costly] asks much of each piece, and therefore not of all of a long chain
 */

/** @typedef {{ name: string, words: string }} Told */

/** From the back to the front. @type {readonly Layer[]} */
const ALL = [
  construction.hull,
  envelope.envelope,
  weights,
  features.bounds,
  construction.polygon,
  base.waiting,
  ways.comb,
  measures.offset,
  envelope.extrapolation,
  base.curve,
  construction.halves,
  polylines.segments,
  polylines.tree,
  measures.ticks,
  base.joints,
  ways.normals,
  ways.tangents,
  base.handles,
  construction.construction,
  features.extrema,
  features.inflections,
  measures.nearest,
  names,
  truth,
  base.points,
  base.atT,
];

/** The layers that can be switched, from the back to the front. */
export const LAYERS = /** @type {readonly (Layer & { name: LayerName, title: string })[]} */ (
  ALL.filter(({ name }) => name)
);

/**
 * Draws everything on a cleared canvas.
 *
 * @param {import("../../../applet/pen.js").Paper<Role>} paper its context is scaled to the box; the view is seen to here
 * @param {State} state
 * @param {Figure} figure
 * @returns {Told[]} what the layers tell
 */
export function drawFigure(paper, state, figure) {
  const sheet = sheetOn(paper, state);
  const { ctx } = paper;
  ctx.clearRect(0, 0, state.box.width, state.box.height);
  ctx.lineJoin = ctx.lineCap = "round";
  const part = bounded(figure);
  const told = ALL.filter(({ name }) => !name || state.layers.has(/** @type {LayerName} */ (name))).flatMap((layer) =>
    drawLayer(layer, sheet, layer.costly ? part : figure, state),
  );
  writeWords(sheet);
  if (part !== figure)
    told.push({
      name: "",
      words: `Layers are drawn on the first ${part.pieces.length} of ${figure.pieces.length} pieces`,
    });
  return told;
}

/**
 * What the core refuses (a size at which its numbers end) is left out, and told.
 *
 * @param {Layer} layer
 * @param {Sheet} sheet
 * @param {Figure} figure
 * @param {State} state
 * @returns {Told[]}
 */
function drawLayer({ name = "", title, derive, draw, tell }, sheet, figure, state) {
  try {
    const data = derive(figure, state);
    draw(sheet, data, figure, state);
    const words = tell?.(data, state);
    return words ? [{ name, words }] : [];
  } catch (error) {
    if (!(error instanceof RangeError)) throw error;
    return [{ name, words: `${title ?? "The curve"} cannot be drawn here: ${error.message}` }];
  }
}
