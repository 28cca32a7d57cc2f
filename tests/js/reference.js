// What the tests of the package judge by: definitions, written out.
import assert from "node:assert/strict";

/** De Casteljau's algorithm on points as arrays. */
export function deCasteljau(points, t) {
  let row = points;
  while (row.length > 1) row = row.slice(1).map((p, i) => p.map((x, k) => row[i][k] * (1 - t) + x * t));
  return row[0];
}

/** The coordinates of an object or a flat array; a number alone. */
export function coordinates(/** @type {any} */ p) {
  if (typeof p === "number") return [p];
  return ArrayBuffer.isView(p) || Array.isArray(p) ? Array.from(/** @type {any} */ (p)) : Object.values(p);
}

/** Numbers agree to a small part of the larger one, or absolutely below 1. */
export function near(got, expected, tolerance = 1e-12, what = "") {
  const [a, b] = [coordinates(got), coordinates(expected)];
  assert.equal(a.length, b.length, `${what} ${a} instead of ${b}`);
  const off = (x, i) => Math.abs(x - b[i]) / Math.max(1, Math.abs(b[i]));
  assert.ok(
    a.every((x, i) => x === b[i] || off(x, i) <= tolerance),
    `${what} ${a} instead of ${b}`,
  );
}

/** Points of a flat array. */
export function pairs(flat, dimension = 2) {
  return Array.from({ length: flat.length / dimension }, (_, i) => [...flat.slice(i * dimension, (i + 1) * dimension)]);
}

/**
 * Points, or other rows of numbers, from a text: "0,0 1,2" is [[0, 0], [1, 2]].
 *
 * @param {string} text
 */
export const pointsOf = (text) => text.split(" ").map((point) => point.split(",").map(Number));

/** An array that lives in memory of its own: no view of the core's, nothing shared. */
export function owned(array) {
  assert.ok(array instanceof Float64Array);
  assert.equal(array.buffer.byteLength, array.byteLength);
}

/**
 * A value without its type, for arguments that are wrong on purpose.
 *
 * @param {unknown} value
 * @returns {any}
 */
export const untyped = (value) => value;

/** Expects a refusal whose message starts with the argument and names what was expected and what came. */
export function refused(act, type, message, what = `${act}`) {
  assert.throws(
    act,
    (/** @type {any} */ error) => {
      assert.equal(error.constructor, type, `${what}: ${error}`);
      assert.match(error.message, message, `${what}: ${error}`);
      assert.match(error.message, /expected .*got |expected .*needs /s, what);
      return true;
    },
    what,
  );
}

/** Expects all refusals of a table whose rows are calls and messages. */
export function refusedAll(type, rows) {
  for (const [act, message] of rows) refused(act, type, message);
}

/**
 * A drawing target that records the calls of its methods.
 *
 * @returns {any} in the place of a CanvasRenderingContext2D
 */
export function recorder() {
  const calls = [];
  const methods = ["moveTo", "lineTo", "quadraticCurveTo", "bezierCurveTo", "closePath"];
  const target = Object.fromEntries(methods.map((name) => [name, (...args) => calls.push([name, ...args])]));
  return Object.assign(target, { calls });
}

/** The answer of an action where `new Path2D()` gives this target. */
export function withPath2D(target, act) {
  const global = untyped(globalThis);
  global.Path2D = function Path2D() {
    return target;
  };
  try {
    return act();
  } finally {
    delete global.Path2D;
  }
}

export const CUBIC = pointsOf("0,0 0,8 8,8 8,0");
export const SPACE = pointsOf("0,0,0 1,2,3 3,3,-1 4,0,2");
/** (t, t², t³) */
export const TWISTED = pairs([0, 0, 0, 1 / 3, 0, 0, 2 / 3, 1 / 3, 0, 1, 1, 1], 3);
export const SEVEN = pointsOf("0,0 0,2 2,2 2,0 2,-4 4,-2 4,0");
