// Keyboard, touch, double clicks, stacks of handles.
import assert from "node:assert/strict";
import { test } from "node:test";
import { centre, drawn, handle, openTutorial, points } from "./applet-page.js";
import { boxOf } from "./browser.js";
import { assertNear, doubleClick, doubleTap, fingersOn } from "./gestures.js";

/** The accessible name of what has the focus, inside the shadow root. */
const focused = (page) =>
  page.evaluate(() => document.activeElement?.shadowRoot?.activeElement?.getAttribute("aria-label") ?? "");

test("keyboard only: Tab goes along the curve, arrows move a point, up is up on both sliders", async (t) => {
  const page = await openTutorial(t);
  const before = await points(page);
  await page.keyboard.press("Tab");
  const names = [];
  for (let i = 0; i < 7; i++) {
    names.push(await focused(page));
    await page.keyboard.press("Tab");
  }
  assert.deepEqual(names, ["P0 x", "P1 x", "P2 x", "P3 x", "P4 x", "P5 x", "P6 x"]);
  for (const [name, key] of [
    ["P4 x", "Shift+ArrowRight"],
    ["P4 x", "ArrowUp"],
    ["P4 y", "ArrowUp"],
  ]) {
    await page.getByLabel(name).focus();
    await page.keyboard.press(key);
  }
  await drawn(page);
  assertNear((await points(page))[4], [before[4][0] + 10, before[4][1] - 2], 1e-9);
});

test("keyboard only: buttons, joint switch, slider and layers", async (t) => {
  const page = await openTutorial(t);
  const press = async (locator, key) => {
    await locator.focus();
    await page.keyboard.press(key);
    await drawn(page);
  };
  const app = (name) => page.evaluate((name) => bezierApp()[name], name);
  await press(page.getByRole("button", { name: /Show 4 points/ }), "Enter");
  assert.equal(await app("visiblePoints"), 4);
  await press(page.getByRole("button", { name: /Show 7 points/ }), "Space");
  assert.equal(await app("visiblePoints"), 7);
  await press(page.getByLabel("Free"), "ArrowRight");
  assert.equal(await app("joint"), "g1");
  await press(page.getByLabel("t", { exact: true }), "ArrowRight");
  assertNear([await app("t")], [0.51], 1e-9);
  await press(page.getByLabel("hull"), "Space");
  assert.equal((await app("layers")).hull, true);
  await press(page.getByRole("button", { name: "Add a point" }), "Enter");
  assert.equal(await page.locator('[part="handle"]').count(), 10);
  const before = await points(page);
  await press(page.getByRole("button", { name: /Randomize/ }), "Enter");
  assert.notDeepEqual(await points(page), before);
});

test("a slider moved by a screen reader moves its point; changes are announced once", async (t) => {
  const page = await openTutorial(t);
  const set = (name, value) =>
    page.getByLabel(name).evaluate((/** @type {any} */ input, value) => {
      input.value = value;
      input.dispatchEvent(new Event("input", { bubbles: true }));
    }, value);
  await set("P1 x", "200");
  await set("P1 y", "400"); // from below: 80 from the top
  assertNear((await points(page))[1], [200, 80], 1e-9);
  await drawn(page);
  assert.equal(await page.getByLabel("P1 y").getAttribute("aria-valuetext"), "80");
  assert.equal(await page.getByLabel("P1 y").inputValue(), "400");
  const live = page.getByRole("status");
  await page.waitForFunction(
    () => document.querySelector("canvas").parentNode.shadowRoot.querySelector("[role=status]").textContent,
  );
  assert.equal(await live.textContent(), "P1 at 200, 80");
  // All five at once, so that no pause between them is long enough for a text of its own.
  const texts = await page.getByLabel("P1 x").evaluate((input) => {
    const said = [];
    const live = /** @type {any} */ (input.getRootNode()).querySelector("[role=status]");
    const announced = new Promise((resolve) =>
      new MutationObserver(() => {
        said.push(live.textContent);
        resolve(said);
      }).observe(live, { childList: true }),
    );
    for (let i = 0; i < 5; i++)
      input.dispatchEvent(
        new KeyboardEvent("keydown", { key: "ArrowLeft", bubbles: true, composed: true, cancelable: true }),
      );
    return announced;
  });
  assert.deepEqual(texts, ["P1 at 195, 80"]);
  const description = await page
    .getByRole("figure")
    .evaluate((figure) => /** @type {any} */ (figure.getRootNode()).getElementById("description").textContent);
  assert.match(description, /^2 cubic Bézier curves .* P0 at 70, 330, P3 at .* P1 at 195, 80/);
});

test("a double click on an empty place appends a segment that ends there; on a point it does not", async (t) => {
  const page = await openTutorial(t);
  const { x, y } = await boxOf(page.locator("canvas"));
  await doubleClick(page, [x + 420, y + 60]);
  await drawn(page);
  const after = await points(page);
  assert.equal(after.length, 10);
  assertNear(after[9], [420, 60], 1);
  assert.equal(await page.locator('[part="handle"]').count(), 10);
  assert.equal(await focused(page), "P9 x");
  const [px, py] = await centre(page, 0);
  await doubleClick(page, [px, py]);
  await page.mouse.click(x + 20, y + 20);
  await page.mouse.click(x + 300, y + 20);
  assert.equal((await points(page)).length, 10, "neither a point nor two places apart count");
});

test("hit boxes are 24 pixels, 44 where fingers point", async (t) => {
  const fine = await boxOf(handle(await openTutorial(t), 2));
  const coarse = await boxOf(handle(await openTutorial(t, { hasTouch: true, isMobile: true }), 2));
  assertNear([fine.width, fine.height, coarse.width, coarse.height], [24, 24, 44, 44], 0.01);
});

test("touch: two fingers move two points at once, and neither scrolls the page", async (t) => {
  const page = await openTutorial(t, { hasTouch: true, isMobile: true, viewport: { width: 700, height: 600 } });
  const before = await points(page);
  const [a, b] = [await centre(page, 1), await centre(page, 4)];
  const touch = await fingersOn(page);
  const places = (i) => [
    [a[0] + 10 * i, a[1] + 8 * i],
    [b[0] - 9 * i, b[1] - 12 * i],
  ];
  await touch("touchStart", a);
  for (let i = 0; i <= 5; i++) await touch(i ? "touchMove" : "touchStart", ...places(i));
  await touch("touchEnd");
  await drawn(page);
  const after = await points(page);
  assertNear(after[1], [before[1][0] + 50, before[1][1] + 40], 1.01);
  assertNear(after[4], [before[4][0] - 45, before[4][1] - 60], 1.01);
  assert.deepEqual(after.with(1, before[1]).with(4, before[4]), before);
  assert.equal(await page.evaluate(() => scrollY), 0);
});

test("touch: a double tap on an empty place appends; a cancelled touch restores", async (t) => {
  const page = await openTutorial(t, { hasTouch: true, isMobile: true });
  const { x, y } = await boxOf(page.locator("canvas"));
  await doubleTap(page, [x + 400, y + 70], [x + 402, y + 71]);
  await drawn(page);
  const before = await points(page);
  assert.equal(before.length, 10);
  assertNear(before[9], [402, 71], 2);
  const [px, py] = await centre(page, 1);
  const touch = await fingersOn(page);
  await touch("touchStart", [px, py]);
  await touch("touchMove", [px + 60, py + 50]);
  await drawn(page);
  assert.notDeepEqual(await points(page), before);
  await touch("touchCancel");
  await drawn(page);
  assert.deepEqual(await points(page), before);
});
