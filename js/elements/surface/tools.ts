import { html, svg } from "lit";
import { translated } from "../../editor/translations.js";

const path = (d: string) => svg`<path d=${d} />`;
const PAUSE = path("M8 5v14M16 5v14");
const ROUND = path("M20 12a8 8 0 1 1-2.5-5.8M18 2v4.5h-4.5");
const PLUS = path("M12 5v14M5 12h14");
const MINUS = path("M5 12h14");
const HOUSE = path("M4 11l8-7 8 7M6.5 9.5V20h11V9.5");

/** The buttons over the picture, which do what the wheel and two fingers do. */
export function tools({
  isRotating,
  toggle,
  nearer,
  farther,
  home,
}: {
  isRotating: boolean;
  toggle: () => void;
  nearer: () => void;
  farther: () => void;
  home: () => void;
}) {
  const button = (name: string, act: () => void, picture: unknown) =>
    html`<button type="button" aria-label=${name} title=${name} @click=${act}><svg viewBox="0 0 24 24" aria-hidden="true">${picture}</svg></button>`;
  return html`<div class="tools" part="tools">
    ${button(isRotating ? translated("Stop rotating") : translated("Rotate"), toggle, isRotating ? PAUSE : ROUND)}
    ${button(translated("Nearer"), nearer, PLUS)} ${button(translated("Farther"), farther, MINUS)} ${button(translated("First view"), home, HOUSE)}
  </div>`;
}
