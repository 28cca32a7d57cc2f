// A recipe of /recipes/: its picture, and the code that draws it, as readers copy it. The page runs the same script.
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const folder = fileURLToPath(new URL("../recipes/code/", import.meta.url));
const read = (/** @type {string} */ file) => readFileSync(`${folder}${file}`, "utf8").trim();

/**
 * @param {string} name
 * @param {(code: string, language: string) => string} highlight
 */
export function recipeHtml(name, highlight) {
  const html = read(`${name}.html`);
  return `<figure class="recipe" data-recipe="${name}">\n${html}\n</figure>
${codeHtml(`${name}.js`, highlight)}
<details class="recipe-code"><summary>HTML</summary>${codeHtml(`${name}.html`, highlight)}</details>\n`;
}

/** A file of www/recipes/code/ in colours. @param {string} file @param {(code: string, language: string) => string} highlight */
export const codeHtml = (file, highlight) =>
  `<pre tabindex="0"><code>${highlight(read(file), file.replace(/.*\./, ""))}</code></pre>`;
