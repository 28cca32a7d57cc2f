// The grids of pictures of /recipes/ and /figures/: drawn by the build, a link to each section, one column on a phone.
import assert from "node:assert/strict";
import { test } from "node:test";
import { boxOf, openPage } from "./browser.js";

for (const [path, part, count] of /** @type {const} */ ([
  ["/recipes/", "figure[data-recipe]", 15],
  ["/figures/", "main > section > :not(h2)", 26],
])) {
  test(`${path} begins with a picture for each section, without scripts, too`, async (t) => {
    const page = await openPage(t, path, { javaScriptEnabled: false, viewport: { width: 1280, height: 800 } });
    const cards = page.locator(".gallery a");
    assert.equal(await page.locator(part).count(), count);
    assert.equal(await cards.count(), count);
    for (const card of await cards.all()) {
      const title = await card.locator("> span").innerText();
      assert.ok((await card.locator("svg :is(path, rect, circle, text)").count()) > 0, title);
      const target = page.locator(String(await card.getAttribute("href")));
      assert.ok((await target.locator("h2").innerText()).startsWith(title), title);
    }
    const [first, second] = [await boxOf(cards.nth(0)), await boxOf(cards.nth(1))];
    assert.ok(Math.abs(first.y - second.y) < 1 && first.width < 400, "several columns");
    await page.setViewportSize({ width: 360, height: 740 });
    const [above, below] = [await boxOf(cards.nth(0)), await boxOf(cards.nth(1))];
    assert.ok(below.y >= above.y + above.height && above.width > 300, "one column");
  });
}

test("a recipe has its code at the right of its picture, no higher than what stands at the left", async (t) => {
  const page = await openPage(t, "/recipes/", { viewport: { width: 1280, height: 800 } });
  const section = page.locator("#camera-flight");
  const [picture, code] = [await boxOf(section.locator("figure")), await boxOf(section.locator("> pre"))];
  assert.ok(code.x >= picture.x + picture.width && Math.abs(code.y - picture.y) < 1);
  const { bottom } = await section.evaluate((element) => element.getBoundingClientRect());
  assert.ok(code.height > 200);
  const end = await section.evaluate((element) => element.querySelector("pre").getBoundingClientRect().bottom);
  assert.ok(end <= bottom + 1, `${end} and ${bottom}`);
});
