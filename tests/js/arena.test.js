// The arena's view, from the sources: it is no part of the public interface.
import assert from "node:assert/strict";
import { test } from "node:test";
import { arena, trimArena } from "#js/wasm/arena.js";
import { core, memory } from "#js/wasm/init.js";

test("the view is long enough and stays the same", () => {
  const view = arena(8);
  assert.ok(view.length >= 8);
  assert.equal(arena(8), view);
  assert.equal(arena(view.length), view);
  assert.equal(view.length, core().arena_length());
});

test("a longer view keeps the contents", () => {
  const view = arena(8);
  view.set([1, 2, 3]);
  const longer = arena(view.length + 1);
  assert.notEqual(longer, view);
  assert.deepEqual([...longer.subarray(0, 3)], [1, 2, 3]);
});

test("a view that memory growth emptied is replaced", () => {
  const view = arena(8);
  view[0] = 42;
  memory().grow(1);
  assert.equal(view.length, 0);
  assert.equal(arena(8)[0], 42);
});

test("after trimming a new view is handed out", () => {
  const large = arena(1_000_000);
  large[0] = 7;
  trimArena();
  const view = arena(8);
  assert.notEqual(view, large);
  assert.ok(view.length < large.length);
  assert.equal(view[0], 7);
});
