import { html, nothing } from "lit";
import { INSTRUCTIONS } from "./words.js";

/**
 * Everything in the shadow root. Before the element begins its work there is only what the page put into it.
 *
 * @param {object} parts
 * @param {string} parts.name what the picture is called
 * @param {import("./loading.js").Drawing | null} parts.drawing null: not yet
 * @param {string} parts.message what could not be done
 * @param {import("./panel.js").PanelPort | null} parts.panel null: none
 */
export function frame({ name, drawing, message, panel: port }) {
  return html`<slot name="label"></slot>
    <div class="frame" part="frame" @input=${stop} @change=${stop}>
      <div class="stage" part="stage" role="figure" aria-label=${name} aria-describedby="description">
        ${drawing ? picture : poster} ${drawing && port?.shows("zoom") ? drawing.tools(port) : nothing}
      </div>
      <p class="message" part="message" ?hidden=${!message}>${message}</p>
      ${drawing && port ? drawing.panel(port) : nothing}
      <p class="away" role="status"></p>
      <span class="probe" hidden></span>
    </div>
    <slot name="caption"></slot>`;
}

const poster = html`<div class="poster"><slot name="poster"><slot></slot></slot></div>`;

const picture = html`<p class="away">${INSTRUCTIONS}</p>
  <p class="away" id="description"></p>
  <canvas part="canvas" aria-hidden="true" width="1" height="1"></canvas>
  <div class="overlay" part="overlay"></div>`;

/**
 * Events of the controls stay inside, as the element fires its own; those of what the page put in go on.
 *
 * @param {Event} event
 */
function stop(event) {
  const target = /** @type {Node} */ (event.target);
  if (target.getRootNode() instanceof ShadowRoot && target.getRootNode() === /** @type {Node} */ (event.currentTarget).getRootNode()) event.stopPropagation();
}
