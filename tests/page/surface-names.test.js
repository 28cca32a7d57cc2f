// The layer "names" of <bezier-surface>: names stand at their points, and the steps of the evaluation.
import assert from "node:assert/strict";
import { test } from "node:test";
import { boxOf } from "./browser.js";
import { openSurface, set, settled } from "./surface-page.js";

const SUBSCRIPTED = /^P\d\d$/;

/** The names in the picture and where they are. */
const names = (page) =>
  page.locator("bezier-surface .names text").evaluateAll((all) =>
    all.map((text) => {
      const { left, bottom } = text.getBoundingClientRect();
      return { text: text.textContent, role: text.getAttribute("class"), left, bottom };
    }),
  );

test("control points are named P_ij, where i counts along u, and names stand beside their handles", async (t) => {
  const page = await openSurface(t, 'model="patch" show="surface net names"');
  await settled(page);
  const points = (await names(page)).filter(({ role }) => role === "point");
  assert.deepEqual(
    points.slice(0, 6).map(({ text }) => text),
    ["P00", "P10", "P20", "P30", "P01", "P11"],
  );
  assert.equal(points.filter(({ text }) => SUBSCRIPTED.test(text ?? "")).length, 16);
  for (const [index, name] of [
    [3, "P30"],
    [12, "P03"],
    [15, "P33"],
  ]) {
    const handle = page.locator(`bezier-surface .handle[data-index="${index}"]`);
    assert.match((await handle.getAttribute("aria-label")) ?? "", new RegExp(`^${name}: x `));
    const { x, y, width, height } = await boxOf(handle);
    const { left, bottom } = points[Number(index)];
    assert.ok(Math.abs(left - (x + width / 2)) < 20, `${name}: ${left} and ${x + width / 2}`);
    assert.ok(Math.abs(bottom - (y + height / 2)) < 20, `${name}: ${bottom} and ${y + height / 2}`);
  }
  assert.deepEqual(
    (await names(page)).filter(({ role }) => role === "axis").map(({ text }) => text),
    ["", "u", "", "v"],
  );
  await set(page, { show: "surface net" });
  assert.equal((await names(page)).length, 0);
});

test("the derivatives and the normal are named, and names follow u, v and the view", async (t) => {
  const page = await openSurface(t, 'model="patch" show="surface derivatives names" u="0.6" v="0.3"');
  await settled(page);
  const before = await names(page);
  assert.deepEqual(
    before.map(({ text }) => text),
    ["Su", "Sv", "N"],
  );
  await set(page, { u: 0.2 });
  await settled(page);
  const moved = await names(page);
  await page.evaluate(() => (document.querySelector("bezier-surface").view = { turn: 40 }));
  await settled(page);
  const turned = await names(page);
  for (const [a, b] of [
    [before, moved],
    [moved, turned],
  ])
    assert.ok(
      a.every(({ left, bottom }, k) => Math.hypot(left - b[k].left, bottom - b[k].bottom) > 1),
      JSON.stringify([a, b]),
    );
});

test("where a derivative is zero it has no name", async (t) => {
  const page = await openSurface(t, 'model="teapot" patch="20" show="surface derivatives names" u="0.5" v="0"');
  await settled(page);
  assert.deepEqual(
    (await names(page)).map(({ text }) => text),
    ["Sv", "N"],
  );
});
