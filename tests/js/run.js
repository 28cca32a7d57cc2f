// Runs the tests of the npm package: most files in two processes, because each process would load the core anew.
//
//     node tests/js/run.js [--without=NAME …] [FILE_OR_NAME …]
//
// A file is chosen by its path or base name, with or without `.test.js`; other words choose tests by their names.
import { mkdirSync, writeFileSync } from "node:fs";
import { basename } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { chooseTests, runTests } from "../node-tests.js";

/** Files that need a process of their own: they measure memory, load or break the core in other ways, or keep several threads busy. */
const ALONE = ["generated", "init", "kept-tables", "large-drawings", "memory", "parity", "refusals", "workers"];

const args = process.argv.slice(2);
const without = args.filter((arg) => arg.startsWith("--without=")).map((arg) => arg.slice("--without=".length));
const { files, patterns } = chooseTests(
  new URL("./", import.meta.url),
  args.filter((arg) => !arg.startsWith("--without=")),
);
const nameOf = (/** @type {string} */ file) => basename(file, ".test.js");
const wanted = files.filter((file) => !without.includes(nameOf(file)));
const alone = wanted.filter((file) => ALONE.includes(nameOf(file)));
const together = wanted.filter((file) => !alone.includes(file));

const folder = new URL("../../target/js-tests/", import.meta.url);
mkdirSync(folder, { recursive: true });
const groups = [0, 1].flatMap((half) => {
  const part = together.filter((_, k) => k % 2 === half);
  if (part.length === 0) return [];
  const path = fileURLToPath(new URL(`${half === 0 ? "first" : "second"}-half.mjs`, folder));
  writeFileSync(path, part.map((file) => `await import(${JSON.stringify(pathToFileURL(file).href)});\n`).join(""));
  return [path];
});
process.exitCode = await runTests({ files: [...groups, ...alone], patterns }, { concurrency: 2 });
