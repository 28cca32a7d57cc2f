import { html, nothing } from "lit";
import { figures, upperBound } from "./words.js";
import type { Facts, Recursion } from "./geometry.js";

const many = (count: number) => count.toLocaleString("en");

/**
 * What the picture is made of.
 *
 * @param facts null before the first picture
 */
export function readout(facts: Facts | null) {
  if (!facts) return html`<p class="facts" part="facts">&nbsp;</p>`;
  return html`<p class="facts" part="facts">
    <span><b>${many(facts.triangles)}</b> triangles</span>
    <span><b>${many(facts.vertices)}</b> vertices</span>
    ${facts.error === null ? nothing : html`<span>error ≤ <b>${upperBound(facts.error)}</b> ${facts.unit}</span>`}
    <span>${facts.ms === null ? "by the graphics card" : html`<b>${facts.ms.toFixed(1)}</b> ms`}</span>
    ${facts.recursion ? recursionWords(facts.recursion) : nothing}
  </p>`;
}

function recursionWords({ pieces, depth, cracks, widest }: Recursion) {
  return html`<span><b>${many(pieces)}</b> pieces, <b>${depth}</b> deep</span>
    <span class="cracks"><b>${many(cracks)}</b> cracks${cracks ? html`, up to <b>${figures(widest)}</b>` : nothing}</span>`;
}
