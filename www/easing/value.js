// Timing functions as text, the way CSS has them.
import { easing } from "casteljau";

/** The words of CSS, and curves that are often asked for. @type {readonly (readonly [string, readonly number[]])[]} */
export const PRESETS = [
  ["linear", [0, 0, 1, 1]],
  ["ease", [0.25, 0.1, 0.25, 1]],
  ["ease-in", [0.42, 0, 1, 1]],
  ["ease-out", [0, 0, 0.58, 1]],
  ["ease-in-out", [0.42, 0, 0.58, 1]],
  ["gentle stop", [0.16, 1, 0.3, 1]],
  ["overshoot", [0.34, 1.56, 0.64, 1]],
  ["wind up", [0.36, 0, 0.66, -0.56]],
];
/** Those that CSS knows by name. */
const NAMES = new Set(["linear", "ease", "ease-in", "ease-out", "ease-in-out"]);
const CURVE = /^cubic-bezier\(\s*([^,]+),([^,]+),([^,]+),([^,)]+)\)$/i;
/** An address holds short numbers. */
const DIGITS = 4;

/**
 * The four numbers of a timing function.
 *
 * @param {string} text `cubic-bezier(…)`, a word of CSS, or four numbers
 * @returns {number[]}
 * @throws {RangeError} with the reason
 */
export function parse(text) {
  const trimmed = text
    .trim()
    .replace(/^[\w-]+\s*:\s*/, "")
    .replace(/;$/, "")
    .trim();
  const named = PRESETS.find(([name]) => NAMES.has(name) && name === trimmed.toLowerCase());
  if (named) return [...named[1]];
  const parts = trimmed.match(CURVE)?.slice(1) ?? trimmed.split(/[\s,]+/);
  const numbers = parts.map((part) => (part.trim() === "" ? NaN : Number(part)));
  if (numbers.length !== 4 || !numbers.every(Number.isFinite)) {
    throw new RangeError(`expected cubic-bezier(x1, y1, x2, y2) or a word such as ease, got “${trimmed.slice(0, 60)}”`);
  }
  easing(.../** @type {[number, number, number, number]} */ (numbers)); // refuses x outside of 0 to 1
  return numbers;
}

/** @param {readonly number[]} value */
export const rounded = (value) => value.map((number) => Number(number.toFixed(DIGITS)));

/** @param {readonly number[]} value */
export const css = (value) => `cubic-bezier(${rounded(value).join(", ")})`;

/** @param {readonly number[]} a @param {readonly number[]} b */
export const same = (a, b) => css(a) === css(b);
