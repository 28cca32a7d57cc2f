// Runs the samples of the reference in Node, against the built package.
import * as casteljau from "casteljau";
import * as nurbs from "casteljau/nurbs";
import { Drawing } from "../live/drawing.js";
import { inspect } from "../live/inspect.js";
import { expectedLines, promisesOf } from "./entries.js";
import { NAMES, NURBS_NAMES, sampleSource } from "./sample.js";

/** @import { Entry } from "./entries.js" */

/**
 * The sample, its checks and its drawing as a function of the inputs.
 *
 * @param {Entry} entry
 */
async function compile(entry) {
  const code = entry.js?.code ?? "";
  const checks = checksOf(entry).map((check) => check.code);
  const imports = [...code.matchAll(/^import (?:\* as )?(\w+) from "([^"]+)";$/gm)];
  const names = [...NAMES, ...NURBS_NAMES, ...imports.map(([, name]) => name)];
  const values = [
    ...NAMES.map((name) => /** @type {any} */ (casteljau)[name]),
    ...NURBS_NAMES.map((name) => /** @type {any} */ (nurbs)[name]),
  ];
  for (const [, , specifier] of imports) values.push(await import(specifier));
  const source = `return (${sampleSource(code, entry.draw?.code, checks)});`;
  try {
    return new Function(...names, source)(...values);
  } catch (error) {
    throw new Error(`${entry.file}: ${error}`);
  }
}

/** The lines of an entry that promise a result or an error. @param {Entry} entry */
export const checksOf = (entry) =>
  ["Degenerate case", "Errors"].flatMap((name) => promisesOf(entry.sections.get(name)));

/**
 * What a sample prints, what its checks give, and its picture.
 *
 * @param {Entry} entry
 * @param {(value: unknown) => string} [show] how a value is printed
 * @param {Record<string, unknown>} [values] of inputs, instead of those of the sample
 */
export async function runEntry(entry, show = (value) => inspect(value), values = {}) {
  const { inputs, run } = await compile(entry);
  const printed = /** @type {string[]} */ ([]);
  const log = (/** @type {unknown[]} */ ...values) =>
    printed.push(
      ...values
        .map((value) => show(value))
        .join(" ")
        .split("\n"),
    );
  const drawing = new Drawing();
  const checks = run(
    Object.fromEntries(inputs.map((/** @type {any} */ i) => [i.name, structuredClone(values[i.name] ?? i.value)])),
    { log },
    drawing,
  );
  return { inputs, printed, checks: checks.map((/** @type {() => unknown} */ check) => outcome(check, show)), drawing };
}

/** @param {() => unknown} check @param {(value: unknown) => string} show */
function outcome(check, show) {
  try {
    return show(check());
  } catch (error) {
    const { name, message } = /** @type {Error} */ (error);
    return `${name}: ${message}`;
  }
}

/**
 * What an entry says and what is true, where they differ.
 *
 * @param {Entry} entry
 * @param {(value: unknown) => string} [show]
 */
export async function differences(entry, show) {
  const { printed, checks } = await runEntry(entry, show);
  const expected = expectedLines(entry.js?.code ?? "");
  const length = Math.max(printed.length, expected.length);
  const lines = Array.from({ length }, (_, k) => ({ where: `line ${k + 1}`, says: expected[k], is: printed[k] }));
  const promises = checksOf(entry).map(({ code, result }, k) => ({ where: code, says: result, is: checks[k] }));
  return [...lines, ...promises].filter(({ says, is }) => says !== is);
}
