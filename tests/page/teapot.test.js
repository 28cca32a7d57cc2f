// The rotating wireframe.
import assert from "node:assert/strict";
import { test } from "node:test";
import { boxOf, frames, openPage, QUIET_FRAMES } from "./browser.js";
import { drawn } from "./applet-page.js";

/** How many pixels are drawn on, and the picture itself. */
const look = (page) =>
  page.evaluate(() => {
    const canvas = document.querySelector("canvas");
    const copy = Object.assign(document.createElement("canvas"), { width: canvas.width, height: canvas.height });
    const context = /** @type {any} */ (copy.getContext("2d", { willReadFrequently: true }));
    context.drawImage(canvas, 0, 0);
    const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
    let [inked, left, right, top, bottom] = [0, canvas.width, 0, canvas.height, 0];
    for (let i = 3; i < data.length; i += 4) {
      if (data[i] < 100) continue;
      const [x, y] = [((i - 3) / 4) % canvas.width, Math.floor(i / 4 / canvas.width)];
      [inked, left, right] = [inked + 1, Math.min(left, x), Math.max(right, x)];
      [top, bottom] = [Math.min(top, y), Math.max(bottom, y)];
    }
    const { width, height } = canvas;
    return { inked, left, right, top, bottom, width, height, image: canvas.toDataURL() };
  });

test("the teapot is drawn, inside the picture, and turns", async (t) => {
  const page = await openPage(t, "/teapot/");
  await drawn(page);
  const first = await look(page);
  assert.ok(first.inked > 3000, `${first.inked} pixels`);
  assert.ok(first.left > 0 && first.right < first.width - 1, "nothing is cut off at the sides");
  assert.ok(first.top > 0 && first.bottom < first.height - 1, "nor above and below");
  assert.ok(first.right - first.left > 0.7 * first.height, "and it fills the picture");
  await page.waitForFunction((image) => document.querySelector("canvas").toDataURL() !== image, first.image);
});

test("it can be paused, turned by keys, by sliders, by dragging", async (t) => {
  const page = await openPage(t, "/teapot/");
  await page.getByRole("button", { name: "Pause" }).click();
  const still = async () => {
    await drawn(page);
    return (await look(page)).image;
  };
  const paused = await still();
  await frames(page, QUIET_FRAMES);
  assert.equal(await still(), paused);
  await page.locator("canvas").focus();
  await page.keyboard.press("ArrowRight");
  const turned = await still();
  assert.notEqual(turned, paused);
  await page.getByLabel("Tilt").focus();
  await page.keyboard.press("ArrowUp");
  const tilted = await still();
  assert.notEqual(tilted, turned);
  const { x, y, width, height } = await boxOf(page.locator("canvas"));
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.mouse.down();
  await page.mouse.move(x + width / 2 + 60, y + height / 2 + 10, { steps: 3 });
  await page.mouse.up();
  const dragged = await still();
  assert.notEqual(dragged, tilted);
  await page.getByLabel("Lines").fill("8");
  assert.ok((await still()) !== dragged);
  await page.getByRole("button", { name: "Play" }).click();
  await page.getByRole("button", { name: "Pause" }).waitFor();
  await page.waitForFunction((image) => document.querySelector("canvas").toDataURL() !== image, await still());
});

test("it stands still for those who want less motion", async (t) => {
  const page = await openPage(t, "/teapot/", { reducedMotion: "reduce" });
  await drawn(page);
  const first = await look(page);
  assert.ok(first.inked > 3000);
  await frames(page, QUIET_FRAMES);
  assert.equal((await look(page)).image, first.image);
  assert.equal(await page.getByRole("button", { name: "Play" }).count(), 1);
});
