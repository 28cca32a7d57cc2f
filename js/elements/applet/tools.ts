import { html } from "lit";
import { button, icon } from "../../ui/controls.js";
import { keyList } from "../../editor/descriptions.js";
import { translated } from "../../editor/translations.js";
import type { AppletController } from "./controller.js";

/** The buttons on the picture. */
export function tools(controller: AppletController) {
  return html`<div class="tools" role="group" aria-label=${translated("Zoom")}>
    ${button(icon("M12 5v14M5 12h14"), () => controller.zoom(2), { name: translated("Closer") })} ${button(icon("M5 12h14"), () => controller.zoom(1 / 2), { name: translated("Farther") })}
    ${button(icon("M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5"), () => controller.zoomToFit(), { name: translated("Whole picture") })}
  </div>`;
}

/**
 * All keys.
 *
 * @param weights whether there are weights
 */
export const keys = (weights: boolean) => html`<dialog aria-labelledby="keys"><h2 id="keys">${translated("Keys")}</h2>
  <dl>${keyList(weights).map(([key, words]) => html`<dt><kbd>${key}</kbd></dt><dd>${words}</dd>`)}</dl>
  <form method="dialog"><button>${translated("Close")}</button></form></dialog>`;
