import { html } from "lit";
import { figures } from "./words.js";

/**
 * @import { Facts } from "./geometry.js"
 */

const THIN_SPACE = "\u2009";

/** @param {number} count */
const many = (count) => count.toLocaleString("en").replaceAll(",", THIN_SPACE);

/**
 * What the picture is made of.
 *
 * @param {Facts | null} facts null before the first picture
 */
export function readout(facts) {
  if (!facts) return html`<p class="facts" part="facts">&nbsp;</p>`;
  return html`<p class="facts" part="facts">
    <span><b>${many(facts.triangles)}</b> triangles</span>
    <span><b>${many(facts.vertices)}</b> vertices</span>
    <span>error ≤ <b>${figures(facts.error)}</b> ${facts.unit}</span>
    <span>${facts.ms === null ? "by the graphics card" : html`<b>${facts.ms.toFixed(1)}</b> ms`}</span>
  </p>`;
}
