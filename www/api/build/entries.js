// Reads the texts that the sources cannot give: one Markdown file for each entry, www/api/entries/<class>/<name>.md. README.md in
// that folder describes the form.
import { readdirSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const ENTRIES = fileURLToPath(new URL("../entries/", import.meta.url));

/** The headings that a file may have, in the order in which a page shows them. */
export const SECTIONS = ["Guarantee", "Cost", "Degenerate case", "Errors", "Peers", "Rust"];

/**
 * @typedef {{ info: string, language: string, code: string }} Block
 * @typedef {{ text: string, blocks: Block[] }} Section
 * @typedef {{ file: string, js?: Block, rust?: Block, draw?: Block, figure: string, sections: Map<string, Section> }} Entry
 */

/**
 * All entries of a folder by their names.
 *
 * @param {string} folder
 * @returns {Map<string, Entry>}
 */
export function readEntries(folder) {
  const files = readdirSync(`${ENTRIES}${folder}`).filter((name) => name.endsWith(".md"));
  return new Map(
    files.map((name) => [
      name.slice(0, -3),
      parseEntry(readFileSync(`${ENTRIES}${folder}/${name}`, "utf8"), `${folder}/${name}`),
    ]),
  );
}

/** The folders with entries. */
export const entryFolders = () =>
  readdirSync(ENTRIES, { withFileTypes: true })
    .filter((item) => item.isDirectory())
    .map((item) => item.name);

/**
 * @param {string} text
 * @param {string} file for messages
 * @returns {Entry}
 */
export function parseEntry(text, file) {
  const [head, ...rest] = text.split(/^## /m);
  const main = section(head);
  const block = (/** @type {string} */ language) => main.blocks.find((candidate) => candidate.language === language);
  const sections = new Map();
  for (const part of rest) {
    const name = part.slice(0, part.indexOf("\n")).trim();
    if (!SECTIONS.includes(name))
      throw new Error(`${file}: expected one of ${SECTIONS.join(", ")}, got the heading ${name}`);
    sections.set(name, section(part.slice(part.indexOf("\n"))));
  }
  const unknown = main.blocks.find(({ language }) => !["js", "rust", "draw"].includes(language));
  if (unknown) throw new Error(`${file}: expected a block of js, rust or draw, got ${unknown.language}`);
  return { file, js: block("js"), rust: block("rust"), draw: block("draw"), figure: main.text, sections };
}

/** @param {string} text @returns {Section} */
function section(text) {
  const blocks = /** @type {Block[]} */ ([]);
  const rest = text.replace(/^```(\w+) ?(.*)\n([\s\S]*?)^```$/gm, (_, language, info, code) => {
    blocks.push({ language, info, code: code.trimEnd() });
    return "";
  });
  return { text: rest.trim(), blocks };
}

const ARROW = "// → ";

/**
 * The printed lines that a sample promises: the texts after "// → ".
 *
 * @param {string} code
 */
export const expectedLines = (code) =>
  code
    .split("\n")
    .filter((line) => line.includes(ARROW))
    .map((line) => line.slice(line.indexOf(ARROW) + ARROW.length));

/**
 * Lines such as `curve.eval(NaN) // → RangeError: …`, as pairs.
 *
 * @param {Section | undefined} part
 */
export const promisesOf = (part) =>
  (part?.blocks ?? [])
    .flatMap(({ code }) => code.split("\n"))
    .filter((line) => line.includes(ARROW))
    .map((line) => ({
      code: line.slice(0, line.indexOf(ARROW)).trim(),
      result: line.slice(line.indexOf(ARROW) + ARROW.length),
    }));
