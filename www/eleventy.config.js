// The pages of the site: Markdown and Nunjucks below www/. Vite takes the HTML from memory (build/pages.js).
import { contentsOf, pathToRoot } from "./build/layout.js";
import { addAppletPosters } from "./build/posters.js";
import { sampleCode } from "./build/samples.js";
import { addSurfacePosters } from "./build/surface-posters.js";
import { codeHighlighter } from "./build/highlight.js";
import { markdown } from "./build/markdown.js";

/** @typedef {{ data: { navigation?: { name: string, order: number } } }} Page */

/** The pages that every page links to, in order. @param {Page[]} pages */
function navigation(pages) {
  const order = (/** @type {Page} */ { data }) => data.navigation?.order ?? 0;
  return pages.filter(order).sort((a, b) => order(a) - order(b));
}

/** @param {any} eleventy */
export default async function configure(eleventy) {
  const highlight = await codeHighlighter();
  const md = markdown(highlight);
  eleventy.setLibrary("md", md);
  eleventy.addFilter("markdown", (/** @type {string} */ text) => md.renderInline(text));
  eleventy.addFilter("highlight", highlight);
  eleventy.addGlobalData("layout", "page.njk");
  eleventy.addShortcode(
    "sample",
    (/** @type {string} */ name) => `<lesson-sample name="${name}">${sampleCode(name, highlight)}</lesson-sample>`,
  );
  eleventy.addPairedShortcode(
    "code",
    (/** @type {string} */ code, /** @type {string} */ language) =>
      `<pre tabindex="0"><code>${highlight(code, language)}</code></pre>`,
  );
  eleventy.addFilter("pathToRoot", pathToRoot);
  eleventy.addFilter("contentsOf", contentsOf);
  eleventy.addTransform("posters", (/** @type {string} */ html) => addSurfacePosters(addAppletPosters(html)));
  eleventy.addCollection("navigation", (/** @type {{ getAll(): Page[] }} */ collections) =>
    navigation(collections.getAll()),
  );
  eleventy.setTemplateFormats(["md", "njk", "11ty.js"]);
  return {
    dir: { includes: "_layouts", layouts: "_layouts", data: "_data" },
    markdownTemplateEngine: false, // braces belong to formulas
  };
}
