// <bezier-surface>: what hands do to it.
import assert from "node:assert/strict";
import { test } from "node:test";
import { canvasBox, difference, facts, look, openSurface, set, settled } from "./surface-page.js";
import { centreOf, downloadBy, dragFrom, fingersOn, pullFrom } from "./gestures.js";

const view = (page) => page.evaluate(() => document.querySelector("bezier-surface").view);
const middle = (page) => centreOf(page.locator("bezier-surface canvas"));
const handle = (page, index) => page.locator(`bezier-surface .handle[data-index="${index}"]`);
const centre = (page, index) => centreOf(handle(page, index));
/** Counts the element's events from now on. */
const listen = (page) =>
  page.evaluate(() => {
    globalThis.heard = { input: 0, change: 0 };
    for (const type of ["input", "change"])
      document
        .querySelector("main")
        .addEventListener(
          type,
          (/** @type {any} */ event) => event.target.localName === "bezier-surface" && heard[type]++,
        );
  });
const heard = (page) => page.evaluate(() => ({ ...globalThis.heard }));

async function drag(page, place, dx, dy) {
  await dragFrom(page, place, dx, dy, 5);
  await settled(page);
}

test("dragging rotates the view, with Shift it pans; events report it", async (t) => {
  const page = await openSurface(t, 'segments="4"');
  await listen(page);
  const before = await view(page);
  const first = await look(page);
  await drag(page, await middle(page), 60, -20);
  const turned = await view(page);
  assert.ok(Math.abs(turned.turn - before.turn - 24) < 4 && turned.tilt < before.tilt, JSON.stringify(turned));
  assert.ok((await difference(page, first, await look(page))) > 5000);
  const told = await heard(page);
  assert.ok(told.input >= 1 && told.change === 1, JSON.stringify(told));
  await page.keyboard.down("Shift");
  await drag(page, await middle(page), 50, 0);
  await page.keyboard.up("Shift");
  const shifted = await view(page);
  assert.ok(shifted.panX > 0.05 && shifted.turn === turned.turn, JSON.stringify(shifted));
});

test("keys turn, shift, zoom and go home; so do the buttons", async (t) => {
  const page = await openSurface(t);
  const home = await view(page);
  await page.locator("bezier-surface canvas").focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowUp");
  assert.deepEqual(await view(page), { ...home, turn: home.turn + 5, tilt: home.tilt - 5 });
  await page.keyboard.press("Shift+ArrowRight");
  await page.keyboard.press("+");
  const zoomed = await view(page);
  assert.ok(zoomed.zoom > 1.1 && zoomed.panX > 0, JSON.stringify(zoomed));
  await page.keyboard.press("-");
  await page.keyboard.press("0");
  assert.deepEqual(await view(page), home);
  await page.getByRole("button", { name: "Nearer" }).click();
  assert.ok((await view(page)).zoom > 1.1);
  await page.getByRole("button", { name: "First view" }).click();
  assert.deepEqual(await view(page), home);
});

test("the wheel scrolls the page until the picture has the focus", async (t) => {
  const page = await openSurface(t, "controls", { viewport: { width: 700, height: 400 } });
  await page.mouse.move(...(await middle(page)));
  await page.mouse.wheel(0, 60);
  await page.waitForFunction(() => scrollY > 0);
  assert.equal((await view(page)).zoom, 1);
  await page.evaluate(() => scrollTo(0, 0));
  await page.locator("bezier-surface canvas").evaluate((canvas) => canvas.focus({ preventScroll: true }));
  await page.mouse.wheel(0, -200);
  await page.waitForFunction(() => document.querySelector("bezier-surface").view.zoom > 1.1);
  assert.equal(await page.evaluate(() => scrollY), 0);
});

test("one finger turns, two zoom", async (t) => {
  const page = await openSurface(t, "", { hasTouch: true });
  const [x, y] = await middle(page);
  const touch = await fingersOn(page);
  await touch("touchStart", [x, y]);
  for (const dx of [10, 30, 50]) await touch("touchMove", [x + dx, y]);
  await touch("touchEnd");
  const turned = await view(page);
  assert.ok(turned.turn > -30, JSON.stringify(turned));
  for (const [k, d] of [40, 50, 70, 80].entries()) await touch(k ? "touchMove" : "touchStart", [x - d, y], [x + d, y]);
  await touch("touchEnd");
  const zoomed = await view(page);
  assert.ok(zoomed.zoom > 1.6 && zoomed.zoom < 2.4, JSON.stringify(zoomed));
});

test("a control point is dragged in the plane of the picture, and Escape or a cancelled pointer takes it back", async (t) => {
  const page = await openSurface(t, 'model="patch" show="surface net"');
  await listen(page);
  const vertex = () =>
    page.evaluate(() => [...document.querySelector("bezier-surface").surface.vertices.slice(15, 18)]);
  const before = await vertex();
  const [x, y] = await centre(page, 5);
  await drag(page, [x, y], 40, 30);
  const [ax, ay] = await centre(page, 5);
  assert.ok(Math.hypot(ax - x - 40, ay - y - 30) < 0.5, "the handle follows the pointer");
  const after = await vertex();
  assert.notDeepEqual(after, before);
  assert.equal((await heard(page)).change, 1);
  await pullFrom(page, [ax, ay], 30, 30);
  await page.keyboard.press("Escape");
  await page.mouse.up();
  await settled(page);
  assert.deepEqual(await vertex(), after);
  await pullFrom(page, [ax, ay], -30, 0);
  await settled(page);
  assert.notDeepEqual(await vertex(), after);
  await handle(page, 5).evaluate((button) =>
    button.dispatchEvent(new PointerEvent("pointercancel", { pointerId: 1, bubbles: true, composed: true })),
  );
  await page.mouse.up();
  assert.deepEqual(await vertex(), after);
});

test("keys move a control point, in depth too", async (t) => {
  const page = await openSurface(t, 'model="patch"');
  const [x, y] = await centre(page, 5);
  await handle(page, 5).focus();
  await page.keyboard.press("ArrowRight");
  await settled(page);
  const [bx, by] = await centre(page, 5);
  assert.ok(Math.abs(bx - x - 4) < 0.5 && Math.abs(by - y) < 0.5, `${bx - x}, ${by - y}`);
  const before = await look(page);
  for (let i = 0; i < 5; i++) await page.keyboard.press("Shift+PageUp");
  await settled(page);
  assert.ok((await difference(page, before, await look(page), 4)) > 500);
});

test("parts of the panel by the words of `controls`", async (t) => {
  const page = await openSurface(t, 'controls="shading mesh"');
  const labels = () => page.locator("bezier-surface .controls label.line > span:first-child").allInnerTexts();
  assert.deepEqual(await labels(), ["Shading", "Fineness", "Segments", "Computed"]);
  await set(page, { controls: "shape" });
  assert.deepEqual(await labels(), ["Shape"]);
  await set(page, { controls: false });
  assert.equal(await page.locator("bezier-surface .controls").count(), 0);
});

test("the controls set the properties, which reflect", async (t) => {
  const page = await openSurface(t, "controls");
  await listen(page);
  await page.getByLabel("Shading").selectOption("flat");
  await page.getByLabel("lid").uncheck();
  await page.getByLabel("mesh", { exact: true }).check();
  await page.getByRole("slider", { name: "Segments" }).fill("4");
  await settled(page);
  const attributes = await page.evaluate(() =>
    ["shading", "parts", "show", "segments"].map((name) => document.querySelector("bezier-surface").getAttribute(name)),
  );
  assert.deepEqual(attributes, ["flat", "rim body handle spout bottom", "surface mesh", "4"]);
  assert.equal((await facts(page)).triangles, 24 * 2 * 16);
  const told = await heard(page);
  assert.ok(told.input >= 1 && told.change >= 4, JSON.stringify(told));
  await page.getByLabel("Fineness").selectOption("tolerance");
  await settled(page);
  assert.match((await facts(page)).text, /error ≤ 0\.0/);
});

test("de Casteljau's grid goes step by step", async (t) => {
  const page = await openSurface(t, 'model="patch" show="surface casteljau" step="1" controls');
  let before = await look(page);
  for (let step = 2; step <= 4; step++) {
    await page.getByRole("button", { name: "Next step" }).click();
    await settled(page);
    const now = await look(page);
    assert.ok((await difference(page, before, now)) > 50, `step ${step}`);
    before = now;
  }
  assert.ok(await page.getByRole("button", { name: "Next step" }).isDisabled());
});

test("what the page writes fires nothing", async (t) => {
  const page = await openSurface(t, 'model="patch"');
  await listen(page);
  await set(page, { segments: 3, shading: "flat", view: { turn: 10 } });
  assert.deepEqual(await heard(page), { input: 0, change: 0 });
});

test("a click picks the patch under it, which gets handles; a click beside takes them away", async (t) => {
  const page = await openSurface(t);
  assert.equal(await page.locator("bezier-surface .handle").count(), 0);
  const [x, y] = await middle(page);
  await page.mouse.click(x, y);
  await settled(page);
  assert.equal(await page.locator("bezier-surface .handle").count(), 16);
  const picked = await page.evaluate(() => document.querySelector("bezier-surface").patch);
  assert.ok(picked >= 4 && picked < 12, `in the middle is the body, got patch ${picked}`);
  const before = await page.evaluate(() => [...document.querySelector("bezier-surface").surface.vertices]);
  await drag(page, await centre(page, 5), 20, 10);
  const after = await page.evaluate(() => [...document.querySelector("bezier-surface").surface.vertices]);
  assert.equal(after.filter((x, i) => x !== before[i]).length <= 3, true, "one vertex moves");
  assert.notDeepEqual(after, before);
  const { x: left, y: top } = await canvasBox(page);
  await page.mouse.click(left + 8, top + 8);
  await settled(page);
  assert.equal(await page.locator("bezier-surface .handle").count(), 0);
});

test("the mesh is taken away as OBJ, STL and GLB, the picture as PNG", async (t) => {
  const page = await openSurface(t, 'controls segments="4"');
  const save = (name) => downloadBy(page.getByRole("button", { name, exact: true }));
  const obj = await save("OBJ");
  assert.equal(obj.name, "teapot.obj");
  assert.match(obj.bytes.toString(), /^f \d+/m);
  const stl = await save("STL");
  assert.equal(stl.bytes.length, 84 + 50 * stl.bytes.readUInt32LE(80));
  assert.ok(stl.bytes.readUInt32LE(80) > 900, "almost all triangles: those at the poles are gone");
  const glb = await save("GLB");
  assert.equal(glb.bytes.toString("latin1", 0, 4), "glTF");
  const max = JSON.parse(glb.bytes.toString("utf8", 20, 20 + glb.bytes.readUInt32LE(12))).accessors.find(
    ({ max }) => max?.length === 3,
  ).max;
  assert.ok(Math.abs(max[1] - 3.15) < 0.01, `y is up: ${max}`);
  const png = await save("PNG");
  assert.equal(png.bytes.toString("latin1", 1, 4), "PNG");
});
