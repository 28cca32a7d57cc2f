// The applet on the site's pages, and what the guide to the elements says.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { boxOf, assertAccessibleInBothThemes, openPage, root } from "./browser.js";
import { drag, drawn, handle, openTutorial, points, TUTORIAL } from "./applet-page.js";

const PHONE = { viewport: { width: 360, height: 740 }, deviceScaleFactor: 2, hasTouch: true, isMobile: true };

test("the applet with everything switched on is accessible, light and dark", async (t) => {
  const page = await openTutorial(t);
  await page.evaluate(() => {
    Object.assign(bezierApp(), { joint: "g1", layers: { hull: true, construction: true, halves: true } });
    bezierApp().append([300, 40]);
  });
  await handle(page, 9).waitFor();
  await assertAccessibleInBothThemes(page, drawn);
});

test("the picture changes with the colour scheme, and is as sharp as the display", async (t) => {
  const page = await openTutorial(t, { deviceScaleFactor: 2 });
  const picture = () => page.evaluate(() => document.querySelector("canvas").toDataURL());
  await drawn(page);
  assert.deepEqual(
    await page.evaluate(() => [document.querySelector("canvas").width, document.querySelector("canvas").height]),
    [1340, 960],
  );
  const light = await picture();
  await page.emulateMedia({ colorScheme: "dark" });
  await drawn(page);
  assert.notEqual(await picture(), light);
});

test("the guide holds the lines that embed the small applet, to the letter", async (t) => {
  const page = await openPage(t, "/elements/");
  assert.ok((await page.locator("pre").allInnerTexts()).join("\n").includes(TUTORIAL));
});

test("the page to copy shows the coordinates live", async (t) => {
  const page = await openPage(t, "/applet/", { viewport: { width: 900, height: 1400 } });
  await handle(page, 6).waitFor();
  await drag(page, 0, 25, -15);
  const row = await page.getByRole("row", { name: "P0" }).innerText();
  assert.match(row, /95\.0\s+315\.0/);
  assert.equal(await page.locator("#event").innerText(), "change");
  await page.keyboard.press("r");
  await drawn(page);
  const [x, y] = (await points(page))[5];
  assert.match(
    await page.getByRole("row", { name: "P5" }).innerText(),
    new RegExp(`${x.toFixed(1)}\\s+${y.toFixed(1)}`),
  );
});

test("the page to copy carries the tutorial's lines", async () => {
  const text = await readFile(`${root}www/applet/index.html`, "utf8");
  assert.ok(text.replaceAll(/^ +/gm, "").includes(TUTORIAL));
});

test("on a narrow phone the picture keeps its shape and fingers their aim", async (t) => {
  const page = await openTutorial(t, PHONE);
  const box = await boxOf(page.locator("canvas"));
  await page.locator("canvas").evaluate((canvas) => (canvas.style.cssText = "width: 670px; height: 480px")); // as many pages do
  await drawn(page);
  assert.deepEqual(await boxOf(page.locator("canvas")), box);
  assert.ok(Math.abs(box.width - 344) < 0.5 && Math.abs(box.height - (344 * 480) / 670) < 0.5, JSON.stringify(box));
  const before = await points(page);
  await drag(page, 5, -50, -20);
  const after = await points(page);
  const scale = 670 / box.width;
  assert.ok(
    Math.abs(after[5][0] - before[5][0] + 50 * scale) < 0.1 && Math.abs(after[5][1] - before[5][1] + 20 * scale) < 0.1,
  );
});

test("the guide names every attribute of every element, and no other", async (t) => {
  const page = await openPage(t, "/elements/");
  await page.evaluate(async () => {
    const { loadElement } = await import("/dist/elements.js");
    const named = [.../** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll("table[data-element]"))];
    for (const { dataset } of named) await loadElement(/** @type {any} */ (dataset.element));
  });
  const tables = await page.locator("table[data-element]").evaluateAll((tables) =>
    tables.map((table) => {
      const name = String(table.dataset.element);
      const named = [...table.querySelectorAll("tbody th")].map((cell) => cell.textContent);
      const type = /** @type {any} */ (customElements.get(name));
      return { name, named: named.sort(), observed: [...type.observedAttributes].sort() };
    }),
  );
  assert.ok(tables.length >= 6);
  for (const { name, named, observed } of tables) assert.deepEqual(named, observed, name);
});

test("the page of errata shows every proof, and each holds in the browser, too", async (t) => {
  const page = await openPage(t, "/errata/");
  await page.waitForFunction(() => [...document.querySelectorAll("[data-proof]")].every((line) => line.dataset.holds));
  const failed = await page.locator('[data-holds="false"]').allInnerTexts();
  assert.deepEqual(failed, []);
  assert.ok((await page.locator('[data-holds="true"]').count()) > 20);
});
