import { html, nothing } from "lit";
import { Memo } from "../../editor/memo.js";
import { twoDigits, upperBound } from "./words.js";
import { translated, translatedParts } from "../../editor/translations.js";
import type { Facts, Recursion } from "./geometry.js";

/** Writes a number, or one that is rounded, in bold. */
type Writer = (x: number | string, digits?: Intl.NumberFormatOptions) => unknown;

/** @param language a tag such as "de"; English if it is none */
function writerFor(language: string): Writer {
  return (x, digits) =>
    html`<b>${/e/.test(`${x}`) ? x : formats.get(`${language} ${JSON.stringify(digits)}`, [], () => formatOf(language, digits)).format(Number(x))}</b>`;
}

/** Kept, because making a format takes longer than the rest of the read-out. */
const formats = new Memo();

function formatOf(language: string, digits?: Intl.NumberFormatOptions) {
  try {
    return new Intl.NumberFormat(language || "en", digits);
  } catch {
    return new Intl.NumberFormat("en", digits);
  }
}

const ROUNDED = { maximumSignificantDigits: 2 };
const TENTHS = { minimumFractionDigits: 1, maximumFractionDigits: 1 };

/**
 * What the picture is made of.
 *
 * @param facts null before the first picture
 * @param language of the numbers
 */
export function readout(facts: Facts | null, language: string) {
  if (!facts) return html`<p class="facts" part="facts">&nbsp;</p>`;
  const bold = writerFor(language);
  return html`<p class="facts" part="facts">
    <span>${translatedParts("{0} triangles", bold(facts.triangles))}</span>
    <span>${translatedParts("{0} vertices", bold(facts.vertices))}</span>
    ${facts.error === null ? nothing : html`<span>${translatedParts("error ≤ {0} {1}", bold(upperBound(facts.error), ROUNDED), facts.unit)}</span>`}
    <span>${facts.ms === null ? translated("by the graphics card") : html`${bold(facts.ms, TENTHS)} ms`}</span>
    ${facts.recursion ? recursionWords(facts.recursion, bold) : nothing}
  </p>`;
}

function recursionWords({ pieces, depth, cracks, widest }: Recursion, bold: Writer) {
  const found = cracks
    ? translatedParts("{0} cracks, up to {1}", bold(cracks), bold(twoDigits(widest), ROUNDED))
    : translatedParts("{0} cracks", bold(0));
  const halved =
    pieces === 1
      ? translated("1 piece, not divided")
      : translatedParts("{0} pieces, {1} deep", bold(pieces), bold(depth));
  return html`<span>${halved}</span>
    <span class="cracks">${found}</span>`;
}
