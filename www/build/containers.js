// What stands between `:::` lines in Markdown:
//
//     ::: figure curve              a figure with the id figure-curve; its last paragraph is the caption
//     ::: task half-height for=ID   a task (www/tasks/half-height.js) about the element with that id; its own is task-half-height
//     ::: sample polyline           the sample www/samples/polyline.js and .rs, with the id sample-polyline
//     ::: recipe NAME               the picture, the script and the HTML of www/recipes/code/NAME.js and .html
//     ::: article                   an `<article>`
import container from "markdown-it-container";
import { permalink } from "./markdown.js";
import { codeHtml, recipeHtml } from "./recipes.js";
import { sampleCode } from "./samples.js";

/** @typedef {import("markdown-it").default} MarkdownIt */
/** @typedef {import("markdown-it").Token} Token */
/** @typedef {{ open(token: Token): string, close: string }} Container */

/**
 * @param {MarkdownIt} md
 * @param {{ highlight: (code: string, language: string) => string }} options
 */
export function containers(md, { highlight }) {
  /** @type {Record<string, Container>} */
  const kinds = {
    figure: { open: ({ meta }) => `<figure id="figure-${meta.name}">\n<div class="sheet">\n`, close: "</figure>\n" },
    task: {
      open: ({ meta }) => `<lesson-task id="task-${meta.name}"${attributesOf(meta)}>\n`,
      close: "</lesson-task>\n",
    },
    sample: {
      open: ({ meta }) =>
        `<lesson-sample id="sample-${meta.name}" name="${meta.name}">${sampleCode(meta.name, highlight)}`,
      close: "</lesson-sample>\n",
    },
    recipe: { open: ({ meta }) => recipeHtml(meta.name, highlight), close: "" },
    "recipe-file": { open: ({ meta }) => codeHtml(meta.name, highlight), close: "" },
    article: { open: () => "<article>\n", close: "</article>\n" },
  };
  for (const [kind, { open, close }] of Object.entries(kinds)) {
    md.use(container, kind, {
      render: (/** @type {Token[]} */ tokens, /** @type {number} */ i) =>
        tokens[i].nesting === 1 ? open(tokens[i]) : (tokens[i].meta?.close ?? close),
    });
  }
  md.core.ruler.push("containers", ({ tokens }) => {
    for (const token of tokens) if (/^container_[\w-]+_open$/.test(token.type)) token.meta = parametersOf(token.info);
  });
  md.core.ruler.push("captions", captions);
  md.renderer.rules.paragraph_open = (tokens, i, options, _, self) =>
    (tokens[i].tag === "figcaption" ? "</div>\n" : "") + self.renderToken(tokens, i, options);
}

/** "figure curve for=a" as { name: "curve", for: "a" }. @param {string} info */
function parametersOf(info) {
  const [kind, name, ...others] = info.trim().split(/\s+/);
  if (!name && kind !== "article") throw new Error(`expected a name after “::: ${kind}”`);
  return { name, ...Object.fromEntries(others.map((each) => each.split("="))) };
}

/** @param {Record<string, string>} values */
const attributesOf = ({ number, ...values }) =>
  Object.entries({ ...values, ...(number && { "data-number": number }) })
    .map(([name, value]) => ` ${name}="${value}"`)
    .join("");

/**
 * A figure is a sheet with all its elements, and below it the caption: the last paragraph, with the figure's number and a link.
 *
 * @param {import("markdown-it").StateCore} state
 */
function captions({ tokens, Token }) {
  tokens.forEach((token, i) => {
    if (token.type !== "container_figure_close") return;
    if (tokens[i - 1].type !== "paragraph_close" || tokens[i - 1].hidden) {
      token.meta = { close: "</div>\n</figure>\n" };
      return;
    }
    const figure = tokens.findLast((each, k) => k < i && each.type === "container_figure_open");
    tokens[i - 3].tag = tokens[i - 1].tag = "figcaption";
    const [number, link] = [new Token("html_inline", "", 0), new Token("html_inline", "", 0)];
    number.content = figure?.meta.number ? `<span class="nr">Figure ${figure.meta.number}</span> ` : "";
    link.content = permalink(`figure-${figure?.meta.name}`, "Link to this figure");
    tokens[i - 2].children = [number, ...(tokens[i - 2].children ?? []), link];
  });
}
