// What the answers of all libraries have in common.

/**
 * What a library answers for a kind of fact, in the form in which the fact states it. A kind without a function is not offered. A function
 * returns undefined for an input that the library does not claim to take.
 *
 * @typedef {Record<string, (input: any, fact: import("./facts.js").Fact) => unknown>} Answers
 */

/** A point as a list. @param {{ x: number, y: number, z?: number }} point @returns {number[]} */
export const tuple = ({ x, y, z }) => (z === undefined ? [x, y] : [x, y, z]);

/** Points of the plane from a flat list. @param {ArrayLike<number>} flat @returns {number[][]} */
export const pairsOf = (flat) => Array.from({ length: flat.length / 2 }, (_, k) => [flat[2 * k], flat[2 * k + 1]]);

/** Longer texts are cut. */
const MAX_TEXT = 90;
/** A list with more points is counted. */
const MAX_POINTS = 10;

/** @param {number} x */
const numberText = (x) => String(Number(x.toPrecision(12))).replaceAll("-", "−");

/** @param {any} value @returns {string} */
function valueText(value) {
  if (typeof value === "number") return numberText(value);
  if (typeof value !== "object" || value === null) return String(value);
  if (!Array.isArray(value))
    return Object.entries(value)
      .map(([key, each]) => `${key}: ${valueText(each)}`)
      .join("; ");
  if (value.length === 0) return "none";
  if (value.length > MAX_POINTS && Array.isArray(value[0])) return `${value.length} points`;
  return value.map((each) => (Array.isArray(each) ? `(${valueText(each)})` : valueText(each))).join(", ");
}

/** An answer for people. @param {unknown} value @param {number} [max] */
export function textOf(value, max = MAX_TEXT) {
  const text = valueText(value);
  return text.length > max ? `${text.slice(0, max - 1)}…` : text;
}

/** A small number in words: 3e−9. @param {number} x */
export const shortNumber = (x) => String(Number(x.toPrecision(2))).replaceAll("-", "−");
