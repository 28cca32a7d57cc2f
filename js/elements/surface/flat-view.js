// The picture without WebGL2: the curves of the surface as lines in two dimensions.
import { pixelMatrix } from "./camera.js";

/**
 * @import { Picture } from "./gl-view.js"
 */

const STRIPS = 4;

export class FlatView {
  #context;

  /** @param {CanvasRenderingContext2D} context */
  constructor(context) {
    this.#context = context;
  }

  /**
   * @param {HTMLCanvasElement} canvas
   */
  static on(canvas) {
    const context = canvas.getContext("2d");
    return context && new FlatView(context);
  }

  /** @param {Picture} picture */
  draw({ scene, sight, theme, width, height, ratio }) {
    const context = this.#context;
    context.clearRect(0, 0, width, height);
    context.beginPath();
    scene.surface.trace(context, { matrix: pixelMatrix(sight, width, height), lines: STRIPS });
    context.strokeStyle = `rgb(${theme.front.map((x) => Math.round(255 * x)).join(" ")})`;
    context.lineWidth = ratio;
    context.lineJoin = "round";
    context.stroke();
  }

  drop() {}
}
