// <bezier-applet>: points that are dragged and moved by keys, t, undo, events, the panel, what screen readers are told.
// tests/js/element-applet.test.js has properties, methods, attributes, undo and announcements without a page.
import assert from "node:assert/strict";
import { test } from "node:test";
import { cubicAt } from "./applet-page.js";
import {
  ask,
  button,
  centre,
  drag,
  fired,
  FIRST,
  focus,
  handle,
  ink,
  message,
  openApplet,
  points,
  pointsText,
  press,
  pull,
  set,
  settled,
} from "./bezier-applet-page.js";
import { assertAccessible, assertAccessibleInBothThemes, boxOf, frames } from "./browser.js";
import { assertNear, doubleClick } from "./gestures.js";

const focused = (page) => ask(page, () => a.shadowRoot.activeElement.getAttribute("aria-label"));

test("seven points, two curves, and nothing more without controls", async (t) => {
  const page = await openApplet(t);
  assert.equal(await page.locator('bezier-applet [part="handle"]').count(), 7);
  assert.equal(await page.locator("bezier-applet button:visible").count(), 0);
  const all = await points(page);
  for (const [from, at] of [
    [0, 0.3],
    [3, 0.7],
  ])
    assert.ok((await ink(page, cubicAt(all.slice(from, from + 4), at))) > 8);
  assert.equal(
    await ask(page, () => a.outerHTML),
    '<bezier-applet id="a"></bezier-applet>',
    "what goes without saying is not written",
  );
});

test("a drag: the point follows with its grip, input and update while it moves, one change, one undo step, the attribute", async (t) => {
  const page = await openApplet(t, "controls");
  const before = await points(page);
  const [x, y] = await centre(page, 1);
  await page.mouse.move(x + 5, y - 4);
  await page.mouse.down();
  for (let i = 1; i <= 4; i++) {
    await page.mouse.move(x + 5 + 10 * i, y - 4 + 5 * i);
    await settled(page);
  }
  assert.deepEqual([...new Set(await fired(page))], ["input", "update"]);
  assert.equal(await ask(page, () => a.getAttribute("points")), null, "not yet");
  await page.mouse.up();
  await settled(page);
  assert.deepEqual(await fired(page), ["change"]);
  assertNear((await points(page))[1], [before[1][0] + 40, before[1][1] + 20], 0.01);
  assert.match(await ask(page, () => a.getAttribute("points")), /^70,330 150,110 /);
  assertNear(await centre(page, 1), [x + 40, y + 20], 0.6);
  await button(page, "Undo").click();
  assert.deepEqual(await points(page), before);
  await button(page, "Redo").click();
  assertNear((await points(page))[1], [before[1][0] + 40, before[1][1] + 20], 0.01);
});

test("Esc takes a drag back, and leaves no undo step", async (t) => {
  const page = await openApplet(t, "controls");
  await pull(page, 2, 60, 60);
  assert.notEqual(await pointsText(page), FIRST);
  await press(page, "Escape");
  assert.equal(await pointsText(page), FIRST);
  await page.mouse.up();
  await settled(page);
  assert.equal(await pointsText(page), FIRST);
  assert.ok(await button(page, "Undo").isDisabled());
});

test("a page that takes the dragged point away meanwhile: nothing breaks", async (t) => {
  const page = await openApplet(t, "controls");
  await pull(page, 6, -40, 40);
  await set(page, { points: "10,10 200,300" });
  await page.mouse.move(100, 100);
  await settled(page);
  await page.mouse.up();
  await settled(page);
  assert.deepEqual([await pointsText(page), await message(page)], ["10,10 200,300", ""]);
  await drag(page, 1, 20, -30);
  assert.equal(await pointsText(page), "10,10 220,270");
});

test("Tab goes through the points; arrows move by 1, 10 and 0.1; a held key is one undo step", async (t) => {
  const page = await openApplet(t);
  await focus(page, 0);
  for (const name of ["P1 x", "P2 x", "P3 x"]) {
    await page.keyboard.press("Tab");
    assert.equal(await focused(page), name);
  }
  await focus(page, 0);
  for (const key of ["ArrowRight", "Shift+ArrowDown", "Alt+ArrowLeft"]) await press(page, key);
  assertNear((await points(page))[0], [70.9, 340], 1e-9);
  await fired(page);
  for (let i = 0; i < 5; i++) await page.keyboard.down("ArrowUp");
  await page.keyboard.up("ArrowUp");
  assert.equal((await fired(page)).filter((type) => type === "change").length, 1);
  assertNear((await points(page))[0], [70.9, 335], 1e-9);
  await press(page, "Control+z");
  assertNear((await points(page))[0], [70.9, 340], 1e-9);
  await press(page, "Control+z", 3);
  assert.equal(await pointsText(page), FIRST);
  await press(page, "Control+Shift+z");
  await press(page, "Control+y");
  assertNear((await points(page))[0], [71, 340], 1e-9);
});

test("arrow keys stop at the edge of the picture, also of an enlarged one", async (t) => {
  const page = await openApplet(t);
  await focus(page, 0);
  await press(page, "Shift+ArrowLeft", 10);
  assert.deepEqual((await points(page))[0], [0, 330]);
  await set(page, { view: { x: 67, y: 48, width: 335, height: 240 } });
  await press(page, "ArrowDown");
  assert.deepEqual((await points(page))[0], [67, 288], "a point outside comes to the edge");
  await press(page, "ArrowRight");
  assert.deepEqual((await points(page))[0], [67.5, 288]);
});

test("r and m reach the applet that has the focus, is under the pointer, or is alone in view", async (t) => {
  const page = await openApplet(t, "", { more: `<bezier-applet id="b"></bezier-applet>` });
  const second = () => page.evaluate(() => /** @type {any} */ (document.getElementById("b")).points);
  const [first, other] = [await points(page), await second()];
  await press(page, "r");
  assert.deepEqual([await points(page), await second()], [first, other], "two are in view");
  await page.locator("#b").hover();
  await press(page, "Shift+R");
  assert.deepEqual(await points(page), first);
  const moved = await second();
  assert.notDeepEqual(moved, other, "the one under the pointer");
  await focus(page, 3);
  await press(page, "r");
  assert.deepEqual(await second(), moved);
  assert.notDeepEqual(await points(page), first, "the one with the focus");
  await page.evaluate(() => /** @type {any} */ (document.activeElement).blur());
  await page.mouse.move(2, 2);
  await page.setViewportSize({ width: 800, height: 300 });
  await press(page, "m");
  assert.equal(await ask(page, () => a.visiblePoints), 4, "the one in view");
});

test("keys are left alone in fields and in the list of keys, and can be switched off", async (t) => {
  const page = await openApplet(t, "controls", { more: `<p><input aria-label="name"></p>` });
  await page.getByRole("textbox", { name: "name" }).focus();
  for (const key of ["r", "m", "i", "Delete"]) await press(page, key);
  await ask(page, () => a.setAttribute("hotkeys", "off"));
  await page.evaluate(() => /** @type {any} */ (document.activeElement).blur());
  await press(page, "r");
  await focus(page, 3);
  for (const key of ["r", "m", "i", "Delete", "Enter"]) await press(page, key);
  assert.deepEqual(
    [await pointsText(page), await ask(page, () => [a.visiblePoints, a.joints])],
    [FIRST, [null, ["free"]]],
  );
  await press(page, "ArrowLeft");
  assert.equal((await points(page))[3][0], 324, "the arrows are the sliders' own");
  await ask(page, () => a.removeAttribute("hotkeys"));
  await press(page, "m");
  assert.equal(await ask(page, () => a.visiblePoints), 4);
  await press(page, "?");
  assert.ok(await page.getByRole("dialog", { name: "Keys" }).isVisible());
  await press(page, "m");
  assert.equal(await ask(page, () => a.visiblePoints), 4, "the list is open");
  await press(page, "Escape");
  assert.ok(!(await page.getByRole("dialog").isVisible()));
});

test("every key has a button", async (t) => {
  const page = await openApplet(t, "controls");
  for (const [name, key] of [
    [/^Split at t/, "i"],
    [/^Fewer points/, "m"],
    [/^Randomize/, "r"],
    [/^Keys/, "?"],
  ]) {
    assert.equal(await button(page, name).getAttribute("aria-keyshortcuts"), key);
  }
  await focus(page, 3);
  await button(page, "Remove P3").click();
  assert.equal((await points(page)).length, 4);
  await button(page, "Undo").click();
  assert.equal((await points(page)).length, 7);
  await button(page, "Add a point").click();
  assert.equal((await points(page)).length, 10);
  assert.equal(await focused(page), "P9 x", "the new point has the focus");
  await button(page, "Reset").click();
  assert.equal((await points(page)).length, 7);
  await button(page, /^Fewer points/).click();
  await settled(page);
  assert.equal(await page.locator('bezier-applet [part="handle"]').count(), 4);
  await button(page, /^All 7 points/).click();
});

test("a point without dragging: select, then tap; and by its coordinates", async (t) => {
  const page = await openApplet(t, "controls");
  const stage = await boxOf(page.locator("bezier-applet .overlay"));
  await button(page, "Move by taps").click();
  await handle(page, 5).click();
  await page.mouse.click(stage.x + 400, stage.y + 100);
  await settled(page);
  assertNear((await points(page))[5], [400, 100], 1);
  await page.mouse.click(stage.x + 440, stage.y + 100);
  await settled(page);
  assertNear((await points(page))[5], [440, 100], 1, "again, and no point is added by a double tap");
  assert.equal((await points(page)).length, 7);
  await page.locator("bezier-applet summary", { hasText: "Coordinates" }).click();
  const field = page.getByLabel("P0 x").and(page.locator("bezier-coordinates input"));
  await field.fill("123");
  await field.press("Tab");
  await settled(page);
  assert.equal((await points(page))[0][0], 123);
  await field.fill("");
  await field.press("Tab");
  await settled(page);
  assert.equal((await points(page))[0][0], 123, "nothing is no number");
});

test("events of the panel's controls stay inside: a page gets those of the element only", async (t) => {
  const page = await openApplet(t, "controls");
  await page.getByRole("slider", { name: "t", exact: true }).focus();
  await page.evaluate(() => {
    globalThis.heard = [];
    for (const type of ["input", "change"])
      document.querySelector("main").addEventListener(type, (event) => heard.push(event.composedPath()[0] === a));
  });
  await press(page, "ArrowRight");
  const own = await ask(page, () => heard);
  assert.ok(own.length >= 2 && own.every(Boolean), `${own}`);
});

test("attributes, properties and a double click change the picture, and the attributes follow", async (t) => {
  const page = await openApplet(
    t,
    'visible-points="4" joints="c1" show="hull" points="0,0 10,100 20,100 100,0 200,-90 300,10 310,20"',
  );
  assert.equal(await page.locator('bezier-applet [part="handle"]').count(), 4);
  await ask(page, () => a.removeAttribute("visible-points"));
  await settled(page);
  assert.equal(await page.locator('bezier-applet [part="handle"]').count(), 7);
  assert.deepEqual((await points(page))[4], [180, -100], "held from the start");
  for (const name of ["points", "show"]) await page.evaluate((name) => a.removeAttribute(name), name);
  await settled(page);
  await fired(page);
  await set(page, { show: "comb tree", t: 0.25 });
  assert.deepEqual(await fired(page), ["update"], "what the page writes is no input and no change");
  const attributes = () => ask(page, () => ["show", "t", "points"].map((name) => a.getAttribute(name)));
  assert.deepEqual(await attributes(), ["comb tree", "0.25", null]);
  const { x, y } = await boxOf(page.locator("bezier-applet .overlay"));
  await doubleClick(page, [x + 300, y + 60]);
  await settled(page);
  assert.equal((await points(page)).length, 10);
  assertNear((await points(page))[9], [300, 60], 1); // clicks come in whole pixels
  assert.deepEqual(await ask(page, () => [a.joints, a.figure.continuity.map(({ c1 }) => c1)]), [
    ["c1", "c1"],
    [false, true],
  ]);
  assert.equal((await attributes())[2], (await points(page)).join(" "));
});

test("t plays only when it is asked to, pauses, and stops when the element is taken away", async (t) => {
  const page = await openApplet(t, "controls");
  assert.equal(await ask(page, () => a.t), 0.5);
  await button(page, "Play t").click();
  await page.waitForFunction(() => a.t > 0.55);
  await button(page, "Pause").click();
  const at = await ask(page, () => a.t);
  await settled(page);
  assert.equal(await ask(page, () => a.t), at);
  await button(page, "Play t").click();
  await page.waitForFunction((before) => a.t !== before, at);
  await ask(page, () => a.remove());
  const stopped = await ask(page, () => a.t);
  await frames(page);
  assert.equal(await ask(page, () => a.t), stopped);
});

test("axe finds nothing, light and dark: panel, folded parts, dialog", async (t) => {
  const page = await openApplet(
    t,
    'controls basis="matrix" show="polygon hull construction halves weights tree segments offset ticks nearest"',
  );
  await page
    .locator("bezier-applet summary")
    .evaluateAll((all) => all.forEach((/** @type {any} */ summary) => summary.click()));
  await settled(page);
  await assertAccessibleInBothThemes(page, settled);
  await page.emulateMedia({ colorScheme: "light" });
  await focus(page, 0);
  await press(page, "?");
  await assertAccessible(page, { part: "bezier-applet" });
});

test("a screen reader finds a figure with instructions, its description from the values, two sliders a point, one live region", async (t) => {
  const page = await openApplet(t, 'joints="c1" controls="t"');
  const figure = page.getByRole("figure", { name: /Bézier curve/ });
  assert.match(await figure.innerText(), /pair of sliders/);
  const description = () => ask(page, () => a.shadowRoot.getElementById("description").textContent);
  assert.match(
    await description(),
    /2 Bézier curves of degree 3\. P0 at 70, 330; P1 at 110, 90, off the curve.*At P3: C1/,
  );
  assert.equal(await ask(page, () => a.shadowRoot.querySelectorAll('[role="status"], [aria-live]').length), 1);
  const input = page.getByLabel("P6 y");
  assert.equal(await input.getAttribute("tabindex"), "-1");
  await input.evaluate((/** @type {any} */ slider) => {
    slider.value = "100";
    slider.dispatchEvent(new Event("input", { bubbles: true }));
    slider.dispatchEvent(new Event("change", { bubbles: true }));
  });
  assert.deepEqual((await points(page))[6], [600, 380], "more is higher up");
  await page.waitForFunction(() => /P6 at 600, 380/.test(a.shadowRoot.querySelector("[role=status]").textContent));
  assert.match(await description(), /P6 at 600, 380/);
  const told = (words) =>
    page.waitForFunction(
      (pattern) => new RegExp(pattern).test(a.shadowRoot.querySelector("[role=status]").textContent),
      words,
    );
  await ask(page, () => (a.joints = ["free"]));
  await drag(page, 4, 50, 40);
  await told("^P4 at .*At P3: C0$");
  await ask(page, () => a.setAttribute("t", "seven"));
  await told('^t: expected a number from 0 to 1, got "seven"$');
});

test("read only: nothing moves, t does", async (t) => {
  const page = await openApplet(t, "readonly controls");
  const before = await points(page);
  await drag(page, 1, 50, 50);
  await page.getByRole("slider", { name: "t", exact: true }).focus();
  for (const key of ["r", "i", "m", "ArrowRight"]) await press(page, key);
  assert.deepEqual(await points(page), before);
  assert.equal(await ask(page, () => a.t), 0.51);
  assert.ok(await page.getByLabel("P0 x").isDisabled());
});
