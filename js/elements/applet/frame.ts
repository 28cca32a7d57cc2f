import { html, nothing } from "lit";
import { panel } from "./panel.js";
import { keys } from "./tools.js";
import { instructions } from "../../editor/descriptions.js";
import { isHome, weightsOf } from "../../editor/state.js";
import type { AppletController } from "./controller.js";

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
 */
export function frame(controller: AppletController) {
  const { model, message, hasControls, isTapping } = controller;
  const cursor = isTapping ? "place" : isHome(model.state) ? "" : "grab";
  const isGood = model.isSuccess && !model.problems.length;
  return html`<slot name="label"></slot>
    <div class="frame" part="frame" @input=${stop} @change=${stop}>
      <div class="stage" part="stage" role="figure" aria-label=${model.name} aria-describedby="description">
        ${picture(cursor)}
      </div>
      <p class=${isGood ? "message good" : "message"} part="message" ?hidden=${!message}>${message}</p>
      ${hasControls ? panel(controller) : nothing} ${keys(weightsOf(model.state) !== null)}
      <p class="away" role="status"></p>
      <span class="probe" hidden></span>
    </div>
    <slot name="caption"></slot>`;
}

/** @param cursor the class that says what a press on an empty place does */
const picture = (cursor: string) => html`<p class="away">${instructions()}</p>
  <p class="away" id="description"></p>
  <canvas part="canvas" aria-hidden="true" width="1" height="1"></canvas>
  <div class=${`overlay ${cursor}`} part="overlay"></div>`;

/** Events of the controls stay inside, as the element fires its own; those of what the page put in go on. */
function stop(event: Event) {
  const [target, here] = [event.target as Node, event.currentTarget as Node];
  if (target.getRootNode() === here.getRootNode()) event.stopPropagation();
}
