// What goes through the clipboard. All pages of a browser have the same one, so these tests share a file: they run in turn.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { openPage, root } from "./browser.js";
import { on, openCompanions } from "./companions-page.js";

const permissions = ["clipboard-read", "clipboard-write"];

test("Run prints what the tests expect; Copy copies what is shown", async (t) => {
  const page = await openPage(t, "/curves/parameter/", {
    viewport: { width: 1000, height: 900 },
    reducedMotion: "reduce",
    permissions,
  });
  const sample = page.locator("lesson-sample").first();
  const name = await sample.getAttribute("name");
  await sample.getByRole("button", { name: "Run" }).click();
  await sample.locator("output:not(:empty)").waitFor();
  assert.equal(
    await sample.locator("output").textContent(),
    readFileSync(`${root}www/samples/${name}.txt`, "utf8").trimEnd(),
  );
  const button = sample.getByRole("button", { name: "Copy" });
  const said = await button.evaluateHandle((copy) => ({
    next: new Promise((resolve) =>
      new MutationObserver(() => resolve(copy.textContent)).observe(copy, { childList: true }),
    ),
  }));
  await button.click();
  assert.equal(await said.evaluate(({ next }) => next), "Copied"); // for two seconds
  const copied = await page.evaluate(() => navigator.clipboard.readText());
  assert.equal(copied, `${await sample.locator("pre:not([hidden])").textContent()}\n`);
});

test("a real paste of what is no number leaves the field as it was", async (t) => {
  const page = await openCompanions(t, "<bezier-coordinates></bezier-coordinates>", { permissions });
  await page.evaluate(() => navigator.clipboard.writeText("12 apples"));
  const input = page.getByRole("spinbutton", { name: "P1 x" });
  await input.focus();
  await page.keyboard.press("ControlOrMeta+v");
  await page.locator("bezier-coordinates .error").waitFor();
  assert.deepEqual(await on(page, "bezier-coordinates", ({ points }) => points[1]), [110, 90]);
  assert.equal(await input.inputValue(), "110");
});

test("the playground of the elements copies the tag", async (t) => {
  const page = await openPage(t, "/elements/", { permissions });
  const box = page.locator(".playground");
  await box.getByRole("checkbox", { name: "hull", exact: true }).check();
  const button = box.getByRole("button", { name: "Copy" });
  await button.evaluate((copy) =>
    new MutationObserver(() => (copy.dataset.copied = "")).observe(copy, { childList: true }),
  );
  await button.click();
  await page.locator(".copy[data-copied]").waitFor();
  const copied = await page.evaluate(() => navigator.clipboard.readText());
  assert.equal(copied, await box.locator("code").textContent());
  assert.match(copied, /show="polygon hull construction"/);
});
