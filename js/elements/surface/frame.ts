import { html, nothing } from "lit";
import { panel } from "./panel.js";
import { readout } from "./readout.js";
import { tools } from "./tools.js";
import { instructions } from "./words.js";
import type { SurfaceController } from "./controller.js";

/**
 * Everything in the shadow root.
 *
 * @slot default - the poster, if no element has `slot="poster"`
 * @slot poster - shown before the picture is drawn, without scripts and in print: for example an SVG
 * @csspart frame - everything
 * @csspart stage - the picture with its handles and buttons
 * @csspart canvas - the picture
 * @csspart overlay - the layer of the handles
 * @csspart tools - the buttons over the picture
 * @csspart facts - triangles, vertices and error of the mesh
 * @csspart controls - the panel
 * @fires input - during a change by the user
 * @fires change - at the end of a change by the user
 * @fires update - after every change, by the user or the page; does not bubble
 */
export function frame(controller: SurfaceController) {
  const { name, facts, language } = controller;
  return html`<div class="frame" part="frame" @input=${stop} @change=${stop} @keydown=${(event: KeyboardEvent) => controller.press(event)}>
    <div class="stage" part="stage" role="group" aria-label=${name}>
      <canvas part="canvas" tabindex="0" role="img" aria-label=${name} aria-describedby="help" width="1" height="1"></canvas>
      ${controller.isDrawn ? nothing : poster}
      <div class="overlay" part="overlay"></div>
      ${tools(controller)}
      <p class="message" role="status">${controller.message}</p>
    </div>
    <p class="away" id="help">${instructions()}</p>
    ${readout(facts, language)} ${controller.hasControls ? panel(controller) : ""}
    <span class="probe" hidden></span>
  </div>`;
}

/** What the page put into the element stands in for the picture. */
const poster = html`<div class="poster"><slot name="poster"><slot></slot></slot></div>`;

/** Events of the controls stay inside: the element fires its own. */
function stop(event: Event) {
  event.stopPropagation();
}
