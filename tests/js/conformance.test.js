// The page of conformance: its judgement of answers, and that it asks each library in the right way.
import assert from "node:assert/strict";
import { test } from "node:test";
import { textOf } from "../../www/conformance/answers.js";
import { issueOf, KINDS, readFacts } from "../../www/conformance/facts.js";
import { ask, judge } from "../../www/conformance/judge.js";
import { LIBRARIES } from "../../www/conformance/libraries.js";
import { LOADERS } from "../../www/conformance/load.js";

const FACTS = readFacts();
/** Kinds for which the package has no function. */
const NONE = ["length_centroid", "roots"];
/** Kinds that a library answers in its own way, as the page says: bezier-js has zeros of the second derivative among its extrema. */
const ITS_WAY = ["bezier-js extrema"];

/** The answers of a library, without the global `window` that verb gets. */
async function answersOf(/** @type {string} */ name) {
  const hadWindow = "window" in globalThis;
  try {
    return (await LOADERS[name]()).answers;
  } finally {
    if (!hadWindow) Reflect.deleteProperty(globalThis, "window");
  }
}

test("this package is right about every fact for which it has a function", async () => {
  const answers = await answersOf(LIBRARIES[0].name);
  assert.equal(LIBRARIES[0].name, "casteljau");
  assert.ok(FACTS.length >= 347, `${FACTS.length}`);
  for (const fact of FACTS) {
    const { grade, off, got } = ask(answers, fact);
    assert.equal(
      grade,
      NONE.includes(fact.kind) ? "not offered" : "right",
      `${fact.id}: ${textOf(got)}, off by ${off}`,
    );
  }
});

test("each library is asked as it wants to be: of each kind that it claims it gets something right or nearly right", async () => {
  for (const library of LIBRARIES) {
    const answers = await answersOf(library.name);
    const kinds = Object.keys(answers);
    assert.ok(kinds.length >= 3 && kinds.every((kind) => kind in KINDS), `${library.name}: ${kinds}`);
    for (const kind of kinds) {
      // The slowest ones last: one that is right is enough.
      const grades = FACTS.filter((fact) => fact.kind === kind).map((fact) => () => ask(answers, fact).grade);
      const isRight = grades.some((grade) => ["right", "close"].includes(grade()));
      assert.equal(isRight, !ITS_WAY.includes(`${library.name} ${kind}`), `${library.name}: ${kind}`);
    }
  }
});

/** An answer with one of its numbers changed. */
function changed(value, by) {
  if (typeof value === "number") return value + by * Math.max(1, Math.abs(value));
  if (Array.isArray(value)) return value.length > 0 ? [changed(value[0], by), ...value.slice(1)] : [by];
  const [[key, first], ...others] = Object.entries(value);
  return Object.fromEntries([[key, changed(first, by)], ...others]);
}

test("an answer with a changed number is not right: nearly right, or wrong", async () => {
  const answers = await answersOf(LIBRARIES[0].name);
  // Of curves the distance counts, and moved points can be near it.
  const without = [...NONE, "flatten", "offset", "circle", "classify", "continuity"];
  let judged = 0;
  for (const fact of FACTS.filter(({ kind }) => !without.includes(kind))) {
    const got = /** @type {any} */ (answers[fact.kind](fact.input, fact));
    const isTwice = new Set([fact.expect.t].flat()).size < fact.expect.t?.length; // then the order depends on the numbers
    if (got.overlap || fact.expect.count_exact === 0 || isTwice) continue;
    assert.equal(judge(changed(got, 0.01), fact).grade, "wrong", fact.id);
    if (fact.tol < 1e-5 && !JSON.stringify(got).includes("[]"))
      assert.equal(judge(changed(got, 1e-4), fact).grade, "close", fact.id);
    judged++;
  }
  assert.ok(judged > 300, `${judged}`);
});

test("what is judged as a curve: points far from it, missing ones, and no numbers", () => {
  const of = (/** @type {string} */ id) => /** @type {any} */ (FACTS.find((fact) => fact.id === id));
  const flat = of("flatten-07");
  const ends = [flat.input.points[0], flat.input.points.at(-1)];
  assert.equal(judge(ends, flat).grade, "wrong", "it does not reach where the curve turns back");
  assert.equal(judge([ends[0], ...flat.expect.must_reach, ends[1]], flat).grade, "right");
  const offset = of("offset-07");
  const points = offset.input.points.map(([x, y]) => [x, y + offset.input.distance]);
  assert.equal(judge([...points, [NaN, 0]], offset).grade, "wrong");
  assert.equal(judge([[0, 0]], offset).grade, "wrong");
  const overlap = of("intersect-61");
  assert.equal(judge({ t: [0], s: [0] }, overlap).grade, "wrong");
  assert.equal(judge({ overlap: true }, of("intersect-01")).grade, "wrong");
  assert.equal(judge(undefined, overlap).grade, "not offered");
  assert.equal(judge(null, of("bbox-01")).grade, "wrong");
  const { grade, got } = ask(
    {
      length: () => {
        throw new RangeError("no curve");
      },
    },
    of("length-01"),
  );
  assert.deepEqual([grade, got], ["wrong", "no curve"]);
});

test("sources that name an issue have its address", () => {
  assert.equal(issueOf("paperjs/paper.js#904 (angle 7.5e-5 rad)"), "https://github.com/paperjs/paper.js/issues/904");
  assert.equal(issueOf("lyon test_issue_19 / nical/lyon#19"), "https://github.com/nical/lyon/issues/19");
  assert.equal(issueOf("paperjs/paper.js test Curve #960: endpoints must be exact"), null);
  assert.ok(FACTS.filter(({ source }) => issueOf(source)).length >= 12);
});

test("answers as text", () => {
  assert.equal(
    textOf([
      [1, -2.5],
      [0.1 + 0.2, 1e-9],
    ]),
    "(1, −2.5), (0.3, 1e−9)",
  );
  assert.equal(textOf({ t: [], s: [0.5] }), "t: none; s: 0.5");
  assert.equal(textOf(Array.from({ length: 65 }, () => [0, 0])), "65 points");
  assert.equal(textOf(Array.from({ length: 99 }, (_, i) => i)).length, 90);
});
