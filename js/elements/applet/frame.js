import { html, nothing } from "lit";
import { panel } from "./panel.js";
import { keys } from "./tools.js";
import { INSTRUCTIONS } from "./words.js";

/**
 * Everything in the shadow root.
 *
 * @slot label - a title above the picture
 * @slot caption - a text below it
 * @slot default - the poster, if no element has `slot="poster"`
 * @slot poster - shown before the picture is drawn, without scripts and in print: for example an SVG
 * @slot coordinates - the table of the panel
 * @csspart frame - picture, message and panel
 * @csspart stage - the picture with its handles
 * @csspart canvas - the picture
 * @csspart overlay - the layer of the handles
 * @csspart handle - each handle (its hit area)
 * @csspart message - an error message
 * @csspart controls - the panel
 * @csspart joints - the continuity at each joint
 * @fires input - during a change by the user
 * @fires change - at the end of a change by the user
 * @fires update - after every change, by the user or the page; does not bubble
 *
 * @param {object} parts
 * @param {string} parts.name what the picture is called
 * @param {string} parts.message an error message
 * @param {boolean} parts.good whether the message is good news
 * @param {string} parts.cursor how the picture can be used
 * @param {import("./panel.js").PanelPort | null} parts.panel null: none
 */
export function frame({ name, message, good, cursor, panel: port }) {
  return html`<slot name="label"></slot>
    <div class="frame" part="frame" @input=${stop} @change=${stop}>
      <div class="stage" part="stage" role="figure" aria-label=${name} aria-describedby="description">
        ${picture(cursor)}
      </div>
      <p class=${good ? "message good" : "message"} part="message" ?hidden=${!message}>${message}</p>
      ${port ? panel(port) : nothing} ${keys}
      <p class="away" role="status"></p>
      <span class="probe" hidden></span>
    </div>
    <slot name="caption"></slot>`;
}

/** @param {string} cursor */
const picture = (cursor) => html`<p class="away">${INSTRUCTIONS}</p>
  <p class="away" id="description"></p>
  <canvas part="canvas" aria-hidden="true" width="1" height="1"></canvas>
  <div class=${`overlay ${cursor}`} part="overlay"></div>`;

/**
 * Events of the controls stay inside, as the element fires its own; those of what the page put in go on.
 *
 * @param {Event} event
 */
function stop(event) {
  const [target, here] = [/** @type {Node} */ (event.target), /** @type {Node} */ (event.currentTarget)];
  if (target.getRootNode() === here.getRootNode()) event.stopPropagation();
}
