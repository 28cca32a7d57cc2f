// easing(): the same bits as the core, the border, speed left to the benchmarks.
import assert from "node:assert/strict";
import { test } from "node:test";
import { easing } from "casteljau";
import { pointsOf } from "./reference.js";

/** SplitMix64, as in tests/common/mod.rs. */
function random(seed) {
  let state = BigInt(seed);
  const wrap = (n) => BigInt.asUintN(64, n);
  return () => {
    state = wrap(state + 0x9e3779b97f4a7c15n);
    let z = state;
    z = wrap((z ^ (z >> 30n)) * 0xbf58476d1ce4e5b9n);
    z = wrap((z ^ (z >> 27n)) * 0x94d049bb133111ebn);
    return Number((z ^ (z >> 31n)) >> 11n) / 2 ** 53;
  };
}

/** KNOWN of tests/easing/mod.rs. @type {any[]} */
const KNOWN = [
  ...pointsOf("0.25,0.1,0.25,1 0.42,0,1,1 0,0,0.58,1 0.42,0,0.58,1 0.68,-0.55,0.265,1.55 1,0,0,1 1,1,0,0 0,1,1,0"),
  ...pointsOf("0,0,0,1 0,1,0,1 1,0,1,0 1,0,1,1 0.999999999,0.1,1e-9,0.7 1e-300,0.5,1e-310,0.5"),
  [1 - 2 ** -52, 0, 2 ** -52, 1],
  [1 / 3, 0.2, 2 / 3, 0.9],
];

test("the same bits as in Rust: tests/easing/mod.rs has the same cases and the same sum", () => {
  const unit = random(95);
  const signed = () => 2 * unit() - 1;
  const bits = new BigUint64Array(1);
  const number = new Float64Array(bits.buffer);
  let sum = 0n;
  const add = (y) => {
    number[0] = y;
    sum = BigInt.asUintN(64, (sum << 7n) | (sum >> 57n)) ^ bits[0];
  };
  for (let i = 0; i < 500; i++) {
    const ease = easing(unit(), 3 * signed(), unit(), 3 * signed());
    for (let k = 0; k < 8; k++) add(ease(1.5 * unit() - 0.25));
  }
  for (const [x1, y1, x2, y2] of KNOWN) {
    const ease = easing(x1, y1, x2, y2);
    for (let k = 0; k < 64; k++) add(ease(k / 63));
  }
  assert.equal(sum.toString(16), "5611b4667573a859");
});

test("exact at the ends, on the diagonal, and of known values", () => {
  for (const [x1, y1, x2, y2] of KNOWN) assert.deepEqual([0, -0, 1].map(easing(x1, y1, x2, y2)), [0, 0, 1]);
  assert.equal(easing(0.3, 0.3, 0.8, 0.8)(0.123), 0.123);
  assert.equal(easing(0, 0, 1, 0.5)(0.5), 0.3125);
  assert.ok(Math.abs(easing(0.25, 0.1, 0.25, 1)(0.75) - 0.9604589783489741) < 3e-16);
  assert.ok(Math.abs(easing(1, 0, 0, 1)(0.4999) - 0.4561897339268086) < 3e-16);
});

test("beyond the ends along the tangents, as CSS has it", () => {
  assert.equal(easing(0.25, 0.5, 0.5, 0.5)(-1), -2);
  assert.equal(easing(0.25, 0.5, 0.5, 0.5)(2), 2);
  assert.equal(easing(0, 0.5, 0.5, 1)(-1), 0);
  assert.equal(easing(0, 0, 0.5, 1)(-1), -2);
  for (const [x1, y1, x2, y2] of KNOWN) {
    const extremes = [-Number.MAX_VALUE, -5e-324, 5e-324, Number.MAX_VALUE].map(easing(x1, y1, x2, y2));
    assert.ok(extremes.every(Number.isFinite), `${[x1, y1, x2, y2]}`);
  }
  assert.ok(Number.isFinite(easing(0.5, Number.MAX_VALUE, 0.5, -Number.MAX_VALUE)(0.3)));
});
