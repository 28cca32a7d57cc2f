// The filter of the API reference: by name while typing, by keyboard; without scripts the page is the plain list.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openPage } from "./browser.js";
import { openStrict } from "./site-pages.js";

/** @param {import("playwright-core").Page} page */
const visibleNames = (page) =>
  page.locator("[data-name]:visible").evaluateAll((all) => all.map((element) => element.dataset.name));

test("the list of all names is filtered while typing, and the count is announced", async (t) => {
  const page = await openStrict(t, "/api/");
  const [field, status] = [page.getByRole("searchbox", { name: "Filter" }), page.locator(".filter [role=status]")];
  const all = await visibleNames(page);
  assert.equal(await status.innerText(), `${all.length} entries`);
  await field.fill("NEAR");
  const near = await visibleNames(page);
  assert.ok(near.includes("Curve nearest") && near.includes("Types and options Nearest"));
  assert.ok(near.every((name) => /near/i.test(String(name))) && near.length < all.length / 10);
  assert.equal(await status.innerText(), `${near.length} entries`);
  assert.deepEqual(
    await page.locator(".contents li:visible, main > section:visible").count(),
    2 * new Set(await sections(page)).size,
  );
  await field.fill("Path.union(");
  assert.deepEqual(await visibleNames(page), ["Path union"]);
  assert.equal(await status.innerText(), "1 entry");
  await field.fill("no such name");
  assert.equal(await status.innerText(), "No entries");
  await field.fill("");
  assert.deepEqual(await visibleNames(page), all);
});

const sections = (/** @type {import("playwright-core").Page} */ page) =>
  page.locator("[data-name]:visible").evaluateAll((all) => all.map((element) => element.closest("section")?.id));

test("arrow keys go through the entries found, and Enter in the field opens the first", async (t) => {
  const page = await openStrict(t, "/api/");
  const field = page.getByRole("searchbox", { name: "Filter" });
  await field.fill("spline length");
  const focused = () => page.evaluate(() => document.activeElement?.textContent);
  const names = (await visibleNames(page)).map((name) => String(name).replace("Spline ", ""));
  assert.ok(names.length > 1);
  await field.press("ArrowDown");
  assert.equal(await focused(), names[0]);
  await page.keyboard.press("ArrowDown");
  assert.equal(await focused(), names[1]);
  for (const key of ["ArrowUp", "ArrowUp"]) await page.keyboard.press(key);
  assert.equal(await page.evaluate(() => document.activeElement?.id), "filter");
  await field.press("Enter");
  await page.waitForURL(`**/api/spline/#${names[0]}`);
});

test("the page of a class is filtered, too; an address shows an entry that the filter hides", async (t) => {
  const page = await openStrict(t, "/api/mesh/");
  const field = page.getByRole("searchbox", { name: "Filter" });
  await field.fill("to");
  assert.deepEqual(
    (await visibleNames(page)).filter((name) => !/to(GLB|OBJ|STL|Three)|constructor/.test(String(name))),
    [],
  );
  assert.equal(await page.locator(".entry:visible").count(), await page.locator(".contents li:visible").count());
  await page.evaluate(() => (location.hash = "#indices"));
  await page.locator("#indices:visible").waitFor();
  assert.equal(await field.inputValue(), "");
});

test("without scripts there is no field, and the list is complete", async (t) => {
  const page = await openPage(t, "/api/", { javaScriptEnabled: false });
  assert.equal(await page.getByRole("searchbox").count(), 0);
  assert.ok(await page.getByRole("link", { name: "removeOverlaps" }).isVisible());
});
