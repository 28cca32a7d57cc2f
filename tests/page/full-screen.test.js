// Every figure of the site can fill the screen: its letters are larger and sharp, and pointers meet its points.
import assert from "node:assert/strict";
import { test } from "node:test";
import { boxOf, openPage } from "./browser.js";
import { dragBy } from "./gestures.js";

/** Shows a figure on the whole screen. */
async function fill(page, figure) {
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
  const shown = () => page.evaluate(() => document.fullscreenElement?.querySelector("figure")?.id);
  const waitFor = (/** @type {string} */ id) =>
    page.waitForFunction((id) => document.fullscreenElement?.querySelector("figure")?.id === id, id);
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

/** The boxes of the figure's sheet and of the tasks on the whole screen, and whether any text of the section is shown. */
const shownOnScreen = (page) =>
  page.evaluate(() => {
    const scene = /** @type {Element} */ (document.fullscreenElement);
    const boxOf = (/** @type {Element} */ each) => {
      const { left, top, right, bottom } = each.getBoundingClientRect();
      return { left, top, right, bottom };
    };
    const texts = [...scene.querySelectorAll(".before > *, .after > :not(lesson-task)")];
    return {
      sheet: boxOf(/** @type {Element} */ (scene.querySelector(".sheet"))),
      tasks: [...scene.querySelectorAll("lesson-task")].map(boxOf),
      hasText: texts.some((each) => each.getClientRects().length > 0),
      width: scene.scrollWidth,
    };
  });

for (const [width, height, isBeside] of /** @type {[number, number, boolean][]} */ ([
  [1920, 1080, true],
  [1280, 800, true],
  [360, 740, false],
])) {
  test(`on a whole screen of ${width} × ${height} the tasks are ${isBeside ? "beside" : "below"} their figure, and can be solved`, async (t) => {
    const viewport = { width, height };
    const page = await openPage(t, "/curves/de-casteljau/", { viewport, screen: viewport, reducedMotion: "reduce" });
    const figure = page.locator("#figure-de-casteljau");
    await figure.locator("bezier-applet canvas").waitFor();
    await fill(page, figure);
    const task = page.locator('lesson-task[name="level-tangent"]');
    await task.getByRole("button", { name: "It is highest or lowest there" }).click();
    const { sheet, tasks, hasText, width: scrolled } = await shownOnScreen(page);
    assert.equal(hasText, false);
    assert.ok(scrolled <= width, `${scrolled} px wide`);
    assert.ok(isBeside ? tasks[0].left >= sheet.right : tasks[0].top >= sheet.bottom, JSON.stringify([sheet, tasks]));
    if (isBeside) assert.ok(sheet.top >= 0 && sheet.bottom <= height && tasks[0].bottom <= height);
    await figure.getByRole("slider", { name: "t", exact: true }).fill("0.44");
    await task.getByText("You predicted it.").waitFor();
    await page.keyboard.press("PageDown");
    await page.waitForFunction(() => document.fullscreenElement?.querySelector("#figure-envelope"));
    await page.keyboard.press("PageUp");
    await page.waitForFunction(() => document.fullscreenElement?.querySelector("#figure-de-casteljau"));
    assert.equal(await task.getAttribute("data-state"), "done");
  });
}
