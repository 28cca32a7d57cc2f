// The texts that people read. Each is written in English where it is used, which is also its key; a page can give another
// one in its place. `xtask/texts.js` lists them all in dist/texts.json.

/** A property of the global object, so that several bundles on a page have the same texts. */
const SHARED = Symbol.for("casteljau.translations");

const owner = globalThis as { [SHARED]?: { texts: Record<string, string>; changes: EventTarget } };
owner[SHARED] ??= { texts: {}, changes: new EventTarget() };
const shared = owner[SHARED];

/** Fires `change` when the page has given other texts. */
export const translations = shared.changes;

/**
 * A text in the language of the page.
 *
 * @param english a literal, so that a test can find it
 * @param values take the places of {0}, {1} …
 */
export function translated(english: string, ...values: unknown[]): string {
  return textOf(english).replace(/\{(\d)\}/g, (place, k) => (k in values ? String(values[k]) : place));
}

/**
 * A text whose values are not only texts, as a list for a template.
 *
 * @param english as in `translated`
 */
export function translatedParts(english: string, ...values: unknown[]): unknown[] {
  return textOf(english)
    .split(/(\{\d\})/)
    .map((part) => (/^\{\d\}$/.test(part) ? values[Number(part[1])] : part));
}

/**
 * Texts by their keys, each looked up when it is read.
 *
 * @param english literals
 */
export function translatedTable<T extends Record<string, string>>(english: T): T {
  const table = {} as T;
  for (const key of Object.keys(english))
    Object.defineProperty(table, key, { enumerable: true, get: () => textOf(english[key]) });
  return table;
}

const textOf = (english: string) => shared.texts[english] ?? english;

/**
 * Gives the texts of the elements and the applet in another language. Elements on the page are drawn again; `bezierApp`
 * takes the texts when it is called. Texts that are not given stay English, as do messages about wrong attributes and
 * files.
 *
 * @param texts the keys are the English texts, which `casteljau/texts.json` lists; {0}, {1} … stand for names and numbers.
 *   A later call replaces all texts of an earlier one.
 * @throws {TypeError} if `texts` is not an object whose values are strings
 */
export function setTranslations(texts: Record<string, string>) {
  const isTable = typeof texts === "object" && texts !== null;
  const wrong = isTable ? Object.entries(texts).find(([, text]) => typeof text !== "string") : ["texts", texts];
  if (wrong) {
    const [name, value] = wrong;
    throw new TypeError(`${name}: expected ${isTable ? "a string" : "an object of strings"}, got ${String(value)}`);
  }
  shared.texts = { ...texts };
  translations.dispatchEvent(new Event("change"));
}
