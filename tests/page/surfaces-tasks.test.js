// The tasks and figures of the chapter on surfaces, by hand: sliders, keys, pointer, text.
import assert from "node:assert/strict";
import { test } from "node:test";
import { done, task } from "./chapter-page.js";
import { controls, near, open, reading } from "./surfaces-page.js";
import { boxOf, frames } from "./browser.js";
import { dragFrom } from "./gestures.js";

test("a corner, by the sliders' keys, after a guess", async (t) => {
  const page = await open(t);
  await near(page, "map-surface");
  const found = await task(page, "corner-10", 2);
  await found.getByRole("button", { name: "Check" }).click();
  assert.match(await found.locator(".words").innerText(), /u = 0\.30/);
  await controls(page, "map-surface").getByRole("slider", { name: "u" }).press("End");
  await controls(page, "map-surface").getByRole("slider", { name: "v" }).press("Home");
  assert.match(await done(page, "corner-10"), /P30, where row 0 ends/);
  assert.match(await page.locator("unit-square .note").innerText(), /S\(1, 0\) = \(3\.00, −3\.00, 0\.50\)/);
});

test("the square is dragged, and turned by arrow keys", async (t) => {
  const page = await open(t);
  await near(page, "map-surface");
  const place = () =>
    page.evaluate(() => [document.querySelector("#map-surface").u, document.querySelector("#map-surface").v]);
  const box = await boxOf(page.locator("unit-square .square"));
  await dragFrom(page, [box.x + 5, box.y + 5], 0.75 * box.width - 5, 0.25 * box.height - 5);
  const [u, v] = await place();
  assert.ok(Math.abs(u - 0.75) < 0.011 && Math.abs(v - 0.75) < 0.011, `${u}, ${v}`);
  await page.locator("unit-square svg").press("Shift+ArrowLeft");
  await page.locator("unit-square svg").press("ArrowUp");
  const [u1, v1] = await place();
  assert.ok(Math.abs(u1 - (u - 0.1)) < 1e-9 && Math.abs(v1 - (v + 0.01)) < 1e-9);
});

test("a patch is split elsewhere, and an edge between two patches made smooth", async (t) => {
  const page = await open(t);
  await near(page, "halves-surface");
  const u = () =>
    page.evaluate(() => {
      const { surface } = document.querySelector("#halves-surface").figure;
      return surface.patch(0).area() / surface.patch(1).area();
    });
  const before = await u();
  await page.locator("surface-split").getByRole("slider", { name: "Split at u" }).press("ArrowLeft");
  await page.waitForFunction((before) => {
    const { surface } = document.querySelector("#halves-surface").figure;
    return surface.patch(0).area() / surface.patch(1).area() < before;
  }, before);
  const joint = await near(page, "joint-surface");
  await task(page, "smooth-joint");
  await reading(page, "joint-surface")
    .getByText(/is 3\d\.\d°\./)
    .waitFor();
  const handle = joint.locator('.handle[data-index="4"]');
  await handle.focus();
  const height = () => page.evaluate(() => document.querySelector("#joint-surface").figure.points[4][2]);
  for (let i = 0; i < 30 && (await height()) < 1.95; i++)
    await handle.press((await height()) < 1.5 ? "Shift+ArrowUp" : "ArrowUp");
  assert.match(await done(page, "smooth-joint"), /The largest angle is [0-2]\.\d°/);
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

test("by tolerance the disc gets more than two triangles, and the crack closes", async (t) => {
  const page = await open(t);
  await near(page, "disc-surface");
  const triangles = () => page.evaluate(() => document.querySelector("#disc-surface").figure.mesh.triangles);
  assert.equal(await triangles(), 2, "flat, so the recursion stops at once");
  await controls(page, "disc-surface").getByRole("combobox", { name: "Fineness" }).selectOption("tolerance");
  await page.waitForFunction(() => document.querySelector("#disc-surface").figure.mesh.triangles > 20);
  await page.locator("crack-strip").scrollIntoViewIfNeeded();
  await page.locator("crack-strip").getByRole("slider", { name: "Right patch" }).press("ArrowRight");
  await page.locator("crack-strip").getByText("There is no crack.").waitFor();
});

test("the winding is turned round: the front becomes the back", async (t) => {
  const page = await open(t);
  await near(page, "winding-surface");
  const normal = () => page.evaluate(() => document.querySelector("#winding-surface").figure.place.normal[2]);
  assert.ok((await normal()) > 0.5);
  await page.getByRole("button", { name: "u and v exchanged" }).click();
  assert.ok((await normal()) < -0.5);
  await page.getByRole("button", { name: "Original" }).click();
  assert.ok((await normal()) > 0.5);
});

test("the spout is clicked, a patch with a collapsed side chosen in the table", async (t) => {
  const page = await open(t);
  const rays = await near(page, "ray-surface");
  await task(page, "spout-hit");
  await rays.scrollIntoViewIfNeeded();
  const [x, y] = await page.evaluate(() => {
    const element = document.querySelector("#ray-surface");
    const { width, height, left, top } = element.shadowRoot.querySelector("canvas").getBoundingClientRect();
    return [left + 0.785 * width, top + 0.5 * height];
  });
  await page.mouse.click(x, y);
  await reading(page, "ray-surface")
    .getByText(/^Patch 1[67] \(spout\), u = 0\.\d\d/)
    .waitFor();
  await page.evaluate(() => (document.querySelector("#ray-surface").patch = 19));
  assert.match(await done(page, "spout-hit"), /16 to 19/);
  await near(page, "teapot-surface");
  const collapsed = await task(page, "collapsed-patch", 1);
  await page.locator("teapot-data").getByRole("slider", { name: "Patch" }).fill("5");
  await page.getByText(/Patch 5: 16 different control points/).waitFor();
  await collapsed.getByRole("button", { name: "Check" }).click();
  await collapsed.getByText(/Patch 5 has sixteen different control points/).waitFor();
  await page.locator("teapot-data").getByRole("slider", { name: "Patch" }).fill("20");
  await page.getByText(/Patch 20: 10 different control points/).waitFor();
  assert.match(await done(page, "collapsed-patch"), /Patch 20 has 10 .*You predicted it/);
  await page.locator("teapot-data").getByRole("slider", { name: "Patch" }).fill("31");
  const rows = await page
    .locator("teapot-data tr")
    .evaluateAll((rows) =>
      rows.map((row) => [...row.querySelectorAll("b, span")].map(({ textContent }) => textContent).join(" ")),
    );
  assert.deepEqual(rows, ["270 270 270 270", "300 305 306 279", "297 303 304 275", "294 301 302 271"], "as published");
});

test("a patch file is written and shown; what is none is refused in words", async (t) => {
  const page = await open(t);
  await near(page, "file-surface");
  await task(page, "own-square");
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
  assert.match(await done(page, "own-square"), /flat square/);
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
