// The picture that some layers make together. Drawing is a function of its arguments only.
import { bounded } from "./bounded.js";
import { contextOn } from "./draw-context.js";
import { writeWords } from "./words.js";
import { translated } from "../editor/translations.js";
import type { DrawContext } from "./draw-context.js";
import type { Role } from "./theme.js";
import type { Figure } from "../editor/figure.js";
import type { DrawnState, LayerName } from "../editor/state.js";
import type { PenContext } from "../ui/pen.js";

export interface Layer {
  /** By which it is switched; else it is always there */
  name?: string;
  /** What a switch says */
  title?: () => string;
  /** What is drawn, asked of the core, in the plane's numbers */
  derive: (figure: Figure, state: DrawnState) => any;
  draw: (context: DrawContext, data: any, figure: Figure, state: DrawnState) => void;
  /** What it found, in words */
  describe?: (data: any, state: DrawnState) => string;
  /** Asks much of each piece, and therefore not of all of a long chain */
  costly?: true;
}

export type LayerMessage = { name: string; words: string };

/**
 * Draws everything on a cleared canvas.
 *
 * @param pen its context is scaled to the view box; the view is applied here
 * @param layers from the back to the front
 * @returns the messages of the layers
 */
export function drawFigure(
  pen: PenContext<Role>,
  state: DrawnState,
  figure: Figure,
  layers: readonly Layer[],
): LayerMessage[] {
  const context = contextOn(pen, state);
  const { ctx } = pen;
  ctx.clearRect(0, 0, state.box.width, state.box.height);
  ctx.lineJoin = ctx.lineCap = "round";
  const part = bounded(figure);
  const messages = layers
    .filter(({ name }) => !name || state.layers.has(name as LayerName))
    .flatMap((layer) => drawLayer(layer, context, layer.costly ? part : figure, state));
  writeWords(context);
  if (part !== figure)
    messages.push({
      name: "",
      words: translated(
        "Layers are drawn on the first {0} of {1} pieces",
        part.pieces.length + part.rational.length,
        figure.pieces.length + figure.rational.length,
      ),
    });
  return messages;
}

/** A layer that the core refuses, because its numbers overflow, is left out; its message says so. */
function drawLayer(
  { name = "", title, derive, draw, describe }: Layer,
  context: DrawContext,
  figure: Figure,
  state: DrawnState,
): LayerMessage[] {
  try {
    const data = derive(figure, state);
    draw(context, data, figure, state);
    const words = describe?.(data, state);
    return words ? [{ name, words }] : [];
  } catch (error) {
    if (!(error instanceof RangeError)) throw error;
    return [
      { name, words: translated("{0} cannot be drawn here: {1}", title?.() ?? translated("The curve"), error.message) },
    ];
  }
}
