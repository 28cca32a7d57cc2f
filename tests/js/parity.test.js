// The package gives what Rust gives: results of generated calls, as tests/generated/recorded.rs has written them to
// tests/data/results.txt (20 calls for each function).
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { Path, Surface } from "casteljau";
import { RationalSurface } from "casteljau/nurbs";
import { argumentsOf, GROUPS } from "./generated/calls.js";
import { generatorPath, lines, rowOf } from "./generated/generator.js";
import { pairs } from "./reference.js";

const SEED = 11;
/**
 * The largest distance of two numbers, relative to the largest number of the result, and near 0: the package is another
 * compilation.
 */
const [ROUNDING, TINY] = [1e-9, 1e-15];

const calls = Object.assign({}, ...GROUPS);
const path = generatorPath();

/** The recorded results by the names of Rust: the numbers of cases, and texts. @type {Map<string, [number, string][]>} */
const recorded = new Map();
const file = readFileSync(new URL("../data/results.txt", import.meta.url), "utf8");
for (const line of file.trimEnd().split("\n")) {
  const [, name, number, result] = /** @type {RegExpMatchArray} */ (line.match(/^(\S+) (\d+) (.*)$/));
  recorded.set(name, [...(recorded.get(name) ?? []), [Number(number), result]]);
}

/** The name of a function in JavaScript. @param {string} row its name in Rust */
function nameOf(row) {
  const letters = (name) => name.replace(/[^a-z0-9]/gi, "").toLowerCase();
  const name = Object.keys(calls).find((each) => letters(rowOf(each)) === letters(row));
  return name ?? assert.fail(`no call of ${row}`);
}

/** The fields that Rust has as well, in its order. */
const FIELDS = `curve error min max subpath patch area x y z xx xy yy start end center startAngle endAngle
  t u v uu uv vv u0 u1 v0 v1 t0 t1 polygonLength chordLength points ts knots rows column point distance corners tEnd uEnd
  c0 g1 c1 g2 c2 gap angle path inside gaussian mean k1 k2 positions normals uvs indices`.split(/\s+/);

/** All numbers of a result, in order. @param {any} value @returns {Iterable<number>} */
function* numbersOf(value) {
  if (typeof value === "number" || typeof value === "boolean") yield Number(value);
  if (typeof value !== "object" || value === null) return;
  if (ArrayBuffer.isView(value)) return yield* /** @type {any} */ (value);
  let parts = Array.isArray(value)
    ? value
    : FIELDS.flatMap((field) => (Object.hasOwn(value, field) ? [value[field]] : []));
  if (value instanceof Path) parts = [...value.subpaths];
  else if (value instanceof Surface) parts = [value.vertices];
  else if (value instanceof RationalSurface) parts = [value.vertices, ...value.weights()];
  else if (typeof value.controlPoints === "function") {
    const lists = ["controlPoints", "weights", "knots", "knotsU", "knotsV"].filter(
      (list) => typeof value[list] === "function",
    );
    parts = lists.map((list) => value[list]());
  }
  for (const part of parts) yield* numbersOf(part);
}

const frames = ({ points, tangents, normals, binormals }, { segments, ts }) => {
  const vectors = [points, tangents, normals, binormals].map((flat) => pairs(flat, 3));
  return vectors[0].map((_, k) => [ts ? ts[k] : k / segments, vectors.map((each) => each[k])]);
};
const ofAxis = (extrema, { axis }) => {
  if (!extrema["xyz"[axis]]) throw new RangeError(`axis: expected one of the curve, got ${axis}`);
  return extrema["xyz"[axis]];
};
/** What Rust returns in another form. */
const AS_IN_RUST = {
  "Curve.extrema": ofAxis,
  "RationalCurve.extrema": ofAxis,
  "NurbsCurve.extrema": ofAxis,
  "NurbsCurve.removeKnot": ({ curve, error }) => [curve, error],
  "Curve.frames": frames,
  "Curve.framesAt": frames,
  "Spline.frames": frames,
  "Spline.framesAt": frames,
  "Patch.nearest": (found) => [0, found],
  "Patch.intersectRay": (hits) => hits.map((hit) => [0, hit]),
};

/** The numbers that the file has of a result, and the largest one. */
function written(numbers) {
  const largest = numbers.reduce((max, x) => Math.max(max, Math.abs(x)), 0);
  const weight = (k) => (k * 0.618033988749895) % 1;
  const shown = numbers.length > 8 ? [numbers.reduce((sum, x, k) => sum + weight(k) * x, 0)] : numbers;
  return { count: numbers.length, shown, largest };
}

function compare(name, { arguments: given }, result) {
  const values = argumentsOf(given);
  const act = () => (AS_IN_RUST[name] ?? ((answer) => answer))(calls[name](values), values);
  if (result === "refused") return assert.throws(act, /^(RangeError|TypeError): .*expected/s);
  const { count, shown, largest } = written([...numbersOf(act())]);
  const [expected, ...numbers] = result.replaceAll("inf", "Infinity").split(" ").map(Number);
  assert.equal(count, expected, "the count of numbers");
  for (const [k, x] of shown.entries()) {
    const isNear = Object.is(x + 0, numbers[k] + 0) || Math.abs(x - numbers[k]) <= Math.max(ROUNDING * largest, TINY);
    assert.ok(isNear, `${x} instead of ${numbers[k]}, number ${k} of ${count}`);
  }
}

for (const [rust, results] of recorded) {
  const name = nameOf(rust);
  test(name, () => {
    const [last] = /** @type {[number, string]} */ (results.at(-1));
    const cases = lines(path, SEED, rust, 0, last + 1);
    for (const [number, result] of results) {
      try {
        compare(name, JSON.parse(cases[number]), result);
      } catch (/** @type {any} */ error) {
        // Rust refuses this mode only at joints that change.
        if (name === "Spline.movePoint" && /expected a 2D spline for "g2"/.test(error.message)) continue;
        const [call] = lines(path, SEED, rust, number, 1, "--javascript");
        throw new Error(`${error.message}\n  case ${number}: ${call}`);
      }
    }
  });
}
