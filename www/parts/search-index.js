// The index of the search: words of titles, texts, of what peers call an entry, and of other words for it.
import MiniSearch from "minisearch";

/** @typedef {import("../build/search-documents.js").SearchDocument} SearchDocument */
/** @typedef {Pick<SearchDocument, "address" | "title" | "page" | "text">} Found */

const MAX_RESULTS = 12;

/** Lower case without accents. @param {string} word */
const normalized = (word) =>
  word
    .normalize("NFD")
    .replace(/[\u0300-\u036f]/g, "")
    .toLowerCase();

/** `timesAtCoordinate` is also found by its parts. @param {string} text */
function words(text) {
  const whole = text.split(/[^\p{L}\p{N}]+/u).filter(Boolean);
  return whole.flatMap((word) => {
    const parts = word.split(/(?<=[a-z])(?=[A-Z])/);
    return parts.length > 1 ? [word, ...parts] : [word];
  });
}

/**
 * The weight of a section: what is named by the whole text comes first, of that the chapters, which explain the term; then what has the words in
 * this order.
 *
 * @param {SearchDocument} document
 * @param {string} phrase
 */
function weightOf({ address, title, text, peers, terms }, phrase) {
  if (terms.split(", ").some((term) => normalized(term) === phrase)) return CHAPTER.test(address) ? 60 : 20;
  if (CHAPTER.test(address) && normalized(title).includes(phrase)) return 10;
  return normalized(`${title} ${text} ${peers}`).includes(phrase) ? 3 : 1;
}

const CHAPTER = /^(curves|surfaces)\/./;

/**
 * A function that finds the best sections for a text as it is typed.
 *
 * @param {SearchDocument[]} documents
 * @returns {(text: string) => Found[]}
 */
export function searchIndex(documents) {
  const index = new MiniSearch({
    fields: ["title", "page", "text", "peers", "terms"],
    storeFields: ["address", "title", "page", "text", "peers", "terms"],
    tokenize: words,
    processTerm: normalized,
  });
  index.addAll(documents);
  return (text) => {
    const phrase = normalized(text.trim());
    const options = {
      boost: { title: 5, peers: 2, terms: 4 },
      weights: { fuzzy: 0.1, prefix: 0.4 },
      prefix: true,
      fuzzy: (/** @type {string} */ term) => (term.length > 5 ? 2 : term.length > 3),
      boostDocument: (/** @type {number} */ _id, /** @type {string} */ _term, /** @type {any} */ document) =>
        weightOf(document, phrase),
    };
    const all = index.search(text, { ...options, combineWith: "AND" });
    const found = all.length > 0 ? all : index.search(text, options);
    return /** @type {any} */ (found.slice(0, MAX_RESULTS));
  };
}
