// The scripts behind `npm test`: what the words of a command choose, in which order steps run, and what is reported.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Skipped } from "../../scripts/browsers.js";
import { chooseRustTests, parse, testBinaries } from "../../scripts/choose.js";
import { runLanes } from "../../scripts/lanes.js";
import { ALL, DEEP, MAY_SKIP, STEPS, USUAL } from "../../scripts/steps.js";
import { summary } from "../../scripts/summary.js";

const NAMES = [
  { name: "fmt" },
  { name: "native", selects: true },
  { name: "build" },
  { name: "page", selects: true },
  { name: "extra" },
];
const words = (line) => line.split(" ").filter(Boolean);

/** What is read, as text: `step(filter filter) step`. */
function read(line) {
  const { choices, named, cases } = parse(words(line), NAMES, ["fmt", "native", "build", "page"]);
  const text = choices.map(({ name, filters }) => (filters.length > 0 ? `${name}(${filters.join(" ")})` : name));
  return [...text, ...(named ? ["named"] : []), ...(cases ? [cases] : [])].join(" ");
}

test("steps and filters are distinguished", () => {
  for (const [line, expected] of [
    ["", "fmt native build page"],
    ["fmt", "fmt named"],
    ["extra", "extra named"],
    ["page fmt", "page fmt named"],
    ["native curve split", "native(curve split) named"],
    ["native curve page site.test.js", "native(curve) page(site.test.js) named"],
    ["page -- fmt --from", "page(fmt --from) named"],
    ["--from build", "build page"],
    ["--cases 5000 page", "page named 5000"],
    ["--cases 7", "fmt native build page 7"],
  ])
    assert.equal(read(line), expected, line);
});

test("refusals name what is expected", () => {
  const known = "expected one of fmt, native, build, page, extra, got";
  for (const [line, message] of [
    ["pages", `${known} pages`],
    ["--from pages", `${known} pages`],
    ["--from", `${known} nothing`],
    ["--from extra", "expected one of fmt, native, build, page, got extra"],
    ["fmt curve", "fmt has no tests to choose from, got curve"],
    ["fmt --from fmt", "--from and names of steps cannot be combined"],
    ["-- site", "site: expected the name of a step before it"],
    ["--deep", "expected --from, --cases or the name of a step, got --deep"],
    ["--cases many", "--cases: expected a number from 1, got many"],
    ["--cases", "--cases: expected a number from 1, got nothing"],
  ])
    assert.throws(() => read(line), { message }, line);
});

test("Rust tests are chosen by binary, module, file or name", () => {
  const known = [
    { name: "one", modules: ["curve", "path"] },
    { name: "two", modules: ["runner"] },
  ];
  for (const [line, targets, tests] of /** @type {const} */ ([
    ["curve", ["one"], ["curve::"]],
    ["tests/curve", ["one"], ["curve::"]],
    ["tests/curve/mod.rs", ["one"], ["curve::"]],
    ["tests/curve/eval.rs", ["one"], ["curve::eval::"]],
    ["two", ["two"], []],
    ["tests/two/main.rs", ["two"], []],
    ["curve path", ["one"], ["curve::", "path::"]],
    ["curves curve::eval", [], ["curves", "curve::eval"]],
  ]))
    assert.deepEqual(chooseRustTests(words(line), known), { targets, tests }, line);
  const names = testBinaries().map(({ name, runsInWasm }) => [name, runsInWasm]);
  assert.deepEqual(names, [
    ["generated", false],
    ["native", false],
    ["native_and_wasm", true],
  ]);
});

test("every command runs steps that exist, each once, after those that it needs", () => {
  const known = STEPS.map(({ name }) => name);
  assert.deepEqual(
    [...USUAL, ...ALL, ...MAY_SKIP].filter((name) => !known.includes(name)),
    [],
  );
  for (const names of [known, USUAL, ALL, DEEP.map(({ name }) => name)])
    assert.equal(new Set(names).size, names.length);
  const missing = known.filter((name) => !USUAL.includes(name) && !ALL.includes(name));
  assert.deepEqual(missing, [], "each step runs somewhere");
  for (const { name, needs = [] } of STEPS)
    for (const names of [USUAL, ALL])
      for (const needed of needs.filter((each) => names.includes(each) && names.includes(name)))
        assert.ok(names.indexOf(needed) < names.indexOf(name) || STEPS.find((s) => s.name === needed)?.lane === "rust");
});

/** Runs steps that are described by what they do; gives name, outcome and reason of each. */
async function outcomes(steps, hasPassed = (/** @type {{ once?: boolean }} */ _step) => false) {
  const all = steps.map(({ name, lane = "rust", ...rest }) => ({
    step: { title: name, lane, name, ...rest },
    filters: [],
  }));
  const repeat = (name) => `repeat ${name}`;
  const records = await runLanes(all, { amount: "few", repeat, hasPassed, show() {} });
  return records.map(({ name, outcome, reason }) => [name, outcome, ...(reason ? [reason] : [])]);
}

test("only what needs a failed or skipped step is skipped, also in the other lane", async () => {
  const ran = [];
  const act = (name) => async () => void ran.push(name);
  const bad = async () => {
    throw new Error("no");
  };
  const absent = async () => {
    throw new Skipped("no browser");
  };
  const steps = [
    { name: "core", act: bad },
    { name: "native", act: act("native") },
    { name: "site", lane: "js", act: absent },
    { name: "js", lane: "js", needs: ["core"], act: act("js") },
    { name: "page", lane: "js", needs: ["site"], act: act("page") },
    { name: "other", lane: "js", needs: ["native", "elsewhere"], act: act("other") },
  ];
  assert.deepEqual(await outcomes(steps), [
    ["core", "FAILED", "no"],
    ["native", "passed"],
    ["site", "skipped", "no browser"],
    ["js", "skipped", "needs core, which failed"],
    ["page", "skipped", "needs site, which was skipped"],
    ["other", "passed"],
  ]);
  assert.deepEqual(ran, ["native", "other"]);
});

test("a step that has passed on the same content does not run again", async () => {
  let count = 0;
  const act = async () => void count++;
  const steps = [
    { name: "fmt", once: true, act },
    { name: "native", act },
  ];
  assert.deepEqual(await outcomes(steps, ({ once }) => once === true), [
    ["fmt", "passed"],
    ["native", "passed"],
  ]);
  assert.equal(count, 1);
});

test("failures and skips are listed and counted", () => {
  const record = (name, outcome, reason = "", skippedTests = []) => ({
    ...{ name, title: "A title", seconds: 12.34, outcome, reason, skippedTests },
    repeat: `npm test -- ${name}`,
  });
  const records = [
    record("fmt", "passed"),
    record("build", "FAILED", "cargo ended"),
    record("page", "skipped", "build failed"),
    record("native", "passed", "", ["a: no data", "b: no data"]),
  ];
  const expected = `
━━ Summary
  passed     12.3 s  A title (fmt)
  FAILED     12.3 s  A title (build)
  skipped    12.3 s  A title (page)
  passed     12.3 s  A title (native), 2 tests skipped
             50.0 s  together

Failed:
  build: cargo ended
      to repeat: npm test -- build

Skipped:
  page: build failed
  native: a: no data
  native: b: no data

2 passed, 1 failed, 1 skipped
`;
  assert.equal(summary(records, 50), expected);
  assert.match(summary([record("fmt", "passed")], 12), /together\n\n1 passed, 0 failed, 0 skipped\n$/);
});
