import { html, nothing } from "lit";
import { figures, upperBound } from "./words.js";
import { translated, translatedParts } from "../../editor/translations.js";
import type { Facts, Recursion } from "./geometry.js";

const many = (count: number) => count.toLocaleString("en");
const bold = (text: string) => html`<b>${text}</b>`;

/**
 * What the picture is made of.
 *
 * @param facts null before the first picture
 */
export function readout(facts: Facts | null) {
  if (!facts) return html`<p class="facts" part="facts">&nbsp;</p>`;
  return html`<p class="facts" part="facts">
    <span>${translatedParts("{0} triangles", bold(many(facts.triangles)))}</span>
    <span>${translatedParts("{0} vertices", bold(many(facts.vertices)))}</span>
    ${facts.error === null ? nothing : html`<span>${translatedParts("error ≤ {0} {1}", bold(upperBound(facts.error)), facts.unit)}</span>`}
    <span>${facts.ms === null ? translated("by the graphics card") : html`<b>${facts.ms.toFixed(1)}</b> ms`}</span>
    ${facts.recursion ? recursionWords(facts.recursion) : nothing}
  </p>`;
}

function recursionWords({ pieces, depth, cracks, widest }: Recursion) {
  const found = cracks
    ? translatedParts("{0} cracks, up to {1}", bold(many(cracks)), bold(figures(widest)))
    : translatedParts("{0} cracks", bold("0"));
  return html`<span>${translatedParts("{0} pieces, {1} deep", bold(many(pieces)), bold(String(depth)))}</span>
    <span class="cracks">${found}</span>`;
}
