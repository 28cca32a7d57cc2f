// `npm test`, `npm run test:all` and `npm run test:deep`:
//
//     node scripts/test.js [--all | --deep] [STEP [FILE_OR_NAME …] …] [--from STEP] [--cases N]
//
// After a failure the other steps still run. CONTRIBUTING.md describes the commands.
import { readFile, writeFile } from "node:fs/promises";
import { parse } from "./choose.js";
import { runLanes } from "./lanes.js";
import { outputOf, target } from "./run.js";
import { checkNode, packages, rust } from "./setup.js";
import { hashOf } from "./stamp.js";
import { ALL, DEEP, MAY_SKIP, STEPS, USUAL } from "./steps.js";
import { summary } from "./summary.js";

/** The kinds of runs. */
const COMMANDS = {
  usual: { command: "npm test --", amount: /** @type {const} */ ("few"), steps: STEPS, names: USUAL },
  all: { command: "npm run test:all --", amount: /** @type {const} */ ("usual"), steps: STEPS, names: ALL },
  deep: {
    command: "npm run test:deep --",
    amount: /** @type {const} */ ("many"),
    steps: DEEP,
    names: DEEP.map(({ name }) => name),
  },
};

/** The file with the steps that passed, each with a hash of the repository's content at that time. */
const PASSED = `${target}/scripts/passed.json`;

/** A hash of all files of the repository that git knows or would add; undefined without git. */
async function content() {
  const files = await outputOf("git", ["ls-files", "--cached", "--others", "--exclude-standard", "-z"]);
  const removed = await outputOf("git", ["ls-files", "--deleted", "-z"]);
  if (files === undefined || removed === undefined) return undefined;
  const gone = new Set(removed.split("\0"));
  const versions = [process.version, await outputOf("rustc", ["--version"])];
  const present = [...new Set(files.split("\0"))].filter((file) => file && !gone.has(file));
  return hashOf(present.sort(), versions.map(String));
}

/** A word for a shell, quoted if necessary. @param {string} word */
const quoted = (word) => (/^[\w./:,-]+$/.test(word) ? word : `'${word.replaceAll("'", `'\\''`)}'`);

async function main() {
  const words = process.argv.slice(2);
  const kind = words[0] === "--all" ? "all" : words[0] === "--deep" ? "deep" : "usual";
  const { command, amount, steps, names } = COMMANDS[kind];
  const { choices, named, cases } = parse(kind === "usual" ? words : words.slice(1), steps, names);
  checkNode();
  const start = performance.now();
  await Promise.all([rust(), packages("all")]);
  const before = await content();
  const passed = JSON.parse(await readFile(PASSED, "utf8").catch(() => "{}"));
  const chosen = choices.map(({ name, filters }) => {
    const step = steps.find((each) => each.name === name);
    if (!step) throw new Error(`no step ${name}`);
    return { step, filters };
  });
  const records = await runLanes(chosen, {
    amount,
    cases,
    repeat: (name, filters) =>
      [
        command,
        name,
        ...(cases ? ["--cases", String(cases)] : []),
        ...(filters.length ? ["--", ...filters.map(quoted)] : []),
      ].join(" "),
    hasPassed: ({ name, once }) =>
      once === true && kind === "all" && !named && before !== undefined && passed[name] === before,
  });
  const complete = records.filter(
    ({ name, outcome }) => outcome === "passed" && !choices.find((c) => c.name === name)?.filters.length,
  );
  await writeFile(
    PASSED,
    JSON.stringify({ ...passed, ...Object.fromEntries(complete.map(({ name }) => [name, before])) }),
  );
  console.log(summary(records, (performance.now() - start) / 1000));
  const failed = records.filter(({ outcome }) => outcome === "FAILED");
  const skipped = records.filter(({ name, outcome }) => outcome === "skipped" && !MAY_SKIP.includes(name));
  if (failed.length > 0) throw new Error(`${failed.length} of ${records.length} steps failed`);
  if (process.env.CI && skipped.length > 0)
    throw new Error(`steps that were skipped: ${skipped.map(({ name }) => name).join(", ")}`);
}

try {
  await main();
} catch (error) {
  console.error(`error: ${/** @type {Error} */ (error).message}`);
  process.exitCode = 1;
}
