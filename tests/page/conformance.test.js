// /conformance/: the facts are asked in the browser, this package first, the others when the reader wants it.
import assert from "node:assert/strict";
import { test } from "node:test";
import { LIBRARIES } from "../../www/conformance/libraries.js";
import { assertAccessible } from "./browser.js";
import { openStrict } from "./site-pages.js";

/** The facts: 116 about curves, 231 about rational ones; four of them are about what the package does not have. */
const [COUNT, WITHOUT] = [347, 4];
const PHONE = { viewport: { width: 360, height: 740 }, deviceScaleFactor: 2, hasTouch: true, isMobile: true };

/** The numbers of a row of the table at the top. @param {import("playwright-core").Page} page @param {string} library */
const totals = (page, library) => page.locator(`#totals [data-library="${library}"] td`).allInnerTexts();

/** The large scripts that the page and its workers have loaded. */
const scripts = (page) =>
  page.evaluate(() =>
    performance
      .getEntriesByType("resource")
      .map(({ name }) => name)
      .join(" "),
  );

test("this package is asked at once, the others after a click; the numbers add up", async (t) => {
  const page = await openStrict(t, "/conformance/", { colorScheme: "light" });
  const asked = (/** @type {string} */ which) =>
    page.waitForFunction((which) => document.documentElement.dataset.asked === which, which, { timeout: 120_000 });
  await asked("casteljau");
  assert.deepEqual(await totals(page, "casteljau"), [`${COUNT - WITHOUT}`, "0", "0", `${WITHOUT}`]);
  assert.deepEqual(await totals(page, "paper.js"), ["", "", "", ""]);
  assert.doesNotMatch(await scripts(page), /paper|verb/);
  await page.getByRole("button", { name: "Ask the other libraries" }).click();
  await asked("all");
  for (const { name } of LIBRARIES) {
    const numbers = (await totals(page, name)).map(Number);
    assert.equal(
      numbers.reduce((sum, each) => sum + each, 0),
      COUNT,
      `${name}: ${numbers}`,
    );
    assert.ok(numbers[0] >= 5, `${name}: ${numbers}`);
  }
  const kind = page.locator('details[data-kind="length"]');
  await kind.locator("summary").click();
  assert.match(await kind.innerText(), /^Arc length 9 facts right: casteljau 9 of 9, bezier-js \d of 9/);
  const row = kind.locator('[data-fact="length-07"]');
  assert.equal(await row.getByRole("link").getAttribute("href"), "https://github.com/fonttools/fonttools/issues/3514");
  assert.match(await row.innerText(), /27\.0615951639 ± 1e−9/);
  assert.match(await row.locator('[data-library="casteljau"]').innerText(), /^✓ right\n27\.0615951639$/);
  assert.match(await row.locator('[data-library="paper.js"]').innerText(), /^✗ wrong, off by 0\.033\n/);
  await page.locator("details[data-kind]").evaluateAll((all) => all.forEach((each) => each.setAttribute("open", "")));
  await assertAccessible(page);
  await page.emulateMedia({ colorScheme: "dark" });
  await assertAccessible(page);
});

test("on a phone the tables scroll, and the page does not", async (t) => {
  const page = await openStrict(t, "/conformance/", PHONE);
  await page.locator('details[data-kind="intersect"] summary').click();
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 360);
});

test("the licences of the libraries are there", async (t) => {
  const page = await openStrict(t, "/conformance/");
  const text = await page.evaluate(async () => (await fetch("licenses.txt")).text());
  for (const { packageName } of LIBRARIES.slice(1)) assert.match(text, new RegExp(`^${packageName} \\d`, "m"));
  assert.match(text, /Copyright \(c\) Pomax/);
});
