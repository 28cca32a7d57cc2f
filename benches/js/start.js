// Start-up: import and first call in new processes, and the size of the package.
import { spawnSync } from "node:child_process";
import { fileURLToPath } from "node:url";
import { median, spread } from "./harness.js";

const root = fileURLToPath(new URL("../../", import.meta.url));

/** @typedef {{ import: number, firstCall: number, compile: number, instantiate: number }} Times in ms */

/**
 * @param {import("./harness.js").Effort} effort
 */
export function results(effort) {
  return [...firstCall(effort.rounds), ...sizes()];
}

/**
 * @param {number} processes
 */
function firstCall(processes) {
  const times = Array.from(
    { length: processes },
    () => /** @type {Times} */ (JSON.parse(run("benches/js/first-call.js"))),
  );
  const row = (/** @type {string} */ id, /** @type {string} */ work, /** @type {(t: Times) => number} */ of) => {
    const ns = times.map((time) => 1e6 * of(time));
    return withoutPeer(id, work, "ns", median(ns), spread(ns));
  };
  return [
    row("import", "import in a new Node process", (t) => t.import),
    row("first-call", "first call after import", (t) => t.firstCall),
    row("first-call-wasm", "  of that: compile + instantiate the wasm", (t) => t.compile + t.instantiate),
  ];
}

/** Sizes as xtask/size.js prints them. */
export function sizes() {
  const printed = run("xtask/size.js");
  const row = (/** @type {string} */ id, /** @type {string} */ name, /** @type {string} */ work) => {
    const line = printed.split("\n").find((line) => line.startsWith(`${name} `));
    const kB = line?.match(/([\d.]+) kB$/)?.[1];
    if (kB === undefined) throw new Error(`xtask/size.js printed no size of ${name}`);
    return withoutPeer(id, work, "bytes", 1000 * Number(kB));
  };
  return [
    row("size", "everything", "a bundle that imports all classes, minified, gzip -9"),
    row(
      "size-elements",
      "elements.js, easing",
      "casteljau/elements on a page with an easing editor, minified, gzip -9",
    ),
    row("size-curves", "everything of core", "a bundle that imports everything of casteljau/core, minified, gzip -9"),
  ];
}

/**
 * A result without a peer.
 *
 * @param {string} id
 * @param {string} work
 * @param {string} unit
 * @param {number} ours
 * @param {number} [ourSpread]
 */
function withoutPeer(id, work, unit, ours, ourSpread = 0) {
  return { id, work, peer: null, unit, theirs: null, ours, ratio: null, spread: [0, ourSpread] };
}

/**
 * Runs a script and returns its output.
 *
 * @param {string} script
 */
function run(script) {
  const { stdout, stderr, error } = spawnSync(process.execPath, [script], { cwd: root, encoding: "utf8" });
  // size.js fails after printing if a size is above its limit; the row reports that, too.
  if (error || !stdout) throw error ?? new Error(`${script}: ${stderr}`);
  return stdout;
}
