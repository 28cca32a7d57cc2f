// Results outlive what comes after them, and large ones do not fill the memory: from the sources, to see the memory.
import assert from "node:assert/strict";
import { test } from "node:test";
import { setFlagsFromString } from "node:v8";
import { runInNewContext } from "node:vm";
import { curvesModule } from "#js/wasm/curves-module.js";
import { Curve, Path, Spline } from "#js/index.js";
import { CUBIC, deCasteljau, near, SEVEN } from "./reference.js";

const cubic = new Curve(CUBIC);
const MIB = 2 ** 20;

// First, while no other test has made room.
test("the memory of a large result serves what comes next", () => {
  const samples = cubic.sample(5_000_000);
  const before = curvesModule.memory.buffer.byteLength;
  const { ts } = cubic.flatten(1e-11);
  assert.ok(ts.length > 500_000 && samples.length > 1e7);
  assert.equal(curvesModule.memory.buffer.byteLength, before);
});

test("results stay what they were while the memory grows", () => {
  const kept = () => [
    cubic.sample(100),
    cubic.evalAt([0, 0.3]),
    cubic.flatten(0.001).points,
    cubic.flatten(0.001).ts,
    cubic.hull(),
    cubic.controlPoints(),
    ...cubic.deCasteljau(0.4),
    new Spline(SEVEN).sample(50),
    cubic.subdivide(0.01).curve.controlPoints(),
  ];
  const results = kept();
  const copies = results.map((result) => [...result]);
  const before = curvesModule.memory.buffer;
  cubic.sample(3_000_000);
  cubic.flatten(1e-9);
  curvesModule.memory.grow(7);
  assert.notEqual(curvesModule.memory.buffer, before);
  results.forEach((result, i) => assert.deepEqual([...result], copies[i]));
  kept().forEach((result, i) => assert.deepEqual([...result], copies[i]));
});

test("ten million numbers, again and again", () => {
  const segments = 5_000_000;
  const check = (samples) => {
    assert.equal(samples.length, 2 * segments + 2);
    for (const i of [0, 1, 1_234_567, segments])
      near(samples.subarray(2 * i, 2 * i + 2), deCasteljau(CUBIC, i / segments));
  };
  check(cubic.sample(segments));
  const once = curvesModule.memory.buffer.byteLength;
  const into = new Float64Array(2 * segments + 2);
  for (let round = 0; round < 3; round++) {
    check(cubic.sample(segments));
    check(cubic.sample(segments, { into }));
  }
  // Memory never shrinks, but what was given back is used again.
  assert.ok(
    curvesModule.memory.buffer.byteLength <= once + MIB,
    `${once} grew to ${curvesModule.memory.buffer.byteLength}`,
  );
  assert.deepEqual(cubic.eval(0.5), { x: 4, y: 6 });
});

test("large arguments come through, and their room is used again", () => {
  const ts = Float64Array.from({ length: 2_000_000 }, (_, i) => i / 2_000_000);
  const check = (points) => near(points.subarray(2e6, 2e6 + 2), deCasteljau(CUBIC, 0.5));
  check(cubic.evalAt(ts));
  const once = curvesModule.memory.buffer.byteLength;
  for (let round = 0; round < 5; round++) check(cubic.evalAt(ts));
  assert.ok(curvesModule.memory.buffer.byteLength <= once + MIB);
});

/** Repeats an action; after a hundred times the memory does not grow any more. Gives its size. */
function repeated(act) {
  for (let i = 0; i < 100; i++) act();
  const before = curvesModule.memory.buffer.byteLength;
  for (let i = 0; i < 20_000; i++) act();
  assert.equal(curvesModule.memory.buffer.byteLength, before);
  return before;
}

test("many small calls need no more memory", () => {
  const act = () => {
    const [left] = cubic.split(0.3);
    const moved = new Spline(SEVEN).movePoint(3, [1, 1], { joints: { 1: "c1" } });
    return [moved.insert(0.5).flatten(0.01), left.elevate().bounds()];
  };
  repeated(act);
});

test("many refusals need no more memory", () => {
  const before = repeated(() => assert.throws(() => cubic.flatten(1e-16), RangeError));
  for (let i = 0; i < 3; i++) assert.throws(() => cubic.sample(2 ** 26), RangeError);
  assert.equal(curvesModule.memory.buffer.byteLength, before);
});

/** The bytes of JavaScript's values that are still used, and of the core's memory. */
function usedBytes() {
  setFlagsFromString("--expose-gc");
  runInNewContext("gc")();
  const { heapUsed, arrayBuffers } = process.memoryUsage();
  return { values: heapUsed + arrayBuffers, core: curvesModule.memory.buffer.byteLength };
}

test("what paths keep for repeated questions goes with them", () => {
  const wave = Array.from({ length: 400 }, (_, k) => [k, k % 2, k + 0.5, -(k % 3)]).flat();
  const ask = (rounds) => {
    for (let k = 0; k < rounds; k++) {
      const path = Path.from(Spline.interpolate(wave.map((x) => x + k)));
      for (let s = 0; s < 4; s++) {
        assert.ok(path.pointAtLength(s) && path.nearest([s, s]) && path.bounds());
        path.contains([s, 0.5]);
      }
    }
  };
  ask(200);
  const before = usedBytes();
  ask(process.env.CASTELJAU_DEEP ? 20_000 : 600);
  const after = usedBytes();
  assert.ok(after.core <= before.core, `the memory of the core grew by ${after.core - before.core}`);
  // One path keeps some 40 kB; what else is used changes by a few MiB.
  assert.ok(after.values <= before.values + 8 * MIB, `${before.values} grew to ${after.values}`);
});
