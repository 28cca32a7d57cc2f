import { html, nothing } from "lit";
import { panel } from "./panel.js";
import { readout } from "./readout.js";
import { tools } from "./tools.js";
import { instructions } from "./words.js";
import type { Facts } from "./geometry.js";
import type { PanelPort } from "./panel.js";

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
 * @param parts.name what the picture is called
 * @param parts.blank the canvas holds no picture: what the page put into the element stands in for the picture
 * @param parts.message an error message
 * @param parts.language of numbers
 * @param parts.key what a key does that was pressed anywhere in it
 * @param parts.panel null: none
 */
export function frame({
  name,
  blank,
  message,
  facts,
  language,
  key,
  ...parts
}: {
  name: string;
  blank: boolean;
  message: string;
  facts: Facts | null;
  language: string;
  key: (event: KeyboardEvent) => void;
  tools: Parameters<typeof tools>[0];
  panel: PanelPort | null;
}) {
  return html`<div class="frame" part="frame" @input=${stop} @change=${stop} @keydown=${key}>
    <div class="stage" part="stage" role="group" aria-label=${name}>
      <canvas part="canvas" tabindex="0" role="img" aria-label=${name} aria-describedby="help" width="1" height="1"></canvas>
      ${blank ? poster : nothing}
      <div class="overlay" part="overlay"></div>
      ${tools(parts.tools)}
      <p class="message" role="status">${message}</p>
    </div>
    <p class="away" id="help">${instructions()}</p>
    ${readout(facts, language)} ${parts.panel ? panel(parts.panel) : ""}
    <span class="probe" hidden></span>
  </div>`;
}

const poster = html`<div class="poster"><slot name="poster"><slot></slot></slot></div>`;

/** Events of the controls stay inside: the element fires its own. */
function stop(event: Event) {
  event.stopPropagation();
}
