// The chapters: www/curves/index.md and www/surfaces/index.md are each rendered once, so that numbers and references run through the
// chapter, and then divided into one page for each section. The page of the chapter keeps the text before the first section.
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { includeFiles } from "./include.js";
import { mathText } from "./math-text.js";

/**
 * @typedef {object} Section
 * @property {string} id
 * @property {string} url from the first page: "/curves/splitting/"
 * @property {number} chapter its index, from 0
 * @property {number} index in the chapter, from 0
 * @property {string} number "1.6"
 * @property {string} title HTML, without the number
 * @property {string} name the title as text
 * @property {string} description the beginning of its text
 * @property {string} html
 * @property {string[]} ids of everything in it
 * @property {string[]} tasks their names
 * @property {{ name: string, number: string, html: string }[]} questions what the tasks ask
 * @property {{ id: string, title: string }[]} parts its headings
 */
/** @typedef {{ path: string, heading: string, html: string, tasks: string[], sections: Section[] }} Chapter path: "curves/" */

const www = fileURLToPath(new URL("../", import.meta.url));
const PATHS = ["curves/", "surfaces/"];
const TASK = /<lesson-task [^>]*name="([^"]+)"[^>]*data-number="([^"]+)"[^>]*>(.*?)<\/lesson-task>/gs;
const FIRST_SECTION = /^(?:## |<!-- include )/m;

/** The text of a chapter before its first section, with its front matter. @param {string} text */
export const introductionOf = (text) => text.slice(0, FIRST_SECTION.exec(text)?.index);

/** @param {string} html */
const plain = (html) =>
  html
    .replace(/<[^>]*>/g, "")
    .replaceAll("&amp;", "&")
    .trim();

/** The first sentences of a text. @param {string} html */
function descriptionOf(html) {
  const text = plain(/<p>(.*?)<\/p>/s.exec(html)?.[1].replace(/<math\b.*?<\/math>/gs, mathText) ?? "");
  return /^.{60,}?\.(?= |$)|^.*/.exec(text.replace(/\s+/g, " ").replaceAll('"', "&quot;"))?.[0] ?? "";
}

/** @param {string} text @param {string} name */
const field = (text, name) => new RegExp(`^${name}: "?(.*?)"?$`, "m").exec(text)?.[1] ?? "";

/** @param {RegExp} pattern @param {string} text */
const all = (pattern, text) => Array.from(text.matchAll(pattern), ([, found]) => found);

/**
 * The links of a section, whose page is one folder deeper than its chapter.
 *
 * @param {string} html
 * @param {string} path of the chapter
 * @param {readonly string[]} ids of the section
 */
const linksOf = (html, path, ids) =>
  html.replace(/(\s(?:href|src)=")([^"]*)"/g, (whole, start, address) => {
    if (/^[a-z]+:/.test(address)) return whole;
    if (!address.startsWith("#")) return `${start}../${address}"`;
    return ids.includes(address.slice(1).split("?")[0]) ? whole : `${start}../../${path}${address}"`;
  });

/** The headings of a page of its own are one level higher. @param {string} html */
const raised = (html) => html.replace(/<(\/?)h([23])\b/g, (_, slash, level) => `<${slash}h${level - 1}`);

/**
 * @param {import("markdown-it").default} md
 * @returns {Chapter[]}
 */
export const readChapters = (md) => PATHS.map((path, chapter) => readChapter(md, path, chapter));

/**
 * @param {import("markdown-it").default} md
 * @param {string} path
 * @param {number} chapter
 * @returns {Chapter}
 */
function readChapter(md, path, chapter) {
  const inputPath = `${www}${path}index.md`;
  const text = includeFiles({ page: { inputPath } }, readFileSync(inputPath, "utf8"));
  const html = md.render(text.slice(FIRST_SECTION.exec(text)?.index), { chapter: chapter + 1 });
  const sections = html
    .split(/(?=^<section id=)/m)
    .filter((part) => part.startsWith("<section"))
    .map((part, index) => sectionOf(part, path, chapter, index));
  return { path, heading: field(text, "heading"), html, tasks: sections.flatMap(({ tasks }) => tasks), sections };
}

/**
 * @param {string} html
 * @param {string} path of the chapter
 * @param {number} chapter
 * @param {number} index
 * @returns {Section}
 */
function sectionOf(html, path, chapter, index) {
  const id = /id="([^"]+)"/.exec(html)?.[1] ?? "";
  const title = /<h2[^>]*>(.*?) <a class="permalink"/s.exec(html)?.[1] ?? "";
  const [, number = "", words = title] = /^<span class="nr">([\d.]+)<\/span>\s*(.*)$/s.exec(title) ?? [];
  const content = html.replace(/^<section [^>]*>|<\/section>\s*$/g, "");
  const ids = [id, ...all(/\sid="([^"]+)"/g, content)];
  const questions = Array.from(content.matchAll(TASK), ([, name, number, html]) => ({
    name,
    number,
    html: linksOf(html, path, []),
  }));
  return {
    id,
    url: `/${path}${id}/`,
    chapter,
    index,
    number,
    title: words,
    name: plain(words),
    description: descriptionOf(content),
    html: raised(linksOf(content, path, ids)).replace("<h1", `<h1 id="${id}"`),
    ids,
    tasks: questions.map(({ name }) => name),
    questions,
    parts: Array.from(content.matchAll(/<h3 id="([^"]+)"[^>]*>(.*?) <a class="permalink"/gs), ([, id, title]) => ({
      id,
      title,
    })),
  };
}

/**
 * Links to a place of a chapter, such as `../curves/#figure-hull`, lead to the page of its section.
 *
 * @param {readonly Chapter[]} chapters
 * @returns {(html: string) => string}
 */
export function chapterLinks(chapters) {
  const pages = new Map(
    chapters.flatMap(({ path, sections }) =>
      sections.flatMap(({ id, ids }) => ids.map((each) => [path + each, `${path}${id}/`])),
    ),
  );
  return (html) =>
    html.replace(/(\shref="(?:\.\.\/)*)(curves\/|surfaces\/)#([^"?]+)(\??[^"]*")/g, (whole, start, path, id, end) => {
      const page = pages.get(path + id);
      if (!page) return whole;
      return page === `${path}${id}/` && end === '"' ? `${start}${page}"` : `${start}${page}#${id}${end}`;
    });
}
