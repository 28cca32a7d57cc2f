// <bezier-applet>: joints and points by hand: modes, modifiers while dragging, keys that cut and heal, matrix, fingers.
// tests/js/applet-joints.test.js, applet-state.test.js and element-applet.test.js have the rules.
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  ask,
  centre,
  drag,
  FIRST,
  focus,
  message,
  openApplet,
  points,
  pointsText,
  press,
  pull,
  set,
  settled,
} from "./bezier-applet-page.js";
import { boxOf } from "./browser.js";
import { assertNear, fingersOn } from "./gestures.js";

const joints = (page) => ask(page, () => a.joints);
const continuity = (page, mode) => page.evaluate((mode) => a.figure.continuity.map((each) => each[mode]), mode);
const THREE = "60,300 100,100 200,100 250,250 300,380 380,400 430,240 470,100 560,120 610,300";

test("each joint has its own mode: by its control, by Enter on its point; it is held in the midst of a drag", async (t) => {
  const page = await openApplet(t, `controls points="${THREE}"`);
  await page.getByLabel("At P6 hold").selectOption("c1");
  await settled(page);
  assert.deepEqual(
    [await joints(page), await continuity(page, "c1")],
    [
      ["free", "c1"],
      [false, true],
    ],
  );
  await focus(page, 3);
  await press(page, "Enter");
  assert.deepEqual(await joints(page), ["g1", "c1"]);
  await pull(page, 4, 70, 10); // far from where it would click into place
  assert.deepEqual(
    [await continuity(page, "g1"), await continuity(page, "c1")],
    [
      [true, true],
      [false, true],
    ],
  );
  await page.mouse.up();
  await settled(page);
  assert.equal(await ask(page, () => a.getAttribute("joints")), "g1 c1");
  assert.match(
    await page.locator("bezier-applet .joints li").first().innerText(),
    /^G1[\s\S]*At P3 hold[\s\S]*tangents 1 : /,
  );
});

test("while dragging, a point clicks into place beside a joint; Ctrl prevents it, Shift turns by 15°, Alt breaks the joint", async (t) => {
  const page = await openApplet(t, 'points="60,300 100,100 200,150 300,240 400,300 500,400 600,300"');
  const dragWith = async (key, index, dx, dy) => {
    await page.keyboard.down(key);
    await drag(page, index, dx, dy);
    await page.keyboard.up(key);
  };
  await drag(page, 4, 2, 27);
  assert.deepEqual((await points(page))[4], [400, 330], "the mirror image of P2");
  await dragWith("Control", 4, 2, 2);
  assert.deepEqual([(await points(page))[4], await continuity(page, "g1")], [[402, 332], [false]]);
  await dragWith("Shift", 1, 83, 41);
  const [[x, y], [ax, ay]] = [(await points(page))[1], (await points(page))[0]];
  const steps = (Math.atan2(y - ay, x - ax) * 12) / Math.PI;
  assertNear([steps], [Math.round(steps)], 1e-4);
  await set(page, { joints: ["c1"] });
  const held = await pointsText(page);
  await dragWith("Alt", 4, 40, -50);
  assert.deepEqual([(await points(page))[2], await joints(page)], [[200, 150], ["free"]]);
  await ask(page, () => a.undo());
  assert.deepEqual([await pointsText(page), await joints(page)], [held, ["c1"]], "one step");
});

test("i splits the segment at t, Delete joins it again, Shift+Delete removes the point alone; a refusal is announced", async (t) => {
  const page = await openApplet(t, 't="0.3"');
  await focus(page, 5);
  await press(page, "i");
  assert.deepEqual([(await points(page)).length, await joints(page)], [10, ["free", "g1"]]);
  assert.ok((await pointsText(page)).startsWith(FIRST.slice(0, 29)), "the first segment is not touched");
  await focus(page, 6);
  await press(page, "Delete");
  assertNear(
    await points(page),
    FIRST.split(" ").map((pair) => pair.split(",").map(Number)),
    1e-9,
    "healed",
  );
  assert.equal(await ask(page, () => a.shadowRoot.activeElement.getAttribute("aria-label")), "P6 x");
  await press(page, "Control+z", 2);
  assert.equal(await pointsText(page), FIRST);
  await set(page, { points: "0,0 100,100 200,0 300,300" });
  await focus(page, 0);
  await press(page, "Delete");
  assert.match(await message(page), /only segment/);
  await focus(page, 1);
  await press(page, "Shift+Delete");
  assert.deepEqual([await pointsText(page), await message(page)], ["0,0 200,0 300,300", ""]);
});

test("a matrix of one's own begins with the basis before, and can be edited", async (t) => {
  const page = await openApplet(t, "controls");
  for (const basis of ["b-spline", "matrix"]) await page.getByRole("combobox", { name: "Basis" }).selectOption(basis);
  await settled(page);
  const matrix = () => ask(page, () => a.state.matrix);
  assertNear((await matrix()).slice(0, 4), [-1 / 6, 0.5, -0.5, 1 / 6], 1e-12);
  for (const [text, words] of /** @type {[string, RegExp][]} */ ([
    ["1", /^$/],
    ["", /matrix\[12\]: expected a number/],
  ])) {
    await page.getByLabel("row 4, column 1").fill(text);
    await page.getByLabel("row 4, column 1").press("Tab");
    await settled(page);
    assert.deepEqual([(await matrix())[12], words.test(await message(page))], [1, true]);
  }
});

test("two fingers on points move both, in one step; on the picture they enlarge it", async (t) => {
  const page = await openApplet(t, "", { hasTouch: true });
  const touch = await fingersOn(page);
  const [[x1, y1], [x2, y2]] = [await centre(page, 1), await centre(page, 5)];
  await touch("touchStart", [x1, y1]);
  await touch("touchStart", [x1, y1], [x2, y2]);
  await touch("touchMove", [x1 + 30, y1 + 10], [x2 - 40, y2 - 60]);
  await touch("touchEnd");
  await settled(page);
  const after = await points(page);
  assertNear([after[1], after[5]], [140, 100, 550, 340], 1);
  await ask(page, () => a.undo());
  assert.equal(await pointsText(page), FIRST);
  const { x, y } = await boxOf(page.locator("bezier-applet .overlay"));
  await touch("touchStart", [x + 400, y + 100]);
  await touch("touchStart", [x + 400, y + 100], [x + 440, y + 100]);
  for (const d of [10, 20, 30, 40]) await touch("touchMove", [x + 400 - d, y + 100], [x + 440 + d, y + 100]);
  await touch("touchEnd");
  await settled(page);
  const width = await ask(page, () => a.view.width);
  assert.ok(width > 150 && width < 300, `${width}`);
});
