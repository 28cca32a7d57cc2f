// The camera: even speed, calm frames, points that move; the code on the page is right.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Spline } from "casteljau";
import { close, open, slide, state } from "./application-page.js";
import { frames } from "./browser.js";
import { centreOf, dragBy, pullFrom } from "./gestures.js";

test("camera: equal times are equal ways at even speed only", async (t) => {
  const page = await open(t, "/camera/");
  const ways = (even) =>
    page.locator(`[data-even=${even}]`).evaluateAll((ticks) => ticks.map((tick) => Number(tick.dataset.s)));
  const steps = (list) => list.slice(1).map((s, i) => s - list[i]);
  const even = steps(await ways(true));
  const raw = steps(await ways(false));
  close(Math.max(...even), Math.min(...even), 1e-9);
  assert.ok(Math.max(...raw) > 1.5 * Math.min(...raw), "raw speed is uneven");
  close(
    raw.reduce((a, b) => a + b),
    even.reduce((a, b) => a + b),
    1e-9,
  );
  const at = async () => Number(await page.locator("b.t").innerText());
  await slide(page, "Time", 0.5);
  const evenly = await at();
  await page.getByRole("radio", { name: "raw t" }).check();
  assert.equal(await at(), 4);
  assert.notEqual(evenly, 4);
});

test("camera: the code on the page finds the place on the page", async (t) => {
  const page = await open(t, "/camera/");
  await slide(page, "Time", 0.37);
  const code = await page.locator("camera-path pre").innerText();
  const [, body, , place] = code.match(/^import .+?;\n(.*)\n(cameraAt\(0\.37\))\.position; \/\/ \((.+)\)$/s) ?? [];
  const cameraAt = new Function("Spline", `${body}; return cameraAt;`)(Spline);
  const { position, forward, up } = cameraAt(0.37);
  place
    .replaceAll("−", "-")
    .split(", ")
    .forEach((text, k) => close(position[k], Number(text), 1e-3));
  close(forward[0] * up[0] + forward[1] * up[1] + forward[2] * up[2], 0, 1e-12);
});

test("camera: Frenet's frame leaps where the bend changes sides, the minimising one never", async (t) => {
  const page = await open(t, "/camera/");
  assert.ok(parseFloat(await page.locator("b.leap").innerText()) > 90);
  const ups = (kind) =>
    page.evaluate(async (kind) => {
      const camera = document.querySelector("camera-path");
      camera.state = { ...camera.state, frames: kind };
      await camera.updateComplete;
      return camera.frames.map(({ normal }) => normal);
    }, kind);
  const least = (list) =>
    Math.min(...list.slice(1).map((n, i) => n[0] * list[i][0] + n[1] * list[i][1] + n[2] * list[i][2]));
  assert.ok(least(await ups("minimising")) > 0.9);
  assert.ok(least(await ups("frenet")) < 0);
  assert.ok((await ups("upright")).every((normal) => normal[2] > 0.5));
});

test("camera: points are moved by hand and keys, added, deleted; the address has them", async (t) => {
  const page = await open(t, "/camera/");
  const points = () => page.evaluate(() => document.querySelector("camera-path").state.points);
  const before = await points();
  const handle = page.locator(".handle").nth(3);
  await dragBy(page, handle, 40, -20);
  const after = await points();
  const moved = after[3].map((value, k) => value - before[3][k]);
  assert.ok(moved[0] > 0.5 && moved[1] > 0.2 && moved[2] === 0, String(moved));
  close(moved[0], 2 * moved[1], 0.02); // pixels are not divided
  await page.keyboard.press("ArrowRight");
  close((await points())[3][0], after[3][0] + 0.1, 1e-9);
  await slide(page, "Height of point 4", 6);
  assert.equal((await points())[3][2], 6);
  await page.getByRole("button", { name: "Add a point after 4" }).click();
  assert.equal((await points()).length, before.length + 1);
  await page.getByRole("button", { name: "Delete point 4" }).click();
  assert.equal((await points()).length, before.length);
  const kept = (await state(page)).points;
  await page.reload();
  await page.waitForFunction(
    (kept) => JSON.stringify(document.querySelector("camera-path").state.points) === kept,
    JSON.stringify(kept),
  );
});

test("camera: Escape takes a drag back; playing moves, pausing stops", async (t) => {
  const page = await open(t, "/camera/");
  const points = () => page.evaluate(() => JSON.stringify(document.querySelector("camera-path").state.points));
  const before = await points();
  const handle = page.locator(".handle").nth(2);
  await handle.scrollIntoViewIfNeeded();
  await pullFrom(page, await centreOf(handle), 50, 0, 2);
  assert.notEqual(await points(), before);
  await page.keyboard.press("Escape");
  assert.equal(await points(), before);
  await page.mouse.up();
  await page.getByRole("button", { name: "Play" }).click();
  await page.waitForFunction(() => document.querySelector("camera-path").progress > 0.01);
  await page.getByRole("button", { name: "Pause" }).click();
  const stood = await page.evaluate(() => document.querySelector("camera-path").progress);
  await frames(page);
  assert.equal(await page.evaluate(() => document.querySelector("camera-path").progress), stood);
});

test("camera: a frame whose time is before the click moves nothing", async (t) => {
  const page = await open(t, "/camera/");
  const progress = await page.evaluate(async () => {
    const camera = document.querySelector("camera-path");
    camera.state = { ...camera.state, frames: "frenet", even: false };
    await camera.updateComplete;
    const request = globalThis.requestAnimationFrame;
    /** @type {FrameRequestCallback[]} */
    const frames = [];
    globalThis.requestAnimationFrame = (callback) => frames.push(callback);
    camera.play();
    frames[0](performance.now() - 1000);
    globalThis.requestAnimationFrame = request;
    camera.stop();
    await camera.updateComplete;
    return camera.progress;
  });
  assert.equal(progress, 0);
});

test("camera: both pictures are drawn, and change with the time and the theme", async (t) => {
  const page = await open(t, "/camera/");
  const picture = (id) =>
    page.evaluate(async (id) => {
      const camera = document.querySelector("camera-path");
      await camera.updateComplete;
      const canvas = camera.shadowRoot.getElementById(id);
      const data = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
      return { inked: data.filter((value, i) => i % 4 === 3 && value > 60).length, url: canvas.toDataURL() };
    }, id);
  for (const id of ["eye", "outside"]) {
    const first = await picture(id);
    assert.ok(first.inked > 2000, `${id}: ${first.inked}`);
    await slide(page, "Time", 0.3);
    const second = await picture(id);
    assert.notEqual(second.url, first.url);
    await page.emulateMedia({ colorScheme: "dark" });
    await page.waitForFunction(
      ([id, url]) => document.querySelector("camera-path").shadowRoot.getElementById(id).toDataURL() !== url,
      [id, second.url],
    );
    await page.emulateMedia({ colorScheme: "light" });
    await slide(page, "Time", 0);
  }
});
