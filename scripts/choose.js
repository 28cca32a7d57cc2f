// Resolves the words of the command line to steps, test binaries of the crate, test files and patterns.
import { readdirSync, readFileSync } from "node:fs";
import { basename, join } from "node:path";
import { root } from "./run.js";

/**
 * Reads `[STEP [FILE_OR_NAME …] …] [--from STEP] [--cases N]`. A word that is not the name of a step is a filter of the step
 * before it, as is every word after `--`.
 *
 * @param {readonly string[]} words
 * @param {readonly { name: string, selects?: boolean }[]} steps all steps
 * @param {readonly string[]} usual the names of those that run if none is named
 * @returns {{ choices: { name: string, filters: string[] }[], named: boolean, cases?: number }}
 */
export function parse(words, steps, usual) {
  const find = (/** @type {string} */ name) => {
    const step = steps.find((each) => each.name === name);
    if (!step) throw new Error(`expected one of ${steps.map((each) => each.name).join(", ")}, got ${name}`);
    return step;
  };
  /** @type {{ name: string, filters: string[] }[]} */
  const choices = [];
  /** @type {number | undefined} */
  let cases;
  /** @type {string | undefined} */
  let from;
  const filter = (/** @type {string} */ word) => {
    const last = choices.at(-1);
    if (!last) throw new Error(`${word}: expected the name of a step before it`);
    if (!find(last.name).selects) throw new Error(`${last.name} has no tests to choose from, got ${word}`);
    last.filters.push(word);
  };
  const rest = [...words];
  while (rest.length > 0) {
    const word = /** @type {string} */ (rest.shift());
    if (word === "--") rest.splice(0).forEach(filter);
    else if (word === "--from") from = find(rest.shift() ?? "nothing").name;
    else if (word === "--cases") {
      const text = rest.shift() ?? "nothing";
      cases = Number(text);
      if (!(Number.isInteger(cases) && cases > 0)) throw new Error(`--cases: expected a number from 1, got ${text}`);
    } else if (word.startsWith("-")) throw new Error(`expected --from, --cases or the name of a step, got ${word}`);
    else if (choices.length > 0 && !steps.some(({ name }) => name === word)) filter(word);
    else choices.push({ name: find(word).name, filters: [] });
  }
  if (from && choices.length > 0) throw new Error("--from and names of steps cannot be combined");
  const first = from ? usual.indexOf(from) : 0;
  if (first < 0) throw new Error(`expected one of ${usual.join(", ")}, got ${from}`);
  if (choices.length > 0) return { choices, named: true, cases };
  return { choices: usual.slice(first).map((name) => ({ name, filters: [] })), named: false, cases };
}

/**
 * The test binaries of the crate, `tests/NAME.rs` or `tests/NAME/main.rs`, by name.
 *
 * @returns {{ name: string, modules: string[], runsInWasm: boolean }[]}
 */
export function testBinaries() {
  const binary = (/** @type {import("node:fs").Dirent} */ item) => {
    const path = item.isDirectory() ? `${item.name}/main.rs` : item.name;
    if (!path.endsWith(".rs")) return [];
    try {
      const text = readFileSync(join(root, "tests", path), "utf8");
      const modules = Array.from(text.matchAll(/^mod (\w+);$/gm), ([, name]) => name);
      return [{ name: basename(item.name, ".rs"), modules, runsInWasm: text.includes("wasm_bindgen_test") }];
    } catch {
      return [];
    }
  };
  const items = readdirSync(join(root, "tests"), { withFileTypes: true });
  return items.flatMap(binary).sort((a, b) => (a.name < b.name ? -1 : 1));
}

/**
 * The binaries and the parts of test names that filters choose. A filter that names a binary (`generated`) selects it; one that
 * names a module of a binary (`curve`, `tests/curve`, `tests/curve/eval.rs`) selects the binary and the tests of the module; any
 * other filter is a part of a test name.
 *
 * @param {readonly string[]} filters
 * @param {readonly { name: string, modules: string[] }[]} binaries
 */
export function chooseRustTests(filters, binaries) {
  const targets = new Set();
  const tests = [];
  for (const filter of filters) {
    const path = filter
      .replace(/^tests\//, "")
      .replace(/\.rs$/, "")
      .replaceAll("/", "::");
    const [first] = path.split("::");
    const named = binaries.find(({ name }) => name === first);
    const owner = filter.includes("::") ? undefined : binaries.find(({ modules }) => modules.includes(first));
    if (named ?? owner) targets.add((named ?? owner)?.name);
    if (!named) tests.push(owner ? `${path.replace(/::mod$/, "")}::` : filter);
  }
  return { targets: /** @type {string[]} */ ([...targets].sort()), tests };
}
