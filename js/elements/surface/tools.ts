import { html, svg } from "lit";
import { translated } from "../../editor/translations.js";
import { ZOOM_STEP } from "./camera.js";
import type { SurfaceController } from "./controller.js";

const path = (d: string) => svg`<path d=${d} />`;
const PAUSE = path("M8 5v14M16 5v14");
const ROUND = path("M20 12a8 8 0 1 1-2.5-5.8M18 2v4.5h-4.5");
const PLUS = path("M12 5v14M5 12h14");
const MINUS = path("M5 12h14");
const HOUSE = path("M4 11l8-7 8 7M6.5 9.5V20h11V9.5");

/** The buttons over the picture, which do what the wheel and two fingers do. */
export function tools(controller: SurfaceController) {
  const { isRotating } = controller;
  const button = (name: string, act: () => void, picture: unknown) =>
    html`<button type="button" aria-label=${name} title=${name} @click=${act}><svg viewBox="0 0 24 24" aria-hidden="true">${picture}</svg></button>`;
  return html`<div class="tools" part="tools">
    ${button(isRotating ? translated("Stop rotating") : translated("Rotate"), () => controller.toggleRotation(), isRotating ? PAUSE : ROUND)}
    ${button(translated("Nearer"), () => controller.zoom(ZOOM_STEP), PLUS)} ${button(translated("Farther"), () => controller.zoom(1 / ZOOM_STEP), MINUS)} ${button(translated("First view"), () => controller.goHome(), HOUSE)}
  </div>`;
}
