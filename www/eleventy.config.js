// The pages of the site: Markdown and Nunjucks below www/. Vite takes the HTML from memory (build/pages.js).
import { chapterLinks, introductionOf, readChapters } from "./build/chapters.js";
import { addGallery } from "./build/gallery.js";
import { contentsOf, pathToRoot, readingTime } from "./build/layout.js";
import { addAppletPosters } from "./build/posters.js";
import { sampleCode } from "./build/samples.js";
import { siteBar } from "./build/site-bar.js";
import { addSurfacePosters } from "./build/surface-posters.js";
import { codeHighlighter } from "./build/highlight.js";
import { homeData } from "./build/home.js";
import { markdown } from "./build/markdown.js";
import { NAVIGATION } from "./build/navigation.js";

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
  const chapters = readChapters(md);
  eleventy.addGlobalData("chapters", chapters);
  eleventy.addGlobalData(
    "sections",
    chapters.flatMap(({ sections }) => sections),
  );
  eleventy.addPreprocessor(
    "introduction",
    "md",
    (/** @type {{ chapter?: number }} */ { chapter }, /** @type {string} */ text) =>
      chapter ? introductionOf(text) : text,
  );
  eleventy.addTransform("chapter-links", chapterLinks(chapters));
  eleventy.addFilter("pathToRoot", pathToRoot);
  eleventy.addFilter("readingTime", readingTime);
  eleventy.addFilter("siteBar", siteBar);
  eleventy.addGlobalData("navigation", () => NAVIGATION);
  // build/pages.js says whether dist/ is there to be measured.
  eleventy.addGlobalData("home", () => homeData(highlight, eleventy.hasPackage));
  eleventy.addFilter("contentsOf", contentsOf);
  eleventy.addTransform("gallery", addGallery);
  eleventy.addTransform("posters", (/** @type {string} */ html) => addSurfacePosters(addAppletPosters(html)));
  eleventy.setTemplateFormats(["md", "njk", "11ty.js"]);
  eleventy.ignores.add("**/api/entries/**"); // read by api/build/entries.js
  eleventy.ignores.add("**/sections/**"); // included in their chapter
  return {
    dir: { includes: "_layouts", layouts: "_layouts", data: "_data" },
    markdownTemplateEngine: false, // braces belong to formulas
  };
}
