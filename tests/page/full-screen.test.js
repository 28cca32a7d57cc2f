// Every figure of the site can fill the screen: its letters are larger and sharp, and pointers meet its points.
import assert from "node:assert/strict";
import { test } from "node:test";
import { boxOf, openPage } from "./browser.js";
import { dragBy } from "./gestures.js";

/** Shows a figure on the whole screen. */
async function fill(page, figure) {
  await figure.scrollIntoViewIfNeeded();
  await figure.getByRole("button", { name: "Full screen" }).click();
  await page.waitForFunction(() => document.fullscreenElement);
}

/** The size of a canvas in its own pixels, and on the screen. */
const sizes = (canvas) =>
  canvas.evaluate((/** @type {HTMLCanvasElement} */ canvas) => [canvas.width, canvas.getBoundingClientRect().width]);

test("a curve on the whole screen: larger, as sharp as the display, and its points follow the pointer", async (t) => {
  const page = await openPage(t, "/elements/", { viewport: { width: 1280, height: 720 }, reducedMotion: "reduce" });
  const figure = page.locator("#hero");
  await figure.locator("bezier-applet canvas").waitFor();
  const before = await boxOf(figure.locator("canvas"));
  // The window of the tests has no screen of its own: a large one is assumed.
  await page.evaluate(() => Object.defineProperties(screen, { width: { value: 1280 }, height: { value: 1400 } }));
  await fill(page, figure);
  await page.waitForFunction((width) => {
    const box = document.querySelector("#hero bezier-applet")?.shadowRoot?.querySelector("canvas");
    return (
      box &&
      box.getBoundingClientRect().width > 1.3 * width &&
      Math.abs(box.width - box.getBoundingClientRect().width) <= 2
    );
  }, before.width);
  const [pixels, width] = await sizes(figure.locator("canvas"));
  assert.ok(Math.abs(pixels - width) <= 2, `${pixels} pixels on ${width}`);
  const handle = figure.locator('[part="handle"][data-index="1"]');
  const from = await boxOf(handle);
  await dragBy(page, handle, 40, 30);
  const to = await boxOf(handle);
  assert.ok(Math.abs(to.x - from.x - 40) <= 1 && Math.abs(to.y - from.y - 30) <= 1, JSON.stringify([from, to]));
  await figure.getByRole("button", { name: "Exit full screen" }).click();
  await page.waitForFunction(() => !document.fullscreenElement);
  assert.deepEqual((await boxOf(figure.locator("canvas"))).width, before.width);
});

test("a surface on the whole screen: a control point follows the pointer", async (t) => {
  const page = await openPage(t, "/surfaces/patches/", {
    viewport: { width: 1280, height: 720 },
    reducedMotion: "reduce",
  });
  const figure = page.locator("#figure-patch");
  await figure.scrollIntoViewIfNeeded();
  await figure.locator(".handle:visible").first().waitFor();
  await page.evaluate(() => Object.defineProperties(screen, { width: { value: 1280 }, height: { value: 1400 } }));
  await fill(page, figure);
  const zoom = await figure
    .locator("canvas")
    .first()
    .evaluate((canvas) => /** @type {any} */ (canvas).currentCSSZoom);
  assert.ok(zoom > 1.1, `zoom ${zoom}`);
  const handle = figure.locator(".handle:visible").first();
  const from = await boxOf(handle);
  await dragBy(page, handle, 30, -20);
  const to = await boxOf(handle);
  assert.ok(Math.abs(to.x - from.x - 30) <= 1.5 && Math.abs(to.y - from.y + 20) <= 1.5, JSON.stringify([from, to]));
});

test("on the whole screen, Page Down and Page Up step through the figures of the section, and the button leaves it", async (t) => {
  const page = await openPage(t, "/curves/quadratic/", {
    viewport: { width: 1280, height: 720 },
    reducedMotion: "reduce",
  });
  const shown = () => page.evaluate(() => document.fullscreenElement?.id);
  const waitFor = (/** @type {string} */ id) => page.waitForFunction((id) => document.fullscreenElement?.id === id, id);
  await fill(page, page.locator("#figure-lerp"));
  await page.keyboard.press("PageUp");
  assert.equal(await shown(), "figure-lerp", "the first one");
  await page.keyboard.press("PageDown");
  await waitFor("figure-steps");
  await page.keyboard.press("PageDown");
  await waitFor("figure-quadratic");
  const { width } = await boxOf(page.locator("#figure-quadratic canvas"));
  assert.ok(width > 600, `${width} px`);
  await page.keyboard.press("PageUp");
  await waitFor("figure-steps");
  await page.getByRole("button", { name: "Exit full screen" }).click();
  await page.waitForFunction(() => !document.fullscreenElement);
});
