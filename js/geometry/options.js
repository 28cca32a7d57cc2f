// Checks of options and of the number of arguments: what would be ignored silently is a TypeError.
import { describe, shorten } from "./describe.js";

/**
 * Checks an argument that holds options: an object with known names only, undefined or null. Options with the value
 * undefined count as absent.
 *
 * @template {object} T
 * @param {T | undefined} value
 * @param {readonly (T extends unknown ? keyof T : never)[]} known the names of the options
 * @returns {Partial<T>}
 * @throws {TypeError} for another name, with the nearest known one
 */
export function options(value, known) {
  if (value === undefined || value === null) return {};
  if (typeof value !== "object" || Array.isArray(value) || ArrayBuffer.isView(value)) {
    throw new TypeError(`options: expected an object, got ${describe(value)}${optionForNumber(value, known)}`);
  }
  const { casteljauType } = /** @type {{ casteljauType?: unknown }} */ (value);
  if (casteljauType) {
    const hint = casteljauType === "path" ? "; did you mean Path.combine?" : "";
    throw new TypeError(`options: expected an object, got ${describe(value)}${hint}`);
  }
  const names = /** @type {readonly string[]} */ (known);
  for (const key of Object.keys(value)) {
    if (names.includes(key) || /** @type {Record<string, unknown>} */ (value)[key] === undefined) continue;
    throw new TypeError(`${shorten(key)}: unknown option; ${suggestion(shorten(key), names)}`);
  }
  return value;
}

/**
 * The option that a number in the place of the options was probably meant for, as the end of a message.
 *
 * @param {unknown} value
 * @param {readonly PropertyKey[]} known
 * @returns {string}
 */
function optionForNumber(value, known) {
  const names = Number.isInteger(value) ? ["segments", "precision", "tolerance"] : ["tolerance"];
  const name = names.find((option) => known.includes(option));
  return typeof value === "number" && name ? `; did you mean { ${name}: ${value} }?` : "";
}

/**
 * Refuses arguments after the last parameter, which JavaScript ignores. Only methods call it for which such an argument
 * has a plausible meaning (`split(0.2, 0.6)`); all others can be passed to `map`, which passes three arguments.
 *
 * @param {readonly unknown[]} surplus the arguments after the last parameter; undefined counts as absent
 * @param {string} method
 * @param {number} expected the number of parameters
 * @param {string} [instead] the call that was probably intended
 */
export function noSurplus(surplus, method, expected, instead) {
  if (surplus.every((value) => value === undefined)) return;
  const count = `${expected || "no"} argument${expected === 1 ? "" : "s"}`;
  const hint = instead ? `; did you mean ${instead}?` : "";
  throw new TypeError(`${method}: expected ${count}, got ${expected + surplus.length}${hint}`);
}

/**
 * An option that is true or false.
 *
 * @param {unknown} value
 * @param {string} name
 * @param {boolean} [byDefault]
 * @returns {boolean}
 */
export function optionalBoolean(value, name, byDefault = false) {
  if (value === undefined) return byDefault;
  if (typeof value !== "boolean") throw new TypeError(`${name}: expected true or false, got ${describe(value)}`);
  return value;
}

/**
 * @param {string} key
 * @param {readonly string[]} known
 * @returns {string}
 */
function suggestion(key, known) {
  const wanted = key.toLowerCase();
  const lower = known.map((name) => name.toLowerCase());
  const isPart = (/** @type {string} */ name) => wanted.startsWith(name) || wanted.endsWith(name);
  let nearest = lower.findIndex((name) => name.startsWith(wanted) || isPart(name));
  if (nearest < 0) {
    const distances = lower.map((name) => editDistance(wanted, name));
    const smallest = Math.min(...distances);
    if (smallest <= key.length / 3) nearest = distances.indexOf(smallest);
  }
  return nearest < 0 ? `expected ${known.join(", ")}` : `did you mean ${known[nearest]}?`;
}

/**
 * The Levenshtein distance: how many letters have to be inserted, removed or replaced.
 *
 * @param {string} a
 * @param {string} b
 * @returns {number}
 */
function editDistance(a, b) {
  let row = Array.from({ length: b.length + 1 }, (_, k) => k);
  for (const letter of a) {
    const next = [row[0] + 1];
    for (let k = 0; k < b.length; k++) {
      next.push(Math.min(next[k] + 1, row[k + 1] + 1, row[k] + (letter === b[k] ? 0 : 1)));
    }
    row = next;
  }
  return row[b.length];
}
