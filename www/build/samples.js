// The code of the samples, written into the pages while the site is built, so that it can be read, found and printed without
// JavaScript. It is the code that the tests run, without its wrapper.
import { existsSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

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

/**
 * A sample's code in both languages, as HTML.
 *
 * @param {string} name
 * @param {(code: string, language: string) => string} highlight
 */
export function sampleCode(name, highlight) {
  const { js, rs } = sampleParts(name, highlight);
  const pre = (/** @type {string} */ language, /** @type {string} */ code) =>
    `<pre tabindex="0" data-language="${language}"><code>${code}</code></pre>`;
  return pre("js", js) + pre("rs", rs);
}

/**
 * A sample's code in each language, as HTML, and what it prints.
 *
 * @param {string} name
 * @param {(code: string, language: string) => string} highlight
 */
export function sampleParts(name, highlight) {
  if (!existsSync(`${folder}${name}.js`)) throw new Error(`expected the sample www/samples/${name}.js`);
  const read = (/** @type {string} */ ending) => readFileSync(`${folder}${name}.${ending}`, "utf8");
  const code = (/** @type {"js" | "rs"} */ language) => highlight(unwrap(read(language), language), language);
  return { js: code("js"), rs: code("rs"), output: read("txt").trim() };
}
