// /benchmarks/: every comparison of benches/results.json is in the table of its library, and it fits on a phone.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { boxOf, root } from "./browser.js";
import { openStrict } from "./site-pages.js";

const { rows } = JSON.parse(readFileSync(`${root}benches/results.json`, "utf8"));
const compared = rows.filter(({ peer }) => peer);

test("each library has a table: common work first, questions asked again last, other leaders in words", async (t) => {
  const page = await openStrict(t, "/benchmarks/");
  const tables = await page.locator("table.compared").evaluateAll((all) =>
    all.map((table) => ({
      name: table.querySelector("thead th:nth-child(2)").textContent,
      rows: [...table.querySelectorAll("tbody tr")].map((row) => [...row.children].map((cell) => cell.textContent)),
    })),
  );
  assert.equal(tables.flatMap((table) => table.rows).length, compared.length);
  assert.deepEqual(
    tables.slice(0, 2).map(({ name }) => name),
    ["bezier-js", "paper.js"],
  );
  assert.match(tables[0].rows[0][0], /^eval/);
  const again = tables[1].rows.map(([work]) => /again/.test(work));
  assert.ok(again.includes(true) && again.indexOf(true) > again.length / 2, `${again}`);
  const shown = tables.flatMap((table) => table.rows.map((row) => row[3]));
  const slower = compared.filter(({ ratio }) => ratio !== null && 1 / ratio >= 1.05);
  assert.equal(shown.filter((text) => /^[\d.]+× (slower|more)$/.test(text)).length, slower.length);
  assert.ok(slower.length > 5);
});

test("numbers are right-aligned; on a phone three of them stand below the work", async (t) => {
  const page = await openStrict(t, "/benchmarks/", { viewport: { width: 1280, height: 800 } });
  const row = page.locator("table.compared tbody tr").first();
  const boxes = async () => {
    const [work, theirs, ours, ratio] = await Promise.all((await row.locator("th, td").all()).map(boxOf));
    return { work, theirs, ours, ratio };
  };
  const wide = await boxes();
  assert.ok(wide.theirs.x >= wide.work.x + wide.work.width && Math.abs(wide.theirs.y - wide.work.y) < 4);
  const align = await row.locator("td").evaluateAll((cells) => cells.map((cell) => getComputedStyle(cell).textAlign));
  assert.deepEqual(align, ["end", "end", "end"]);
  await page.setViewportSize({ width: 360, height: 740 });
  const narrow = await boxes();
  const bottom = narrow.work.y + narrow.work.height;
  for (const box of [narrow.theirs, narrow.ours, narrow.ratio]) assert.ok(box.y >= bottom, `${box.y} and ${bottom}`);
  assert.ok(narrow.theirs.x < narrow.ours.x && narrow.ours.x < narrow.ratio.x);
});
