// Timing functions from and to CSS text, and their approximation by linear().
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { easing } from "casteljau/easing";
import { pointsOf, refused, refusedAll } from "./reference.js";

// tests/easing/css.rs reads the same table.
const table = JSON.parse(readFileSync(new URL("../texts/easing.json", import.meta.url), "utf8"));

test("every text of the table is read, evaluated and written", () => {
  for (const { text, css, values } of table.filter((row) => row.css)) {
    const ease = easing(text);
    assert.equal(ease.css, css, text);
    assert.equal(easing(css).css, css);
    for (const [x, y] of values) {
      const got = ease(x);
      assert.ok(Math.abs(got - y) <= 4e-16 * Math.max(1, Math.abs(y)), `${text} at ${x}: ${got}`);
    }
  }
});

test("every refused text of the table has its message and its offset", () => {
  for (const { text, error, offset } of table.filter((row) => row.error)) {
    assert.throws(
      () => easing(text),
      (/** @type {any} */ thrown) => {
        assert.equal(thrown.constructor, RangeError, text);
        assert.equal(thrown.message, error);
        assert.equal(thrown.offset, offset);
        return true;
      },
    );
  }
});

test("keywords are their cubic curves", () => {
  /** @type {Record<string, [number, number, number, number]>} */
  const curves = { ease: [0.25, 0.1, 0.25, 1], "ease-in": [0.42, 0, 1, 1], "ease-out": [0, 0, 0.58, 1] };
  for (const [word, handles] of Object.entries(curves))
    for (const x of [-0.5, 0.1, 0.5, 0.9, 1.5]) assert.equal(easing(word)(x), easing(...handles)(x));
});

/** The stops of a linear(), by an independent reading of what toLinear writes. */
function stopsOf(css) {
  const list = css === "linear" ? "0, 1" : css.match(/^linear\((.*)\)$/)[1];
  const parts = list.split(", ").map((part) => part.split(" ").map(Number.parseFloat));
  return parts.flatMap(([y, ...percentages], k) =>
    (percentages.length > 0 ? percentages : [k === 0 ? 0 : 100]).map((percentage) => [percentage / 100, y]),
  );
}

/** The greatest distance of a function from a polyline, found by sampling, with stops among the samples. */
function distance(ease, stops) {
  let greatest = 0;
  for (let k = 1; k < stops.length; k++) {
    const [[ax, ay], [bx, by]] = [stops[k - 1], stops[k]];
    for (let i = 0; i <= 400; i++) {
      const x = ax + ((bx - ax) * i) / 400;
      greatest = Math.max(greatest, Math.abs(ay + ((by - ay) * i) / 400 - ease(x)));
    }
  }
  return greatest;
}

const HANDLES = ["0.68, -0.55, 0.265, 1.55", "0, 1, 1, 0", "1, 0, 0, 1", "0, 1, 0, 1", "0.1, 7, 0.9, -6"];
const CURVES = ["ease", "ease-in-out", ...HANDLES.map((handles) => `cubic-bezier(${handles})`)];

test("toLinear keeps the tolerance and the ends", () => {
  for (const css of CURVES) {
    const ease = easing(css);
    for (const tolerance of [0.3, 0.1, 0.01, 0.001]) {
      const stops = stopsOf(ease.toLinear(tolerance));
      assert.deepEqual([stops[0], stops.at(-1)], pointsOf("0,0 1,1"), css);
      const error = distance(ease, stops);
      assert.ok(error <= tolerance * (1 + 1e-9), `${css}, ${tolerance}: ${error}`);
    }
  }
});

test("a parabola has the number of stops that is known in closed form", () => {
  // y = x²: a link that begins and ends on a boundary of the tolerance e has the width √(8e), the first and the last one
  // (1 + √2)√e.
  const square = easing(1 / 3, 0, 2 / 3, 1 / 3);
  for (const tolerance of [0.05, 0.02, 0.01, 0.003, 0.001, 0.0002]) {
    const links = (e) => 2 + Math.ceil((1 - 2 * (1 + Math.SQRT2) * Math.sqrt(e)) / Math.sqrt(8 * e));
    const count = stopsOf(square.toLinear(tolerance)).length - 1;
    assert.ok(count >= links(tolerance) && count <= links(0.96 * tolerance), `${tolerance}: ${count}`);
  }
});

/** tests/easing/css.rs has the same texts. */
const LINEARS = [
  "linear(0, 0.1 9%, 0.21 20%, 0.29 30%, 0.4 40%, 0.4 60%, 0.9 60%, 0.95 80%, 1.01 90%, 1)",
  "linear(-3, 0.5 10%, 100 20%, 120 30%, 180 70%, 200)",
  "linear(0.123456789, 0.2 10%, 0.5 50%, 0.987654321)",
];

test("a linear() loses the stops that the tolerance permits, and keeps its jumps and ends", () => {
  assert.equal(easing("linear(0, 0.2 10%, 1)").toLinear(0.5), "linear");
  assert.equal(easing("linear(0, 0.2 10%, 1)").toLinear(0.01), "linear(0, 0.2 10%, 1)");
  assert.equal(easing("linear(0.3, 0.5, 0.3 50%, 0.6 50%, 0.7)").toLinear(0.25), "linear(0.3 0% 50%, 0.6 50%, 0.7)");
  for (const css of LINEARS) {
    const ease = easing(css);
    const given = stopsOf(css);
    for (const tolerance of [0.1, 0.03].map((share) => share * Math.max(1, Math.abs(ease(1))))) {
      const text = ease.toLinear(tolerance);
      const stops = stopsOf(text);
      assert.deepEqual([stops[0], stops.at(-1)], [given[0], given.at(-1)], css);
      assert.ok(stops.length < given.length, `${css}, ${tolerance}: ${stops.length}`);
      const fewer = easing(text);
      for (let x = 0; x <= 1; x += 1 / 1024)
        assert.ok(Math.abs(fewer(x) - ease(x)) <= tolerance * (1 + 1e-9), `${css}, ${tolerance}, ${x}`);
    }
  }
  const many = easing.from((x) => x * x, { tolerance: 1e-4 });
  const few = stopsOf(many.toLinear(0.02)).length;
  assert.ok(few <= stopsOf(easing(1 / 3, 0, 2 / 3, 1 / 3).toLinear(0.019)).length, `${few}`);
});

test("a straight line takes two stops, steps remain as they are", () => {
  assert.equal(easing(0.3, 0.3, 0.7, 0.7).toLinear(0.0001), "linear");
  assert.equal(easing("steps(2)").toLinear(0.1), "linear(0 0% 50%, 0.5 50% 100%, 1)");
  assert.equal(easing("steps(2, start)").toLinear(0.1), "linear(0.5 0% 50%, 1 50% 100%)");
  for (const css of ["steps(5)", "steps(5, start)", "steps(5, jump-none)", "steps(5, jump-both)"]) {
    const [ease, same] = [easing(css), easing(easing(css).toLinear(0.1))];
    for (const x of [0, 0.1, 0.2, 0.3, 0.4, 0.59, 0.6, 0.7, 0.8, 0.99, 1])
      assert.equal(same(x), ease(x), `${css} ${x}`);
  }
});

test("toLinear writes the same text as Rust: tests/easing/css.rs has the same sum", () => {
  let sum = 0n;
  for (const css of [...CURVES, ...LINEARS])
    for (const tolerance of [0.1, 0.03, 0.001].map((share) => share * (css.includes("200") ? 200 : 1)))
      for (const byte of new TextEncoder().encode(easing(css).toLinear(tolerance)))
        sum = BigInt.asUintN(64, (sum << 7n) | (sum >> 57n)) ^ BigInt(byte);
  assert.equal(sum.toString(16), "8c1f008fd5388405");
});

test("percentages that are filled in ascend, though the range is a few ulps wide", () => {
  for (const [from, to, count] of pointsOf(
    "79.87344453458203,79.87344453458206,7 13.569893703974877,13.569893703974884,10",
  )) {
    const between = Array.from({ length: count - 1 }, (_, k) => k + 1);
    const { css } = easing(`linear(0 ${from}%, ${between.join(", ")}, ${count} ${to}%)`);
    const percentages = [...css.matchAll(/([\d.]+)%/g)].map((match) => Number(match[1]));
    assert.equal(percentages.length, count + 1);
    percentages.slice(1).forEach((value, k) => assert.ok(value >= percentages[k], css));
  }
});

test("never NaN, at the largest numbers either", () => {
  const texts = table.filter((row) => row.css).map((row) => row.text);
  const extreme = ["-1.7e308 -1.7e308%, 1.7e308 1.7e308%", "0, 1.7e308 5e-324%, 0", "1e308, -1e308"];
  for (const text of [...texts, ...extreme.map((stops) => `linear(${stops})`)])
    for (const x of [-Number.MAX_VALUE, -1, -5e-324, 0, 5e-324, 0.5, 1, 2, Number.MAX_VALUE])
      assert.ok(Number.isFinite(easing(text)(x)), `${text} at ${x}`);
  const huge = easing(0.1, 1e300, 0.9, -1e300);
  const scaled = stopsOf(huge.toLinear(1e298)).map(([x, y]) => [x, y / 1e300]);
  assert.ok(distance((x) => huge(x) / 1e300, scaled) <= 0.01);
});

test("refusals", () => {
  const untyped = /** @type {any} */ (easing);
  const ease = untyped("ease");
  refusedAll(TypeError, [
    [() => untyped(), /^easing: expected a text or 4 numbers, got undefined$/],
    [() => untyped(5), /^easing: expected a text or 4 numbers, got 5$/],
    [() => untyped(0, 0, 1, 1, 1), /^easing: expected a text or 4 numbers, got 5 arguments$/],
    [() => untyped(0, 0, 1), /^y2: expected a number, got undefined$/],
    [() => ease.toLinear(), /^tolerance: expected a number, got undefined$/],
  ]);
  refusedAll(RangeError, [
    [() => ease.toLinear(1e-5), /^tolerance: expected at least 0.0001 of the largest output, got 0.00001$/],
    [() => ease.toLinear(-1), /^tolerance: .*got -1$/],
    [() => ease.toLinear(NaN), /^tolerance: expected a finite number, got NaN$/],
    [() => easing("steps(40000)").toLinear(1), /^stops: expected at most 65536, this needs 80001$/],
  ]);
  for (const text of ["steps(4)", "linear(0, 1)"])
    refused(() => easing(text)(NaN), RangeError, /^x: expected a finite number, got NaN$/);
});
