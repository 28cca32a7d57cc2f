// The pages of the reference as HTML.
import markdownIt from "markdown-it";
import { escapeHtml } from "../../build/highlight.js";
import { codeHtml, linkedType, rustHtml, sampleHtml } from "./code.js";
import { SECTIONS } from "./entries.js";
import { figureHtml } from "./figure.js";
import { counterpart, rustAddress } from "./rustdoc.js";

/**
 * @import { Field, Parameter, Signature, TypeDoc } from "./extract.js"
 * @import { Item, Page, Reference } from "./reference.js"
 * @import { Entry } from "./entries.js"
 */

const md = markdownIt();

/** Declared by casteljau, but of no interest apart from its class: what a page of the reference calls it. */
const ALIASES = new Map([
  ["CoreCurve", "curve/"],
  ["CurveValue", "curve/"],
  ["CoreSpline", "spline/"],
  ["SplineValue", "spline/"],
  ["PathValue", "path/"],
  ["PatchValue", "patch/"],
]);

/**
 * Where each name of a type is explained, seen from a page of the reference.
 *
 * @param {Reference} reference
 */
export function typeAddresses({ pages, types }) {
  const addresses = new Map(Array.from(ALIASES, ([name, address]) => [name, `../${address}`]));
  for (const { name } of types) addresses.set(name, `../types/#${name}`);
  for (const { slug, title } of pages) if (/^[A-Z]\w+$/.test(title)) addresses.set(title, `../${slug}/`);
  return addresses;
}

/** @param {string} text one paragraph of Markdown */
export const inline = (text) => md.renderInline(text);

/** @param {string[]} parts */
const paragraphsHtml = (parts) =>
  parts.map((part) => (/^ {4}/.test(part) ? codeHtml(unindented(part), "js") : md.render(part))).join("");

/** @param {string} text */
const unindented = (text) => text.replace(/^ {4}/gm, "").trimEnd();

/**
 * The page of a class.
 *
 * @param {Page} page
 * @param {Map<string, string>} addresses
 */
export async function pageHtml(page, addresses) {
  const items = [];
  for (const item of page.items) items.push(await itemHtml(page, item, addresses));
  const list = page.items.map(({ id, name }) => `<li><a href="#${id}"><code>${escapeHtml(name)}</code></a></li>`);
  return `${paragraphsHtml(page.details)}
${filterHtml(page.items.length)}
<nav class="names" aria-label="Entries of this page"><ul>${list.join("")}</ul></nav>
${items.join("\n")}`;
}

/** @param {Page} page @param {Item} item @param {Map<string, string>} addresses */
async function itemHtml(page, item, addresses) {
  const { entry } = item;
  const signatures = item.signatures.map(
    ({ text }) => `<pre class="signature" tabindex="0"><code>${linkedType(text, addresses)}</code></pre>`,
  );
  return `<section id="${item.id}" class="entry" data-name="${escapeHtml(`${page.title} ${item.name}`)}" aria-labelledby="${item.id}-name">
<h2 id="${item.id}-name"><code>${escapeHtml(item.name)}</code> <small>${item.kind}</small></h2>
<p>${inline(item.summary)}</p>
${signatures.join("")}
${item.signatures.map((signature) => signatureHtml(signature, addresses)).join("")}
${entry?.js ? await sampleWithFigure(page, item, entry) : ""}
${entry ? sectionsHtml(entry) : ""}
${item.details.length > 0 && !entry?.sections.has("Guarantee") ? `<h3>Notes</h3>${paragraphsHtml(item.details)}` : ""}
${throwsHtml(item)}
</section>`;
}

/** Parameters and result. @param {Signature} signature @param {Map<string, string>} addresses */
function signatureHtml({ parameters, result }, addresses) {
  const rows = parameters.flatMap((parameter) => parameterRows(parameter, addresses));
  const returned =
    result && result.type !== "void"
      ? `<tr><th scope="row">result</th><td><code>${linkedType(result.type, addresses)}</code></td><td>${inline(result.doc)}</td></tr>`
      : "";
  if (rows.length === 0 && !returned) return "";
  return `<div class="scroll"><table class="parameters"><tbody>${rows.join("")}${returned}</tbody></table></div>`;
}

/** @param {Parameter} parameter @param {Map<string, string>} addresses */
function parameterRows({ name, type, optional, doc, fields }, addresses) {
  const row = (/** @type {Field} */ field, /** @type {string} */ title) =>
    `<tr><th scope="row"><code>${escapeHtml(title)}</code></th><td><code>${linkedType(field.type, addresses)}</code></td><td>${inline(field.doc)}</td></tr>`;
  const shown = name.startsWith("{") ? "fields" : name + (optional ? "?" : "");
  return [
    ...(fields.length === 0 || doc ? [row({ name, type: fields.length === 0 ? type : "object", doc }, shown)] : []),
    ...fields.map((field) => row(field, name.startsWith("{") ? field.name : `${name}.${field.name}`)),
  ];
}

/** @param {Page} page @param {Item} item @param {Entry} entry */
async function sampleWithFigure(page, item, entry) {
  const figure = entry.draw ? await figureHtml(page.slug, item.id, entry) : "";
  const link = entry.rust ? rustLink(counterpart(page.title, item.id, entry.rust.info)) : "";
  const rust = entry.rust
    ? `<details class="rust"><summary>In Rust</summary>${link}${rustHtml(entry.rust.code)}</details>`
    : "";
  return `<div class="sample">${figure}${sampleHtml(entry.js?.code ?? "")}${rust}</div>`;
}

/** @param {string} symbol */
const rustLink = (symbol) =>
  `<p><a href="../../rust/${rustAddress(symbol)}"><code>${escapeHtml(symbol)}</code> in the Rust documentation</a></p>`;

/** @param {Entry} entry */
function sectionsHtml({ sections }) {
  const shown = SECTIONS.filter((name) => sections.has(name)).map((name) => {
    const { text, blocks } = /** @type {import("./entries.js").Section} */ (sections.get(name));
    const code = blocks.map((block) => codeHtml(block.code, "js")).join("");
    return `<dt>${name}</dt><dd>${md.render(text)}${code}</dd>`;
  });
  return shown.length > 0 ? `<dl class="properties">${shown.join("")}</dl>` : "";
}

/** @param {Item} item */
function throwsHtml({ signatures, entry }) {
  if (entry?.sections.has("Errors")) return "";
  const throws = [...new Set(signatures.flatMap((signature) => signature.throws))];
  return throws.length === 0
    ? ""
    : `<h3>Errors</h3><ul>${throws.map((text) => `<li>${inline(text.replace(/^(\w+)/, "`$1`"))}</li>`).join("")}</ul>`;
}

/** @param {TypeDoc[]} types @param {Map<string, string>} addresses */
export function typesHtml(types, addresses) {
  const sorted = types.toSorted((a, b) => a.name.localeCompare(b.name));
  const list = sorted.map(({ name }) => `<li><a href="#${name}"><code>${name}</code></a></li>`);
  const entries = sorted.map((type) => {
    const rows = type.fields.flatMap((field) => parameterRows({ ...field, optional: false, fields: [] }, addresses));
    const table =
      rows.length > 0
        ? `<div class="scroll"><table class="parameters"><tbody>${rows.join("")}</tbody></table></div>`
        : "";
    return `<section id="${type.name}" class="entry" data-name="${type.name}"><h2><code>${type.name}</code> <small>type</small></h2><p>${inline(type.summary)}</p>
<pre class="signature" tabindex="0"><code>${linkedType(type.text, addresses)}</code></pre>${table}${paragraphsHtml(type.details)}</section>`;
  });
  return `${filterHtml(sorted.length)}
<nav class="names" aria-label="Entries of this page"><ul>${list.join("")}</ul></nav>
${entries.join("\n")}`;
}

/** @param {Reference["elements"]} elements */
export function elementsHtml(elements) {
  const list = elements.map(({ tag }) => `<li><a href="#${tag}"><code>&lt;${tag}&gt;</code></a></li>`);
  const entries = elements.map(({ tag, summary, tables }) => {
    const shown = tables.map(({ title, rows }) => {
      const lines = rows.map(
        ({ name, type, doc, id }) =>
          `<tr id="${id}"><th scope="row"><code>${escapeHtml(name)}</code></th><td>${type ? `<code>${escapeHtml(type)}</code>` : ""}</td><td>${inline(doc)}</td></tr>`,
      );
      return `<h3>${title}</h3><div class="scroll"><table class="parameters"><tbody>${lines.join("")}</tbody></table></div>`;
    });
    return `<section id="${tag}" class="entry"><h2><code>&lt;${tag}&gt;</code> <small>element</small></h2><p>${inline(summary)}</p>${shown.join("")}</section>`;
  });
  return `<nav class="names" aria-label="Entries of this page"><ul>${list.join("")}</ul></nav>
${entries.join("\n")}`;
}

/** The field that filters the entries of a page by name (www/api/filter.js). @param {number} count of all entries */
const filterHtml = (count) =>
  `<search class="filter"><label for="filter">Filter</label><input id="filter" type="search" autocomplete="off" spellcheck="false" placeholder="nearest" disabled><span role="status">${count} entries</span></search>`;

/** The first sentence of a summary, which may be a phrase. @param {string} summary */
function firstSentence(summary) {
  const [sentence] = /^.*?[.:](?=\s+[A-Z`]|$)/s.exec(summary) ?? [summary && `${summary}.`];
  return sentence.charAt(0).toUpperCase() + sentence.slice(1);
}

/** The list of all names, each with its first sentence. @param {Reference} reference */
export function indexHtml({ pages, types, elements }) {
  /** @typedef {{ id: string, name: string, summary: string }} Listed */
  const group = (
    /** @type {string} */ slug,
    /** @type {string} */ title,
    /** @type {string} */ summary,
    /** @type {Listed[]} */ list,
  ) => {
    const rows = list.map(
      (item) =>
        `<tr data-name="${escapeHtml(`${title} ${item.name}`)}"><th scope="row"><a href="${slug}/#${item.id}"><code>${escapeHtml(item.name)}</code></a></th><td>${inline(firstSentence(item.summary))}</td></tr>`,
    );
    return `<section id="${slug}"><h2><a href="${slug}/">${escapeHtml(title)}</a></h2><p>${inline(summary)}</p><table class="entries" aria-label="${escapeHtml(title)}"><tbody>
${rows.join("\n")}
</tbody></table></section>`;
  };
  const count = pages.reduce((sum, { items }) => sum + items.length, elements.length + types.length);
  return `${filterHtml(count)}
${pages.map((page) => group(page.slug, page.title, page.summary, page.items)).join("\n")}
${group(
  "elements",
  "Elements",
  "Custom elements for any page.",
  elements.map(({ tag, summary }) => ({ id: tag, name: `<${tag}>`, summary })),
)}
${group(
  "types",
  "Types and options",
  "The types of arguments, options and results.",
  types.map(({ name, summary }) => ({ id: name, name, summary })),
)}
<p class="rust-docs"><a href="../rust/casteljau/index.html">Documentation of the Rust crate</a></p>`;
}
