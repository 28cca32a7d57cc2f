// The benchmarks: `npm run bench` builds, runs `cargo bench`, and then this script, which needs the output of
// `npm run build`.
//
//   node benches/js/run.js            all rows; prints a table and writes benches/results.json
//   node benches/js/run.js teapot     only rows whose id contains "teapot"; writes nothing
//   node benches/js/run.js ink fit    those whose id contains one of several words
//   node benches/js/run.js --quick    runs each row once to check that both sides agree; writes nothing
//
// targets.js has the targets, rows.js measures one row in a process of its own with harness.js, table.js prints. The rows
// are in the files that FILES names, in adaptive.js, start.js, frame.js, scroll.js and growth.js; native.js reads the results of
// `cargo bench`.
import { spawnSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { availableParallelism, cpus } from "node:os";
import { fileURLToPath } from "node:url";
import * as frame from "./frame.js";
import { FULL, QUICK } from "./harness.js";
import * as native from "./native.js";
import * as scroll from "./scroll.js";
import * as start from "./start.js";
import { comparisons, growths } from "./table.js";
import { withVerdict } from "./targets.js";

const root = new URL("../../", import.meta.url);
const read = (/** @type {string} */ name) => readFileSync(new URL(name, root), "utf8");

/** The files whose rows compare this package with a peer. */
const FILES = [
  "again",
  "curve",
  "easing",
  "fit",
  "ink",
  "intersect",
  "length",
  "nearest",
  "nurbs",
  "nurbs-surface",
  "offset",
  "path",
  "regions",
  "teapot",
];

const args = process.argv.slice(2);
const quick = args.includes("--quick");
const effort = quick ? QUICK : FULL;
const filters = args.filter((arg) => !arg.startsWith("--"));
const isSelected = (/** @type {string} */ id) => !filters.length || filters.some((part) => id.includes(part));
/** Adds the target of a result; a quick run has none, because its times are meaningless. */
const judge = (/** @type {{ id: string, ours: number, ratio: number | null }} */ result) =>
  quick ? { ...result, target: null, met: null } : withVerdict(result);

const LEGEND = `
Both sides gave the same results first. Times are medians of ${effort.rounds} rounds (native ones: criterion's medians), both
sides in turn; ± is half the distance of the quartiles. The ratio says how many times faster (or smaller) ours is: the
median of the rounds' ratios.
`;
const QUICK_LEGEND = "\nBoth sides give the same results. Each row ran once: the times are meaningless.\n";

/** The machine and the versions of all packages. */
function conditions() {
  const npm = (/** @type {string} */ name) => JSON.parse(read(`node_modules/${name}/package.json`)).version;
  const lock = read("Cargo.lock");
  const crate = (/** @type {string} */ name) => new RegExp(`name = "${name}"\nversion = "(.*)"`).exec(lock)?.[1];
  const { name, version } = JSON.parse(read("package.json"));
  return {
    machine: { cpu: cpus()[0].model, cores: availableParallelism(), platform: `${process.platform} ${process.arch}` },
    date: new Date().toISOString().slice(0, 10),
    versions: {
      [name]: version,
      node: process.versions.node,
      ...Object.fromEntries(
        [
          "bezier-easing",
          "bezier-js",
          "paper",
          "pathkit-wasm",
          "perfect-freehand",
          "svg-path-properties",
          "three",
          "verb-nurbs",
        ].map((peer) => [peer, npm(peer)]),
      ),
      ...Object.fromEntries(["kurbo", "lyon_geom", "linesweeper", "i_curve"].map((peer) => [peer, crate(peer)])),
    },
  };
}

/**
 * The results of chosen rows of a file: each row in a process of its own, or all together in a quick run.
 *
 * @param {string} file
 */
function resultsOf(file) {
  const ids = rowsIn(file, "--list").filter(isSelected);
  if (quick)
    return ids.length ? rowsIn(file, "--quick", ...ids.flatMap((/** @type {string} */ id) => ["--id", id])) : [];
  return ids.flatMap((/** @type {string} */ id) => rowsIn(file, "--id", id));
}

/**
 * What rows.js prints.
 *
 * @param {...string} args
 * @returns {any[]}
 */
function rowsIn(...args) {
  const script = fileURLToPath(new URL("rows.js", import.meta.url));
  const { status, stdout } = spawnSync(process.execPath, [script, ...args], {
    encoding: "utf8",
    stdio: ["ignore", "pipe", "inherit"],
  });
  if (status !== 0) throw new Error(`rows.js ${args.join(" ")} failed`);
  return JSON.parse(stdout);
}

const compared = FILES.flatMap(resultsOf);
const adaptiveRows = isSelected("adaptive-verb") ? rowsIn("adaptive", ...(quick ? ["--quick"] : [])) : [];
const startRows = filters.length ? [] : start.results(effort);
const frameRows = quick || !isSelected("frame") ? [] : await frame.results(effort);
const scrollRows = quick || !isSelected("scroll") ? [] : await scroll.results();
const growthRows = resultsOf("growth").map((result) => judge(result));
const nativeRows = quick ? [] : native.results().filter(({ id }) => isSelected(id));
const rows = [...compared, ...adaptiveRows, ...startRows, ...frameRows, ...scrollRows, ...nativeRows].map((result) =>
  judge(result),
);
const run = conditions();

console.log(`\n${run.machine.cpu}, ${run.machine.cores} cores, ${run.machine.platform}, ${run.date}`);
console.log(
  Object.entries(run.versions)
    .map((pair) => pair.join(" "))
    .join(", "),
);
console.log(quick ? QUICK_LEGEND : LEGEND);
if (rows.length) console.log(comparisons(rows));
if (growthRows.length) console.log(`\n${growths(growthRows)}`);
if (!quick && !filters.length && !frameRows.length)
  console.log("\nNo rows for frames and scrolling: Chromium was not found (CHROME_PATH).");
if (!quick && !filters.length && !nativeRows.length) console.log("\nNo native rows: run `cargo bench` first.");
if (!quick && !filters.length) {
  writeFileSync(
    new URL("benches/results.json", root),
    `${JSON.stringify({ ...run, rows, growth: growthRows }, null, 2)}\n`,
  );
  console.log("\nWritten to benches/results.json.");
}
