// Generated calls of every public function of the package: only stated refusals, no NaN, and always an end; what only JavaScript has is checked, too.
// tests/generator makes the cases, the same ones as for tests/generated; CASTELJAU_CASES, CASTELJAU_SEED and
// CASTELJAU_ONLY=Curve.offset:123 choose them.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Worker } from "node:worker_threads";
import * as casteljau from "casteljau";
import { NurbsCurve, NurbsSurface, RationalCurve, RationalPatch, RationalSurface } from "casteljau/nurbs";
import { GROUPS } from "./generated/calls.js";
import { generatorPath, lines, rowOf } from "./generated/generator.js";
import { READERS } from "./generated/parsers.js";
import { isWanted, range, seed } from "./generated/settings.js";

/** A call that takes longer than this is reported as one that does not return. No answer takes a thousandth of it. */
const HANG_MS = 120_000;
const LOOK_MS = 1_000;

const { Curve, Spline, Path, InkStroke, Patch, Surface, Mesh } = casteljau;
const CLASSES = {
  ...{ Curve, RationalCurve, NurbsCurve, Spline, Path, InkStroke, Patch, RationalPatch, NurbsSurface },
  ...{ Surface, RationalSurface, Mesh },
};
const [first, count] = range;
const path = generatorPath();

/** What repeats a failure, and what can be pasted into a test. */
function described(name, { number, mode, message }) {
  const [line] = lines(path, seed, rowOf(name), number, 1, "--javascript");
  return `${name}, seed ${seed}, number ${number} (${mode}): ${message}
  repeat: CASTELJAU_SEED=${seed} CASTELJAU_ONLY=${rowOf(name)}:${number} node --test tests/js/generated.test.js
  JavaScript: ${line}`;
}

/** Runs functions on a thread; where a call does not return, gives the place of its function. */
function runOn(names, reports) {
  const progress = new SharedArrayBuffer(16);
  const current = new Float64Array(progress).fill(-1);
  const worker = new Worker(new URL("./generated/worker.js", import.meta.url), {
    workerData: { path, seed, first, count, names, progress },
  });
  return new Promise((resolve, reject) => {
    let [seen, since] = ["", Date.now()];
    const watch = setInterval(() => {
      const now = current.join();
      if (now !== seen) [seen, since] = [now, Date.now()];
      else if (current[0] >= 0 && Date.now() - since > HANG_MS) {
        clearInterval(watch);
        reports.push({
          name: names[current[0]],
          failed: 1,
          failures: [{ number: current[1], mode: "watched", message: `no answer after ${HANG_MS / 1000} s` }],
        });
        worker.terminate().then(() => resolve(current[0]));
      }
    }, LOOK_MS);
    worker.on("message", (report) => reports.push(report));
    worker.on("error", reject);
    worker.on("exit", () => {
      clearInterval(watch);
      resolve(undefined);
    });
  });
}

async function runAll(all) {
  const reports = [];
  let names = all.filter((name) => isWanted(rowOf(name)));
  while (names.length) {
    const stuck = await runOn(names, reports);
    names = stuck === undefined ? [] : names.slice(stuck + 1);
  }
  const bad = reports.filter(({ failed }) => failed);
  const text = bad.map(({ name, failed, failures }) =>
    [`${name}: ${failed} failures`, ...failures.map((failure) => described(name, failure))].join("\n"),
  );
  assert.equal(bad.length, 0, `${bad.length} functions failed\n\n${text.join("\n\n")}`);
}

const groups = [...GROUPS.map(Object.keys), Object.keys(READERS)];
test("generated calls: every answer is finite, every refusal is stated, every call returns", {
  concurrency: 2,
}, async (t) => {
  await Promise.all(groups.map((names) => t.test(`${names[0]} … ${names.at(-1)}`, () => runAll(names))));
});

/** The public members of an object and of what it inherits from, up to one that every object of its kind has. */
function publicNames(object, end) {
  const names = new Set();
  for (let at = object; at !== end; at = Object.getPrototypeOf(at)) {
    for (const name of Object.getOwnPropertyNames(at)) names.add(name);
  }
  return [...names].filter((name) => !/^_|^casteljau/.test(name)); // those are marked as internal
}

test("every public function has a row", () => {
  const names = Object.entries(CLASSES).flatMap(([name, type]) => [
    ...publicNames(type.prototype, Object.prototype).map((method) => `${name}.${method}`),
    ...publicNames(type, Function.prototype)
      .filter((method) => !["length", "name", "prototype"].includes(method))
      .map((method) => `${name}.${method}`),
  ]);
  const known = groups.flat();
  const absent = names.filter((name) => !known.includes(name));
  assert.deepEqual(absent, []);
  const others = Object.keys(casteljau).filter((name) => !(name in CLASSES) && !known.includes(name));
  assert.deepEqual(others, ["init"]);
});
