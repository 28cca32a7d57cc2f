// The pages of the site: Markdown and Nunjucks below www/. Vite takes the HTML from memory (build/pages.js).
import { addGallery } from "./build/gallery.js";
import { includeFiles } from "./build/include.js";
import { contentsOf, nextChapter, pathToRoot, readingTime } from "./build/layout.js";
import { addAppletPosters } from "./build/posters.js";
import { sampleCode } from "./build/samples.js";
import { siteBar } from "./build/site-bar.js";
import { addSurfacePosters } from "./build/surface-posters.js";
import { codeHighlighter } from "./build/highlight.js";
import { homeData } from "./build/home.js";
import { markdown } from "./build/markdown.js";
import { NAVIGATION } from "./build/navigation.js";

/** @typedef {{ data: { chapter?: number } }} Page */

/** The chapters in order. @param {Page[]} pages */
function chapters(pages) {
  const number = (/** @type {Page} */ { data }) => data.chapter ?? 0;
  return pages.filter(number).sort((a, b) => number(a) - number(b));
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
  eleventy.addPreprocessor("include", "md", includeFiles);
  eleventy.addFilter("pathToRoot", pathToRoot);
  eleventy.addFilter("readingTime", readingTime);
  eleventy.addFilter("nextChapter", nextChapter);
  eleventy.addFilter("siteBar", siteBar);
  eleventy.addGlobalData("navigation", () => NAVIGATION);
  // build/pages.js says whether dist/ is there to be measured.
  eleventy.addGlobalData("home", () => homeData(highlight, eleventy.hasPackage));
  eleventy.addFilter("contentsOf", contentsOf);
  eleventy.addTransform("gallery", addGallery);
  eleventy.addTransform("posters", (/** @type {string} */ html) => addSurfacePosters(addAppletPosters(html)));
  eleventy.addCollection("chapters", (/** @type {{ getAll(): Page[] }} */ collections) =>
    chapters(collections.getAll()),
  );
  eleventy.setTemplateFormats(["md", "njk", "11ty.js"]);
  eleventy.ignores.add("**/api/entries/**"); // read by api/build/entries.js
  eleventy.ignores.add("**/sections/**"); // included in their chapter
  return {
    dir: { includes: "_layouts", layouts: "_layouts", data: "_data" },
    markdownTemplateEngine: false, // braces belong to formulas
  };
}
