// The parts of the benchmarks that no quick run of a row shows.
import assert from "node:assert/strict";
import { test } from "node:test";
import { sizes } from "../../benches/js/start.js";

test("the rows of sizes are measured", () => {
  for (const { id, ours } of sizes()) assert.ok(ours > 10_000, `${id}: ${ours} bytes`);
});
