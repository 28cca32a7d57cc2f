// The picture without WebGL2: the curves of the surface as lines in two dimensions.
import { pixelMatrix } from "./camera.js";
import type { Picture } from "./gl-kit.js";

const STRIPS = 4;

export class FlatView {
  #context;

  constructor(context: CanvasRenderingContext2D) {
    this.#context = context;
  }

  static on(canvas: HTMLCanvasElement) {
    const context = canvas.getContext("2d");
    return context && new FlatView(context);
  }

  draw({ scene, matrices, theme, width, height, ratio }: Picture) {
    const context = this.#context;
    context.clearRect(0, 0, width, height);
    context.beginPath();
    scene.surface.trace(context, { matrix: pixelMatrix(matrices, width, height), lines: STRIPS });
    context.strokeStyle = `rgb(${theme.front.map((x) => Math.round(255 * x)).join(" ")})`;
    context.lineWidth = ratio;
    context.lineJoin = "round";
    context.stroke();
  }

  drop() {}
}
