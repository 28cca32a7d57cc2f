// Runs chosen test files with Node's test runner: what the runners of tests/page, tests/browsers and tests/packaging share.
import { spawn } from "node:child_process";
import { readdirSync } from "node:fs";
import { basename, join } from "node:path";
import { fileURLToPath } from "node:url";

const DURATIONS = new URL("./durations.js", import.meta.url).href;
const SKIPPED = new URL("../xtask/skipped.js", import.meta.url).href;
const ENDING = ".test.js";
const DEEP_ENDING = ".deep.test.js";
/**
 * Node ends a test file, and fails it, after so long, even if its tests still pass. The longest one takes less than a tenth of
 * it on an idle machine. Waiting for a page or a browser gives up earlier, after two minutes.
 */
const TIMEOUT_MS = 1_800_000;

/**
 * Splits the arguments of a runner into test files and patterns of test names. An argument that names a file (its path or
 * its base name, with or without `.test.js`) selects the file; `/…/` is a regular expression for test names; any other
 * text selects the tests whose names contain it. Without a named file, `--deep` selects the files `*.deep.test.js`, and
 * its absence all others.
 *
 * @param {string | URL} folder URL of the folder with the test files
 * @param {string[]} args
 * @returns {{ files: string[], patterns: string[] }} paths; patterns for --test-name-pattern
 */
export function chooseTests(folder, args) {
  const path = fileURLToPath(folder);
  const all = readdirSync(path)
    .filter((name) => name.endsWith(ENDING))
    .sort();
  const deep = args.includes("--deep");
  const words = args.filter((arg) => arg !== "--deep");
  const unknown = words.find((word) => word.startsWith("--"));
  if (unknown) throw new RangeError(`expected --deep, files or test names, got ${unknown}`);
  const named = words.map((word) => ({ word, file: all.find((name) => isNameOf(name, basename(word))) }));
  const files = named.flatMap(({ file }) => file ?? []);
  const chosen = files.length > 0 ? [...new Set(files)] : all.filter((name) => name.endsWith(DEEP_ENDING) === deep);
  const patterns = named.filter(({ file }) => !file).map(({ word }) => patternOf(word));
  return { files: chosen.map((name) => join(path, name)), patterns };
}

/** @param {string} name @param {string} word */
const isNameOf = (name, word) => name === word || name === word + ENDING;

/** @param {string} word */
const patternOf = (word) => (/^\/.+\/[a-z]*$/.test(word) ? word : word.replace(/[.*+?^${}()|[\]\\]/g, "\\$&"));

/**
 * Runs test files, prints what Node's reporter "spec" prints and the seconds of each file.
 *
 * @param {{ files: string[], patterns: string[] }} chosen
 * @param {{ concurrency?: number, env?: Record<string, string> }} [options] how many files run at once; additional variables
 * @returns {Promise<number>} Node's exit code
 */
export function runTests({ files, patterns }, { concurrency = 1, env = {} } = {}) {
  const outputs = [
    ["spec", "stdout"],
    [DURATIONS, "stdout"],
  ];
  // The driver names the file in which it looks for skipped tests.
  if (process.env.CASTELJAU_SKIPPED) outputs.push([SKIPPED, process.env.CASTELJAU_SKIPPED]);
  const reporters = outputs.flatMap(([name, to]) => [`--test-reporter=${name}`, `--test-reporter-destination=${to}`]);
  const names = patterns.map((pattern) => `--test-name-pattern=${pattern}`);
  const args = [
    // Node's own runner has more reporters and files than it expects listeners, and calls its mocks experimental.
    "--disable-warning=MaxListenersExceededWarning",
    "--disable-warning=ExperimentalWarning",
    "--test",
    `--test-concurrency=${concurrency}`,
    `--test-timeout=${TIMEOUT_MS}`,
    ...reporters,
    ...names,
    ...files,
  ];
  const node = spawn(process.execPath, args, { stdio: "inherit", env: { ...process.env, ...env } });
  process.once("exit", () => node.kill()); // a runner that is interrupted leaves nothing behind
  return new Promise((resolve, reject) => node.once("error", reject).once("exit", (code) => resolve(code ?? 1)));
}
