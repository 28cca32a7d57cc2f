// Colours code, and writes that of every <lesson-sample name="…"> into the page while the site is built, so that it can be read, found
// and printed without JavaScript. What is shown is what the tests run, without its wrapper.
import { existsSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { highlight } from "./highlight.js";

const folder = fileURLToPath(new URL("../samples/", import.meta.url));

/** By language: where the wrapper begins, how deep its body is indented, and how a line is printed outside of it. */
const WRAPPERS = {
  js: { head: /^export function sample\(print\) \{\n/m, indent: 2, print: [[/\bprint\(/g, "console.log("]] },
  rs: {
    head: /^pub\(crate\) fn sample\(out: &mut String\) \{\n/m,
    indent: 4,
    print: [
      [/\bwriteln!\(\s*out, ?(\n?)/g, "println!($1"],
      [/\bwriteln!\(\s*out\s*\)/g, "println!()"],
      [/\bwrite!\(\s*out,\s?/g, "print!("],
    ],
  },
};

/**
 * A sample's code as readers see it: the body of `sample`, with what stands before and after it.
 *
 * @param {string} source
 * @param {"js" | "rs"} language
 * @returns {string}
 */
export function unwrap(source, language) {
  const { head, indent, print } = WRAPPERS[language];
  const [before, rest] = source.split(head);
  if (rest === undefined) throw new Error(`a ${language} sample without the line ${head.source}`);
  const end = rest.search(/^\}\n/m);
  const body = rest.slice(0, end).replace(new RegExp(`^ {${indent}}`, "gm"), "");
  const after = rest.slice(end + 2);
  const shown = print.reduce(
    (text, [from, to]) => text.replace(/** @type {RegExp} */ (from), /** @type {string} */ (to)),
    body + after,
  );
  return `${before.trim()}\n\n${shown.trim()}`.trim();
}

/** @param {string} name */
function written(name) {
  const read = (/** @type {string} */ ending) => readFileSync(`${folder}${name}.${ending}`, "utf8");
  const code = (/** @type {"js" | "rs"} */ language) =>
    `<pre data-language="${language}"><code>${highlight(unwrap(read(language), language), language)}</code></pre>`;
  return code("js") + code("rs");
}

/** What `<code data-code="js">` holds, before it is coloured. @param {string} html */
const plain = (html) => html.replace(/&lt;/g, "<").replace(/&gt;/g, ">").replace(/&amp;/g, "&");

/** Vite's plugin. A sample that is not there fails the build; while working on a page it only says so. */
export const lessonSamples = {
  name: "lesson-samples",
  transformIndexHtml: {
    order: /** @type {const} */ ("pre"),
    handler: (/** @type {string} */ html) =>
      html
        .replace(/(<lesson-sample\b[^>]*\bname="([\w-]+)"[^>]*>)\s*(?=<\/lesson-sample>)/g, (_, tag, name) => {
          if (!existsSync(`${folder}${name}.js`)) throw new Error(`there is no sample www/samples/${name}.js`);
          return tag + written(name);
        })
        .replace(
          /(<code data-code="(\w+)">)([^<]*)(?=<\/code>)/g,
          (_, tag, language, code) => tag + highlight(plain(code), language),
        ),
  },
};
