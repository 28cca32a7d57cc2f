// What the search knows: every page, every section of a chapter and every entry of the API reference.
import { mathText } from "./math-text.js";
import { ABSENT, TERMS } from "./search-terms.js";

/**
 * @typedef {{ id: number, address: string, title: string, page: string, text: string, peers: string, terms: string }} SearchDocument
 *   address: relative to the first page; peers: what other libraries call an entry; terms: other words for it, with commas between
 */

/** How much text of a section is searched. */
const MAX_TEXT = 900;

/**
 * @param {{ url: string, content: string }[]} pages
 * @returns {SearchDocument[]}
 */
export function searchDocuments(pages) {
  const documents = pages
    .filter(({ content }) => content.includes("data-search="))
    .flatMap(({ url, content }) => documentsOf(url.slice(1), content.slice(content.indexOf('id="main"'))));
  const absent = ABSENT.map((answer) => ({ ...answer, page: answer.title, peers: "" }));
  return [...documents.map((document) => ({ ...document, terms: TERMS[document.address] ?? "" })), ...absent].map(
    (document, id) => ({ id, ...document }),
  );
}

/** @param {string} address @param {string} html */
function documentsOf(address, html) {
  const page = plain(/<h1[^>]*>(.*?)<\/h1>/s.exec(html)?.[1] ?? "");
  const lead = plain(/<p class="lead">(.*?)<\/p>/s.exec(html)?.[1] ?? "");
  if (html.startsWith('id="main" class="section"')) {
    const [heading, ...text] = html.replace(/<nav class="next".*/s, "").split("</h1>");
    const title = plain(heading.replace(/<a class="permalink".*/s, "").slice(heading.indexOf("<h1")));
    return [{ address, title, page: title, text: plain(text.join("")).slice(0, MAX_TEXT), peers: "" }];
  }
  const [, ...parts] = html.split(/(?=<section [^>]*\bid=")/);
  return [
    { address, title: page, page, text: lead, peers: "" },
    ...parts.map((part) => sectionOf(address, page, part)),
  ];
}

/** @param {string} address @param {string} page @param {string} html */
function sectionOf(address, page, html) {
  const id = /\bid="([^"]+)"/.exec(html)?.[1] ?? "";
  const heading = plain(
    (/<h2[^>]*>(.*?)<\/h2>/s.exec(html)?.[1] ?? "").replace(/<small>.*|<a class="permalink".*/s, ""),
  );
  const isEntry = /^<section [^>]*class="entry"/.test(html);
  const title = isEntry && /^[A-Z]\w+$/.test(page) && !heading.startsWith("new ") ? `${page}.${heading}` : heading;
  const [text, rest = ""] = html.slice(html.indexOf("</h2>")).split("<dt>Peers</dt>");
  const peers = isEntry ? plain(rest.slice(0, rest.indexOf("</dd>"))) : "";
  return { address: `${address}#${id}`, title, page, text: plain(text).slice(0, MAX_TEXT), peers };
}

/** The text of HTML, without displayed formulas, code blocks and pictures. @param {string} html */
const plain = (html) =>
  html
    .replace(/<math display="block".*?<\/math>/gs, " ")
    .replace(/<math\b.*?<\/math>/gs, mathText)
    .replace(/<(svg|pre|style|script|table)\b.*?<\/\1>/gs, " ")
    .replace(/<\/?(a|b|code|em|i|kbd|span|strong|sub|sup)\b[^>]*>/g, "")
    .replace(/<[^>]*>/g, " ")
    .replace(/&lt;/g, "<")
    .replace(/&gt;/g, ">")
    .replace(/&quot;/g, '"')
    .replace(/&amp;/g, "&")
    .replace(/\s+/g, " ")
    .trim();
