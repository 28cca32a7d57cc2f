// /api/curve/ and so on: a page for each class, and the pages of elements and types.
import { elementsHtml, inline, pageHtml, typeAddresses, typesHtml } from "./build/render.js";
import { reference } from "./build/reference.js";

const model = reference();
const addresses = typeAddresses(model);

const ELEMENTS_LEAD =
  'Custom elements that show curves and surfaces on any page: <code>import "casteljau/elements"</code>. The page <a href="../../elements/">Elements</a> shows them at work.';
const TYPES_LEAD =
  'The types of arguments, options and results, as TypeScript sees them: <code>import type { Nearest } from "casteljau"</code>.';

const items = [
  ...model.pages.map((page) => ({
    slug: page.slug,
    heading: page.title,
    lead: inline(page.summary),
    content: () => pageHtml(page, addresses),
  })),
  { slug: "elements", heading: "Elements", lead: ELEMENTS_LEAD, content: () => elementsHtml(model.elements) },
  { slug: "types", heading: "Types and options", lead: TYPES_LEAD, content: () => typesHtml(model.types, addresses) },
];

/** @typedef {{ item: typeof items[number] }} Data */

export const data = {
  items,
  pagination: { data: "items", size: 1, alias: "item" },
  permalink: (/** @type {Data} */ { item }) => `/api/${item.slug}/index.html`,
  styles: ["../api.css"],
  script: "../main.js",
  eleventyComputed: {
    title: (/** @type {Data} */ { item }) => `${item.heading}: API reference · casteljau`,
    description: (/** @type {Data} */ { item }) => item.lead.replace(/<[^>]*>/g, ""),
    heading: (/** @type {Data} */ { item }) => item.heading,
    lead: (/** @type {Data} */ { item }) => item.lead,
  },
};

/** @param {Data} data */
export const render = ({ item }) => item.content();
