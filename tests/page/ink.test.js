// The drawing surface: strokes by mouse and pen, undo and redo, settings, the file.
import assert from "node:assert/strict";
import { test } from "node:test";
import { open, slide, state } from "./application-page.js";
import { boxOf, frames } from "./browser.js";
import { downloadBy } from "./gestures.js";

/** Moves along a wave with the button pressed. */
async function pull(page, from, to, release = true) {
  const { x, y, width, height } = await boxOf(page.locator("ink-pad .pad"));
  const at = (part) => [x + width * (from + (to - from) * part), y + height * (0.75 + 0.15 * Math.sin(8 * part))];
  await page.mouse.move(...at(0));
  await page.mouse.down();
  for (let k = 1; k <= 40; k++) await page.mouse.move(...at(k / 40));
  if (release) await page.mouse.up();
  await frames(page, 2);
}

const strokes = (page) => page.locator("ink-pad .pad .ink").count();
const counts = async (page, row) =>
  (await page.locator("ink-pad tr").nth(row).locator("td").allInnerTexts()).map(parseFloat);

test("ink: a stroke by the mouse, undo and redo by buttons and keys", async (t) => {
  const page = await open(t, "/ink/");
  assert.equal(await strokes(page), 1);
  await pull(page, 0.1, 0.6);
  assert.equal(await strokes(page), 2);
  assert.match(await page.locator("ink-pad [role=status]").innerText(), /^2 strokes, 30\d samples/);
  await page.getByRole("button", { name: "Undo" }).click();
  assert.equal(await strokes(page), 1);
  await page.getByRole("button", { name: "Redo" }).click();
  assert.equal(await strokes(page), 2);
  await page.locator("ink-pad .pad").focus();
  await page.keyboard.press("Control+z");
  assert.equal(await strokes(page), 1);
  await page.keyboard.press("Control+Shift+z");
  assert.equal(await strokes(page), 2);
  await page.getByRole("button", { name: "Clear" }).click();
  assert.equal(await strokes(page), 0);
  await page.keyboard.press("Control+z");
  assert.equal(await strokes(page), 2);
});

test("ink: Escape gives up the stroke; it is drawn while the pointer moves", async (t) => {
  const page = await open(t, "/ink/");
  await pull(page, 0.2, 0.8, false);
  assert.ok((await strokes(page)) >= 2);
  assert.equal(await page.locator("ink-pad .view").nth(1).locator(".ink").count(), 2);
  await page.keyboard.press("Escape");
  await page.mouse.up();
  assert.equal(await strokes(page), 1);
  assert.ok(await page.getByRole("button", { name: "Undo" }).isDisabled());
});

test("ink: the drawing is there after a reload, with the same outlines; an old one makes room for new strokes", async (t) => {
  const page = await open(t, "/ink/");
  await pull(page, 0.1, 0.6);
  const paths = () => page.locator("ink-pad .pad .ink").evaluateAll((all) => all.map((path) => path.getAttribute("d")));
  const before = await paths();
  assert.equal(before.length, 2);
  const status = page.locator("ink-pad [role=status]");
  assert.match(await status.innerText(), /The drawing is kept in this browser\.$/);
  const reload = async () => {
    await page.reload();
    await page.locator("ink-pad .pad").waitFor();
  };
  await reload();
  assert.deepEqual(await paths(), before);
  await page.getByRole("button", { name: "Clear" }).click();
  await reload();
  assert.equal(await strokes(page), 0);
  // A drawing with a stroke that is as long as all that is kept.
  const samples = Array.from({ length: 24_000 }, (_, k) => [100.25 + (k % 400), 100.25 + (k % 7), 0.125, 100.5 + k]);
  await page.evaluate((samples) => {
    const pad = document.querySelector("ink-pad");
    pad.outlinesOf = () => ({
      ours: { d: "", nodes: "", count: 0, error: 0 },
      theirs: { d: "", nodes: "", count: 0, error: 0 },
    });
    pad.add({ device: true, samples });
    pad.add({ device: true, samples: samples.slice(0, 10) });
    return pad.updateComplete;
  }, samples);
  assert.match(await status.innerText(), /Only the last 1 are kept/);
  await reload();
  assert.equal(await strokes(page), 1);
  for (const foreign of [
    "[",
    "7",
    '{"height":1e9,"strokes":[]}',
    '{"height":300,"strokes":[{"device":true,"samples":[[1,2]]}]}',
    `"${"x".repeat(600_000)}"`,
  ]) {
    await page.evaluate((text) => localStorage.setItem("casteljau-ink", text), foreign);
    await reload();
    assert.equal(await strokes(page), 1, "the sample stroke");
    assert.match(await status.innerText(), /^1 stroke, 260 samples/);
  }
});

test("ink: a drawing of a phone is shown as a whole on a wider surface; what leaves the surface does not enlarge it", async (t) => {
  const page = await open(t, "/ink/", { viewport: { width: 500, height: 800 } });
  /** Waits until the surface has this height in units. */
  const height = (units) => page.locator(`ink-pad .pad[viewBox="0 0 600 ${units}"]`).waitFor();
  await height(540);
  await pull(page, 0.1, 0.6);
  await page.setViewportSize({ width: 1280, height: 800 });
  await page.reload();
  await page.locator("ink-pad .pad").waitFor();
  await height(540);
  await page.getByRole("button", { name: "Clear" }).click();
  await height(324);
  await page.evaluate(() => scrollTo(0, 0)); // the click has scrolled to the button
  const surface = await boxOf(page.locator("ink-pad .pad"));
  const middle = /** @type {const} */ ([surface.x + surface.width / 2, surface.y + surface.height / 2]);
  await page.mouse.move(...middle);
  await page.mouse.down();
  await page.mouse.move(middle[0], surface.y + surface.height + 100, { steps: 5 });
  await page.mouse.up();
  await frames(page);
  assert.equal(await strokes(page), 1);
  assert.equal(await page.locator("ink-pad .pad").getAttribute("viewBox"), "0 0 600 324");
});

test("ink: a pen's pressure is the width, and settings change all strokes", async (t) => {
  const page = await open(t, "/ink/");
  await page.getByRole("button", { name: "Clear" }).click();
  await slide(page, "Thinning", 1);
  await page.locator("ink-pad .pad").evaluate((pad) => {
    const { left, top, width, height } = pad.getBoundingClientRect();
    const fire = (type, part) =>
      pad.dispatchEvent(
        new PointerEvent(type, {
          ...{ pointerId: 7, pointerType: "pen", bubbles: true, composed: true, button: 0 },
          ...{ clientX: left + width * (0.1 + 0.8 * part), clientY: top + height / 2, pressure: 0.1 + 0.8 * part },
        }),
      );
    pad.setPointerCapture = () => {};
    fire("pointerdown", 0);
    for (let k = 1; k <= 50; k++) fire("pointermove", k / 50);
    fire("pointerup", 1);
  });
  const heights = () =>
    page.locator("ink-pad .pad .ink").evaluate((element) => {
      const path = /** @type {SVGPathElement} */ (element);
      const point = (x, y) => new DOMPoint(x, y);
      const extent = (x) =>
        Array.from({ length: 300 }, (_, y) => path.isPointInFill(point(x, y))).filter(Boolean).length;
      return [extent(100), extent(500)];
    });
  const [thin, thick] = await heights();
  assert.ok(thin <= 6 && thick >= 16, `${thin} ${thick}`);
  await slide(page, "Size", 24);
  assert.ok((await heights())[1] >= 32);
  assert.equal((await state(page)).size, 24);
});

test("ink: fewer curves and a smaller distance than perfect-freehand; the file has the same outlines", async (t) => {
  const page = await open(t, "/ink/");
  const [ours, theirs] = await counts(page, 1);
  assert.ok(ours < theirs, `${ours} ${theirs}`);
  const [near, far] = await counts(page, 3);
  assert.ok(near <= 0.3 && near < far, `${near} ${far}`);
  await page.getByRole("checkbox", { name: "Show the points" }).check();
  assert.equal(await page.locator("ink-pad .nodes").count(), 2);
  const { name, bytes } = await downloadBy(page.getByRole("button", { name: "Download SVG" }));
  assert.equal(name, "ink.svg");
  const drawn = await page.locator("ink-pad .pad .ink").getAttribute("d");
  assert.ok(bytes.toString().includes(`<path d="${drawn}"/>`));
});
