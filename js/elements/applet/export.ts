// The figure as a picture.
import { drawFigure } from "../../layers/draw-figure.js";
import type { Layer } from "../../layers/draw-figure.js";
import type { Theme } from "../../layers/theme.js";
import type { DrawnState } from "../../editor/state.js";
import type { Figure } from "../../editor/figure.js";

/** The picture as PNG, as sharp as the page shows it. */
export function blobOf(
  state: DrawnState,
  figure: Figure,
  theme: Theme,
  layers: readonly Layer[],
): Promise<Blob | null> {
  const scale = Math.max(1, devicePixelRatio);
  const canvas = Object.assign(document.createElement("canvas"), {
    width: state.box.width * scale,
    height: state.box.height * scale,
  });
  const ctx = canvas.getContext("2d") as CanvasRenderingContext2D;
  ctx.scale(scale, scale);
  drawFigure({ ctx, theme, px: 1 }, state, figure, layers);
  ctx.globalCompositeOperation = "destination-over"; // the background lies below
  ctx.fillStyle = theme.paper;
  ctx.fillRect(0, 0, state.box.width, state.box.height);
  return new Promise((done) => canvas.toBlob(done));
}
