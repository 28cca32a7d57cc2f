// Numbers below the picture of <bezier-surface>.
import assert from "node:assert/strict";
import { test } from "node:test";
import { twoDigits, upperBound } from "#js/elements/surface/words.js";

test("an upper bound with two twoDigits is rounded up", () => {
  assert.deepEqual([0.105, 0.0921, 0.1, 0.0999, 12.01, 0].map(upperBound), ["0.11", "0.093", "0.1", "0.1", "13", "0"]);
  for (let x = 1e-4; x < 100; x *= 1.0371) assert.ok(Number(upperBound(x)) >= x, String(x));
  assert.equal(twoDigits(0.105), "0.1", "what is no bound is rounded to the nearest");
});
