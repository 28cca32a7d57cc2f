// The benchmarks: `npm run bench` builds, runs `cargo bench`, and then this. Alone it needs what `npm run build` makes.
//
//   node benches/js/run.js            every row; prints a table and writes benches/results.json
//   node benches/js/run.js teapot     only rows whose id contains "teapot"; writes nothing
//   node benches/js/run.js --quick    does each piece of work once, to see that the sides agree; writes nothing
//
// The files: targets.js says what is asked; harness.js how times are taken; curve.js, easing.js, intersect.js, path.js, teapot.js (with baseline.js),
// adaptive.js, start.js, frame.js and growth.js what is measured; native.js reads what `cargo bench` has found; table.js prints.
import { readFileSync, writeFileSync } from "node:fs";
import { availableParallelism, cpus } from "node:os";
import * as adaptive from "./adaptive.js";
import * as curve from "./curve.js";
import * as easing from "./easing.js";
import * as frame from "./frame.js";
import * as growth from "./growth.js";
import { FULL, QUICK, race } from "./harness.js";
import * as measure from "./measure.js";
import * as intersect from "./intersect.js";
import * as native from "./native.js";
import * as offset from "./offset.js";
import * as path from "./path.js";
import * as nearest from "./nearest.js";
import * as start from "./start.js";
import { comparisons, growths } from "./table.js";
import { judged } from "./targets.js";
import * as teapot from "./teapot.js";

const args = process.argv.slice(2);
const quick = args.includes("--quick");
const effort = quick ? QUICK : FULL;
const filters = args.filter((arg) => !arg.startsWith("--"));
const wanted = (/** @type {string} */ id) => filters.every((part) => id.includes(part));
/** Times that mean nothing are not judged. */
const judge = quick ? (/** @type {object} */ result) => ({ ...result, target: null, met: null }) : judged;
const root = new URL("../../", import.meta.url);
const read = (/** @type {string} */ name) => readFileSync(new URL(name, root), "utf8");

const LEGEND = `
Both sides have given the same answers first. Times are medians of ${effort.rounds} rounds (native ones: criterion's medians), both
sides in turn; ± is half the distance of the quartiles. The ratio says how many times faster (or smaller) ours is: the
median of the rounds' ratios.
`;
const QUICKLY = "\nBoth sides give the same answers. Each piece of work was done once: the times mean nothing.\n";

/** The machine, and the versions of everything that ran. */
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
        ["bezier-easing", "bezier-js", "paper", "svg-path-properties", "three", "verb-nurbs"].map((peer) => [
          peer,
          npm(peer),
        ]),
      ),
      ...Object.fromEntries(["kurbo", "lyon_geom"].map((peer) => [peer, crate(peer)])),
    },
  };
}

const raced = [
  ...curve.rows,
  ...easing.rows,
  ...intersect.rows,
  ...measure.rows,
  ...nearest.rows,
  ...offset.rows,
  ...path.rows,
  ...teapot.rows,
]
  .filter(({ id }) => wanted(id))
  .map((row) => race(row, effort));
const adapted = wanted("adaptive-verb") ? adaptive.results(effort) : [];
const started = filters.length ? [] : start.results(effort);
const framed = quick || !wanted("frame") ? [] : await frame.results(effort);
const grown = growth.results(effort, wanted).map(judge);
const measuredNatively = quick ? [] : native.results().filter(({ id }) => wanted(id));
const rows = [...raced, ...adapted, ...started, ...framed, ...measuredNatively].map(judge);
const run = conditions();

console.log(`\n${run.machine.cpu}, ${run.machine.cores} cores, ${run.machine.platform}, ${run.date}`);
console.log(
  Object.entries(run.versions)
    .map((pair) => pair.join(" "))
    .join(", "),
);
console.log(quick ? QUICKLY : LEGEND);
if (rows.length) console.log(comparisons(rows));
if (grown.length) console.log(`\n${growths(grown)}`);
if (!quick && !filters.length && !framed.length)
  console.log("\nNo row of the frame: no Chromium was found (CHROME_PATH).");
if (!quick && !filters.length && !measuredNatively.length) console.log("\nNo native rows: run `cargo bench` first.");
if (!quick && !filters.length) {
  writeFileSync(new URL("benches/results.json", root), `${JSON.stringify({ ...run, rows, growth: grown }, null, 2)}\n`);
  console.log("\nWritten to benches/results.json.");
}
