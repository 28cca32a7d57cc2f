// The arena's view, from the sources: it is no part of the public interface.
import assert from "node:assert/strict";
import { test } from "node:test";
import { curvesModule } from "#js/wasm/curves-module.js";

test("the view is long enough and stays the same", () => {
  const view = curvesModule.arena(8);
  assert.ok(view.length >= 8);
  assert.equal(curvesModule.arena(8), view);
  assert.equal(curvesModule.arena(view.length), view);
  assert.equal(view.length, curvesModule.functions.arena_length());
});

test("a longer view keeps the contents", () => {
  const view = curvesModule.arena(8);
  view.set([1, 2, 3]);
  const longer = curvesModule.arena(view.length + 1);
  assert.notEqual(longer, view);
  assert.deepEqual([...longer.subarray(0, 3)], [1, 2, 3]);
});

test("a view that memory growth emptied is replaced", () => {
  const view = curvesModule.arena(8);
  view[0] = 42;
  curvesModule.memory.grow(1);
  assert.equal(view.length, 0);
  assert.equal(curvesModule.arena(8)[0], 42);
});

test("after trimming a new view is handed out", () => {
  const large = curvesModule.arena(1_000_000);
  large[0] = 7;
  curvesModule.trim();
  const view = curvesModule.arena(8);
  assert.notEqual(view, large);
  assert.ok(view.length < large.length);
  assert.equal(view[0], 7);
});
