// A curve that is evaluated again and again lies in the arena; nothing that happens in between may show.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Patch, Spline, Surface } from "../../dist/index.js";

const line = new Curve([[0, 0], [2, 4]]);
const arch = new Curve([[0, 0], [0, 4], [4, 4], [4, 0]]);
const space = new Curve([[0, 0, 0], [2, 4, 6]]);

/** Everything that writes to the arena, by another way each. */
const between = {
  "another curve": () => space.eval(0.5),
  "a large result": () => arch.sample(200_000),
  "a trimmed arena": () => arch.sample(2_000_000),
  "a static": () => Curve.bernstein(64, 0.3),
  "a basis": () => Curve.basisMatrix("hermite"),
  "a spline": () => new Spline([[9, 9], [8, 8], [7, 7], [6, 6]]).eval(0.5),
  "a patch": () => new Patch(new Array(16).fill([1, 2, 3])).eval(0.5, 0.5),
  "a surface": () => Surface.teapot().grid({ segments: 2 }),
  "a refusal": () => assert.throws(() => arch.flatten(1e-300), RangeError),
};

for (const [name, act] of Object.entries(between)) {
  test(`eval after ${name}`, () => {
    assert.deepEqual(line.eval(0.5), { x: 1, y: 2 });
    act();
    assert.deepEqual(line.eval(0.25), { x: 0.5, y: 1 });
    assert.deepEqual(line.eval(0.75), { x: 1.5, y: 3 });
    act();
    assert.deepEqual(arch.eval(0.5), { x: 2, y: 3 });
    assert.deepEqual(space.eval(0.5), { x: 1, y: 2, z: 3 });
  });
}
