import { html, nothing } from "lit";
import { panel } from "./panel.js";
import { keys } from "./tools.js";
import { INSTRUCTIONS } from "./words.js";

/**
 * Everything in the shadow root.
 *
 * @slot label - a title above the picture
 * @slot caption - a text below it
 * @slot default - the poster, where none has the name
 * @slot poster - what is shown before the picture is there, without scripts and on paper: an SVG, say
 * @slot coordinates - the table of the panel
 * @csspart frame - picture, message and panel
 * @csspart stage - the picture with its handles
 * @csspart canvas - the picture
 * @csspart overlay - where the handles are
 * @csspart handle - each handle: its hit box
 * @csspart message - what could not be done
 * @csspart controls - the panel
 * @csspart joints - what holds at each joint
 * @fires input - while the user moves something
 * @fires change - when that is done
 * @fires update - after every change, whoever made it; does not bubble
 *
 * @param {object} parts
 * @param {string} parts.name what the picture is called
 * @param {string} parts.message what could not be done
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
