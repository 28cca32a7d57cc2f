// From the tables of attributes to the controls of the playground.

/**
 * @typedef {{ kind: "flag" | "link" | "text" }
 *   | { kind: "number", min?: number, max?: number, step: number, initial?: number }
 *   | { kind: "choice" | "words", options: string[] }} Control
 */

const NUMBER = String.raw`-?\d+(?:\.\d+)?`;
const RANGE = new RegExp(`^(${NUMBER}) … (${NUMBER})(?:, (${NUMBER}))?$`);
const WORDS = /^(?:words: |layers: |groups of the control panel: )([a-z0-9 ]+)/;
const CHOICE = /^[\w-]+(?:, [\w-]+)+$/;

/**
 * The control of an attribute.
 *
 * @param {string} name
 * @param {string} value the column “Value, default” of the table: "0 … 1, 0.5", "smooth, flat", "words: free g1", "boolean"
 * @param {string} meaning the last column, which lists the words of `show` and `controls`
 * @returns {Control}
 */
export function controlOf(name, value, meaning) {
  if (name === "for") return { kind: "link" };
  if (value === "boolean") return { kind: "flag" };
  const words = WORDS.exec(value) ?? WORDS.exec(meaning);
  if (words) return { kind: "words", options: words[1].trim().split(" ") };
  const range = RANGE.exec(value);
  if (range) {
    const [min, max] = [Number(range[1]), Number(range[2])];
    return { kind: "number", min, max, step: max > 1 ? 1 : 0.01, ...(range[3] && { initial: Number(range[3]) }) };
  }
  if (/^\d+(?:\.\d+)?$/.test(value)) return { kind: "number", min: 0, step: 0.5, initial: Number(value) };
  if (CHOICE.test(value)) return { kind: "choice", options: value.split(", ") };
  return { kind: "text" };
}

/** The attributes that are shown first; the others are behind “More”. @type {Record<string, string[]>} */
export const FIRST = {
  "bezier-applet": ["show", "joints", "basis", "degree", "t", "controls"],
  "bezier-surface": ["model", "show", "shading", "segments", "u", "v", "controls"],
};

/** Longer tags have an attribute on each line. */
const MAX_LINE = 64;

/**
 * A tag as code: on one line if it is short, otherwise an attribute on each line.
 *
 * @param {string} tag
 * @param {readonly (readonly [string, string])[]} attributes
 */
export function tagText(tag, attributes) {
  const texts = attributes.map(([name, value]) =>
    value === "" ? name : `${name}="${value.replaceAll("&", "&amp;").replaceAll('"', "&quot;")}"`,
  );
  const line = `<${[tag, ...texts].join(" ")}></${tag}>`;
  return line.length <= MAX_LINE ? line : `<${[tag, ...texts].join("\n  ")}\n></${tag}>`;
}
