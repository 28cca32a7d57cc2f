// Markdown as the pages use it: sections, figures, tasks, samples, formulas and coloured code. CONTRIBUTING.md describes it.
import { tex } from "@mdit/plugin-tex";
import markdownIt from "markdown-it";
import anchor from "markdown-it-anchor";
import attributes from "markdown-it-attrs";
import temml from "temml";
import { containers } from "./containers.js";
import { unbrokenPunctuation } from "./punctuation.js";
import { scenes } from "./scenes.js";
import { numbers, sections, standaloneElements } from "./sections.js";

/** A symbol with primes, and a power. */
const PRIMES =
  /<msup>(<mi[^>]*>[^<]*<\/mi>)(?:<mrow[^>]*>)?((?:<mo [^>]*class="tml-prime[^"]*">′<\/mo>)+)(<mn>[^<]*<\/mn>)?(?:<\/mrow>)?<\/msup>/g;

/**
 * Typesets a formula as MathML. The primes of the font are raised already: as superscripts they would be small and high.
 *
 * @param {string} formula
 * @param {boolean} displayMode
 */
export const typeset = (formula, displayMode) =>
  temml
    .renderToString(formula.trim(), { displayMode, throwOnError: true, strict: true })
    .replace(PRIMES, (_, symbol, primes, power) => {
      const row = `<mrow>${symbol}${primes}</mrow>`;
      return power ? `<msup>${row}${power}</msup>` : row;
    });

/** A link to itself at the end of a heading or caption. @param {string} id @param {string} label */
export const permalink = (id, label) => ` <a class="permalink" href="#${id}" aria-label="${label}">#</a>`;

/** @param {(code: string, language: string) => string} highlight */
export function markdown(highlight) {
  const md = markdownIt({ html: true });
  md.use(/** @type {any} */ (attributes)); // its types are those of another version of markdown-it
  md.use(/** @type {any} */ (anchor), { level: [2, 3], tabIndex: false, slugify, permalink: headingPermalink });
  md.use(tex, { render: typeset, delimiters: "dollars" });
  md.renderer.rules.fence = (tokens, i) =>
    `<pre tabindex="0"><code>${highlight(tokens[i].content.trimEnd(), tokens[i].info.trim())}</code></pre>\n`;
  md.use(containers, { highlight });
  md.use(standaloneElements);
  md.use(sections);
  md.use(numbers);
  md.use(scenes);
  md.use(unbrokenPunctuation);
  return md;
}

/** The id of a heading that has none of its own: letters, digits and hyphens. @param {string} title */
const slugify = (title) =>
  title
    .normalize("NFD")
    .toLowerCase()
    .replace(/[\u0300-\u036f'’]/g, "")
    .replace(/[^a-z0-9]+/g, "-")
    .replace(/^-|-$/g, "");

/**
 * @param {string} slug
 * @param {unknown} _options
 * @param {import("markdown-it").StateCore} state
 * @param {number} index of the heading's opening token
 */
function headingPermalink(slug, _options, state, index) {
  const link = new state.Token("html_inline", "", 0);
  link.content = permalink(slug, "Link to this section");
  state.tokens[index + 1].children?.push(link);
}
