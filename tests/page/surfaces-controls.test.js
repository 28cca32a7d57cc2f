// What the chapter on surfaces has beside its figures: sliders, buttons, tables and texts that steer them, and what they say.
import assert from "node:assert/strict";
import { test } from "node:test";
import { goTo } from "./chapter-page.js";
import { controls, near, open, reading } from "./surfaces-page.js";
import { boxOf, frames } from "./browser.js";
import { dragFrom } from "./gestures.js";

/** @typedef {import("playwright-core").Page} Page */
const press = (name) => (/** @type {Page} */ page) => page.getByRole("button", { name }).click();
const normal = (/** @type {Page} */ page) =>
  page.evaluate(() => (document.querySelector("#winding-surface").figure.place.normal[2] > 0 ? "front" : "back"));
const triangles = (/** @type {Page} */ page) =>
  page.evaluate(() => `${document.querySelector("#disc-surface").figure.mesh.triangles}`);
const text = (selector) => (/** @type {Page} */ page) => page.locator(selector).first().innerText();
const patchOfTeapot = (k) => (/** @type {Page} */ page) =>
  page.locator("teapot-data").getByRole("slider", { name: "Patch" }).fill(String(k));
/** The areas of both halves, the left one in percent of the right one. */
const halves = (/** @type {Page} */ page) =>
  page.evaluate(() => {
    const { surface } = document.querySelector("#halves-surface").figure;
    return surface.patch(0).area() < 0.99 * surface.patch(1).area() ? "smaller" : "as large";
  });

/** A figure, inputs, and what is so before and after. @type {[string, ((page: Page) => Promise<unknown>)[], (page: Page) => Promise<string>, RegExp, RegExp][]} */
const CONTROLS = [
  [
    "map-surface",
    [
      (page) => controls(page, "map-surface").getByRole("slider", { name: "u" }).press("End"),
      (page) => controls(page, "map-surface").getByRole("slider", { name: "v" }).press("Home"),
    ],
    text("unit-square .note"),
    /S\(0\.\d+, 0\.\d+\) = /,
    /S\(1, 0\) = \(3\.00, −3\.00, 0\.50\)/,
  ],
  [
    "halves-surface",
    [(page) => page.locator("surface-split").getByRole("slider", { name: "Split at u" }).fill("0.3")],
    halves,
    /./,
    /smaller/,
  ],
  [
    "disc-surface", // flat, so the recursion stops at once
    [(page) => controls(page, "disc-surface").getByRole("combobox", { name: "Fineness" }).selectOption("tolerance")],
    triangles,
    /^2$/,
    /^[2-9]\d+$/,
  ],
  ["winding-surface", [press("u and v exchanged")], normal, /front/, /back/],
  ["winding-surface", [press("Original")], normal, /back/, /front/],
  ["teapot-surface", [patchOfTeapot(5)], text("teapot-data"), /Patch/, /Patch 5: 16 different control points/],
  ["teapot-surface", [patchOfTeapot(20)], text("teapot-data"), /Patch 5/, /Patch 20: 10 different control points/],
];

for (const [name, inputs, read, before, after] of CONTROLS)
  test(`${name} becomes ${after.source}`, async (t) => {
    const page = await open(t);
    await near(page, name);
    assert.match(await read(page), before);
    for (const input of inputs) await input(page);
    for (let k = 0; k < 60 && !after.test(await read(page)); k++) await frames(page);
    assert.match(await read(page), after);
  });

test("the square is dragged, and turned by arrow keys", async (t) => {
  const page = await open(t);
  await near(page, "map-surface");
  const place = () =>
    page.evaluate(() => [document.querySelector("#map-surface").u, document.querySelector("#map-surface").v]);
  await page.locator("unit-square").evaluate((square) => square.scrollIntoView({ block: "center" }));
  const box = await boxOf(page.locator("unit-square .square"));
  await dragFrom(page, [box.x + 5, box.y + 5], 0.75 * box.width - 5, 0.25 * box.height - 5);
  const [u, v] = await place();
  assert.ok(Math.abs(u - 0.75) < 0.011 && Math.abs(v - 0.75) < 0.011, `${u}, ${v}`);
  await page.locator("unit-square svg").press("Shift+ArrowLeft");
  await page.locator("unit-square svg").press("ArrowUp");
  const [u1, v1] = await place();
  assert.ok(Math.abs(u1 - (u - 0.1)) < 1e-9 && Math.abs(v1 - (v + 0.01)) < 1e-9);
});

test("steps, and the surface that grows", async (t) => {
  const page = await open(t);
  await near(page, "evaluation-surface");
  const steps = controls(page, "evaluation-surface");
  for (const words of [/2\/4: The curves of the other rows/, /3\/4/, /4\/4/]) {
    await steps.getByRole("button", { name: "Next step" }).click();
    await steps.getByText(words).waitFor();
  }
  assert.ok(await steps.getByRole("button", { name: "Next step" }).isDisabled());
  await near(page, "curves-surface");
  const u = () => page.evaluate(() => document.querySelector("#curves-surface").u);
  const before = await u();
  await page.locator("surface-player").getByRole("button", { name: "Play" }).click();
  await page.waitForFunction((before) => document.querySelector("#curves-surface").u > before + 0.02, before);
  await page.getByRole("button", { name: "Stop" }).click();
  const held = await u();
  await frames(page);
  assert.equal(await u(), held);
});

test("the crack closes", async (t) => {
  const page = await open(t);
  await goTo(page, "figure-cracks");
  await page.locator("crack-strip").scrollIntoViewIfNeeded();
  await page.locator("crack-strip").getByRole("slider", { name: "Right patch" }).press("ArrowRight");
  await page.locator("crack-strip").getByText("There is no crack.").waitFor();
});

test("the spout is clicked; the table has the listing as published", async (t) => {
  const page = await open(t);
  await (await near(page, "ray-surface")).scrollIntoViewIfNeeded();
  const { x, y, width, height } = await boxOf(page.locator("#ray-surface canvas"));
  await page.mouse.click(x + 0.785 * width, y + 0.5 * height);
  await reading(page, "ray-surface")
    .getByText(/^Patch 1[67] \(spout\), u = 0\.\d\d/)
    .waitFor();
  await near(page, "teapot-surface");
  await patchOfTeapot(31)(page);
  const rows = await page
    .locator("teapot-data tr")
    .evaluateAll((rows) =>
      rows.map((row) => [...row.querySelectorAll("b, span")].map(({ textContent }) => textContent).join(" ")),
    );
  assert.deepEqual(rows, ["270 270 270 270", "300 305 306 279", "297 303 304 275", "294 301 302 271"]);
});

test("a patch file is written and shown; what is none is refused in words", async (t) => {
  const page = await open(t);
  await near(page, "file-surface");
  const text = page.getByRole("textbox", { name: "A patch file" });
  await text.fill("1\n1 1\n0 0 0\n1 0 0\n0 1 0\n1 one 0");
  await page.getByRole("button", { name: "Show it" }).click();
  await page
    .locator("patch-text .note")
    .getByText(/line|row|number/)
    .waitFor();
  assert.equal(await page.evaluate(() => document.querySelector("#file-surface").surface.patchCount), 32);
  await text.fill("1\n1 1\n0 0 0\n1 0 0\n0 1 0\n1 1 0");
  await page.getByRole("button", { name: "Show it" }).click();
  await page.waitForFunction(() => document.querySelector("#file-surface").surface.patchCount === 1);
});

test("a point is moved, and the nearest place of the pot follows", async (t) => {
  const page = await open(t);
  await near(page, "nearest-surface");
  const words = () => reading(page, "nearest-surface").locator(".note").innerText();
  const before = await words();
  assert.match(before, /on patch \d+, at u = 0\.\d\d, v = [01]\.\d\d/);
  await controls(page, "nearest-surface").getByRole("slider", { name: "z" }).fill("4");
  await page.waitForFunction(
    (before) => document.querySelector('surface-reading[for="nearest-surface"] .note').textContent !== before,
    before,
  );
  const { distance, expected } = await page.evaluate(() => {
    const { figure, surface } = document.querySelector("#nearest-surface");
    return { distance: figure.nearest.distance, expected: surface.nearest([3.2, -0.4, 4]).distance };
  });
  assert.equal(distance, expected);
});
