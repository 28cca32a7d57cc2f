// Checks of options: an unknown one, which would be ignored silently, is a TypeError.
import { describe, shorten } from "./describe.js";

/**
 * Checks an argument that holds options: an object with known names only, undefined or null. Options with the value
 * undefined count as absent.
 *
 * @param known the names of the options
 * @throws {TypeError} for another name, with the nearest known one
 */
export function options<T extends object>(
  value: T | undefined,
  known: readonly (T extends unknown ? keyof T : never)[],
): Partial<T> {
  if (value === undefined || value === null) return {};
  if (typeof value !== "object" || Array.isArray(value) || ArrayBuffer.isView(value)) {
    throw new TypeError(`options: expected an object, got ${describe(value)}${hintForOption(value, known)}`);
  }
  const { casteljauType } = value as { casteljauType?: unknown };
  if (casteljauType) {
    const hint = casteljauType === "path" ? "; did you mean Path.combine?" : "";
    throw new TypeError(`options: expected an object, got ${describe(value)}${hint}`);
  }
  const names = known as readonly string[];
  for (const key of Object.keys(value)) {
    if (names.includes(key) || (value as Record<string, unknown>)[key] === undefined) continue;
    throw new TypeError(`${shorten(key)}: unknown option; ${suggestion(shorten(key), names)}`);
  }
  return value;
}

/** The options that a value in the place of the options was probably meant for, by its type. */
const LIKELY_OPTIONS: Partial<Record<string, readonly string[]>> = {
  integer: ["segments", "precision", "tolerance"],
  number: ["tolerance"],
  string: ["fillRule", "join", "kind"],
  boolean: ["closed"],
};

/** The end of a message: the option that a value in the place of the options was probably meant for. */
function hintForOption(value: unknown, known: readonly PropertyKey[]): string {
  const names = LIKELY_OPTIONS[Number.isInteger(value) ? "integer" : typeof value];
  const name = names?.find((option) => known.includes(option));
  return name ? `; did you mean { ${name}: ${describe(value)} }?` : "";
}

/** An option that is true or false. */
export function optionalBoolean(value: unknown, name: string, byDefault = false): boolean {
  if (value === undefined) return byDefault;
  if (typeof value !== "boolean") throw new TypeError(`${name}: expected true or false, got ${describe(value)}`);
  return value;
}

function suggestion(key: string, known: readonly string[]): string {
  const nearest = similarName(key, known, 1 / 3);
  return nearest === undefined ? `expected ${known.join(", ")}` : `did you mean ${nearest}?`;
}

/**
 * The name that was probably meant: one that begins with the text, or is its beginning or end; otherwise the nearest one.
 *
 * @param maxChange the largest part of the letters that may differ
 */
export function similarName<T extends string>(text: string, known: readonly T[], maxChange: number): T | undefined {
  const wanted = text.toLowerCase();
  const lower = known.map((name) => name.toLowerCase());
  const isPart = (name: string) => wanted.startsWith(name) || wanted.endsWith(name);
  let nearest = lower.findIndex((name) => name.startsWith(wanted) || isPart(name));
  if (nearest < 0) {
    const distances = lower.map((name) => editDistance(wanted, name));
    const smallest = Math.min(...distances);
    if (smallest <= wanted.length * maxChange) nearest = distances.indexOf(smallest);
  }
  return known[nearest];
}

/** The Levenshtein distance: how many letters have to be inserted, removed or replaced. */
function editDistance(a: string, b: string): number {
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
