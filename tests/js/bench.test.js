// The benchmarks check that both sides give the same answers before they take times: this runs the checks.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { exponent } from "../../benches/js/table.js";
import { TARGETS } from "../../benches/js/targets.js";

const root = fileURLToPath(new URL("../../", import.meta.url));

/** @param {string[]} args */
const bench = (...args) => spawnSync(process.execPath, ["benches/js/run.js", ...args], { cwd: root, encoding: "utf8" });

test("all sides of the benchmarks give the same answers", () => {
  const { status, stdout, stderr } = bench("--quick");
  assert.equal(status, 0, stderr);
  for (const work of [
    "1,000 points",
    "eval(t)",
    "split(t)",
    "teapot, 16 segments",
    "teapot, 64 segments",
    "tolerance diagonal / 1000",
    "first call",
    "package",
    "32,000",
  ]) {
    assert.ok(stdout.includes(work), work);
  }
});

test("a part of a name chooses rows", () => {
  const { status, stdout, stderr } = bench("--quick", "split");
  assert.equal(status, 0, stderr);
  assert.match(stdout, /bezier-js split/);
  assert.doesNotMatch(stdout, /TeapotGeometry|first call|per vertex/);
});

test("each target belongs to a row", async () => {
  const modules = await Promise.all(
    ["curve", "easing", "intersect", "length", "nearest", "offset", "path", "regions", "teapot"].map(
      (name) => import(`../../benches/js/${name}.js`),
    ),
  );
  const ids = modules.flatMap(({ rows }) => rows).map(({ id }) => id);
  assert.equal(new Set(ids).size, ids.length);
  const other =
    /^(adaptive-(verb|triangles?)|growth-\w+|(eval|flatten|halve|intersect|length|nearest|offset|split|stroke|union)(-[\d.]+)?-(kurbo|lyon_geom|linesweeper|i_curve)(-segments)?|first-call|frame|size(-elements)?)$/;
  for (const id of Object.keys(TARGETS)) assert.ok(ids.includes(id) || other.test(id), id);
});

test("the exponent of costs per item that grow as a power of the size", () => {
  for (const p of [-0.3, 0, 0.5]) {
    const costs = [10, 100, 1000].map((size) => ({ size, ns: 7 * size ** p }));
    assert.ok(Math.abs(exponent(costs) - p) < 1e-12);
  }
});
