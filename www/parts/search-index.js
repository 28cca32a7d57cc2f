// The index of the search: words of titles, texts and of what peers call an entry.
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
 * A function that finds the best sections for a text as it is typed.
 *
 * @param {SearchDocument[]} documents
 * @returns {(text: string) => Found[]}
 */
export function searchIndex(documents) {
  const index = new MiniSearch({
    fields: ["title", "page", "text", "peers"],
    storeFields: ["address", "title", "page", "text", "peers"],
    tokenize: words,
    processTerm: normalized,
  });
  index.addAll(documents);
  return (text) => {
    const phrase = normalized(text.trim());
    const options = {
      boost: { title: 5, peers: 2 },
      weights: { fuzzy: 0.1, prefix: 0.4 },
      prefix: true,
      fuzzy: (/** @type {string} */ term) => (term.length > 5 ? 2 : term.length > 3),
      // A section that has the words in this order is more likely to be meant.
      boostDocument: (
        /** @type {number} */ _id,
        /** @type {string} */ _term,
        /** @type {any} */ { title, text, peers },
      ) => (normalized(`${title} ${text} ${peers}`).includes(phrase) ? 3 : 1),
    };
    const all = index.search(text, { ...options, combineWith: "AND" });
    const found = all.length > 0 ? all : index.search(text, options);
    return /** @type {any} */ (found.slice(0, MAX_RESULTS));
  };
}
