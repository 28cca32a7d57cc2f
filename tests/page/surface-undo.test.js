// <bezier-surface>: what the user changes can be undone and redone.
import assert from "node:assert/strict";
import { test } from "node:test";
import { centreOf, dragFrom, fingersOn, pullFrom } from "./gestures.js";
import { openSurface, settled } from "./surface-page.js";

/** What undo restores, and what it does not. */
const stateOf = (page) =>
  page.evaluate(() => {
    const element = document.querySelector("bezier-surface");
    const { model, shading, segments, u } = element;
    return { point: [...element.surface.vertices.slice(15, 18)], model, shading, segments, u };
  });
const handle = (page, index) => page.locator(`bezier-surface .handle[data-index="${index}"]`);
const press = async (page, keys) => {
  await page.keyboard.press(keys);
  await settled(page);
};

test("a drag is one step, a key another one; redo repeats them", async (t) => {
  const page = await openSurface(t, 'model="patch" show="surface net" controls');
  const first = await stateOf(page);
  await dragFrom(page, await centreOf(handle(page, 5)), 30, 20, 5);
  await settled(page);
  const dragged = await stateOf(page);
  await press(page, "ArrowRight");
  const moved = await stateOf(page);
  assert.notDeepEqual(dragged.point, first.point);
  assert.notDeepEqual(moved.point, dragged.point);

  const [undo, redo] = ["Undo", "Redo"].map((name) => page.getByRole("button", { name, exact: true }));
  await press(page, "Control+z");
  assert.deepEqual(await stateOf(page), dragged);
  await undo.click();
  await settled(page);
  assert.deepEqual(await stateOf(page), first);
  assert.ok(await undo.isDisabled());
  await redo.click();
  await settled(page);
  assert.deepEqual(await stateOf(page), dragged);
  await handle(page, 5).focus();
  await press(page, "Control+Shift+z");
  assert.deepEqual(await stateOf(page), moved);
  assert.ok(await redo.isDisabled());
});

test("two fingers that drag two points make one step and one event `change`", async (t) => {
  const page = await openSurface(t, 'model="patch"', { hasTouch: true });
  const vertices = () => page.evaluate(() => [...document.querySelector("bezier-surface").surface.vertices]);
  const first = await vertices();
  await page.evaluate(() => {
    globalThis.changes = 0;
    document.querySelector("bezier-surface").addEventListener("change", () => globalThis.changes++);
  });
  const touch = await fingersOn(page);
  const [a, b] = [await centreOf(handle(page, 0)), await centreOf(handle(page, 15))];
  await touch("touchStart", a, b);
  await touch("touchMove", [a[0] + 10, a[1]], [b[0] - 10, b[1] + 5]);
  await settled(page);
  await touch("touchEnd");
  await settled(page);
  const moved = await vertices();
  assert.ok([0, 45].every((at) => moved[at] !== first[at]));
  assert.equal(await page.evaluate(() => globalThis.changes), 1);
  await page.evaluate(() => document.querySelector("bezier-surface").undo());
  assert.deepEqual(await vertices(), first);
});

test("settings and another model are undone with the moves; u stays, and a drag that is taken back makes no step", async (t) => {
  const page = await openSurface(t, 'model="patch" show="surface net place" controls');
  await handle(page, 5).focus();
  await press(page, "ArrowUp");
  const moved = await stateOf(page);
  await page.getByLabel("Shading").selectOption("flat");
  await page.getByLabel("Shape").selectOption("teacup");
  await settled(page);
  await page.locator("bezier-surface input[name=u]").fill("0.25");
  await settled(page);
  assert.deepEqual(await stateOf(page).then(({ model, u }) => ({ model, u })), { model: "teacup", u: 0.25 });
  await press(page, "Control+z");
  await press(page, "Control+z");
  assert.deepEqual(await stateOf(page), { ...moved, u: 0.25 });

  await pullFrom(page, await centreOf(handle(page, 5)), 30, 30);
  await page.keyboard.press("Escape");
  await page.mouse.up();
  await settled(page);
  assert.deepEqual(await stateOf(page), { ...moved, u: 0.25 });
  await press(page, "Control+z");
  assert.notDeepEqual((await stateOf(page)).point, moved.point, "the key was the last step");
});

test("an opened file is undone", async (t) => {
  const page = await openSurface(t, 'model="patch" controls');
  const text = await page.evaluate(() => globalThis.bezier.Surface.teacup().toText());
  const patches = () => page.evaluate(() => document.querySelector("bezier-surface").surface.patchCount);
  await page
    .locator("bezier-surface input[type=file]")
    .setInputFiles({ name: "cup.txt", mimeType: "text/plain", buffer: Buffer.from(text) });
  await page.waitForFunction(() => document.querySelector("bezier-surface").surface.patchCount > 1);
  await page.locator("bezier-surface canvas").focus();
  await press(page, "Control+z");
  assert.equal(await patches(), 1);
  await press(page, "Control+y");
  assert.ok((await patches()) > 1);

  await page.evaluate(() => {
    const { Surface } = globalThis.bezier;
    const vertices = [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0];
    document.querySelector("bezier-surface").surface = new Surface(
      { vertices, patches: [[0, 1, 2, 3]] },
      { degreeU: 1, degreeV: 1 },
    );
  });
  await settled(page);
  await press(page, "Control+z");
  const vertices = await page.evaluate(() => document.querySelector("bezier-surface").surface.vertices.length / 3);
  assert.equal(vertices, 4, "a surface that the page sets stays");
});
