// <bezier-applet>: points that are dragged and moved by keys, t, undo, events, attributes, the state.
import assert from "node:assert/strict";
import { test } from "node:test";
import { boxOf, assertAccessible, assertAccessibleInBothThemes, doubleClick } from "./browser.js";
import {
  ask,
  button,
  centre,
  cubicAt,
  drag,
  fired,
  focus,
  handle,
  ink,
  message,
  openApplet,
  points,
  press,
  pull,
  set,
  settled,
} from "./bezier-applet-page.js";

const near = (got, expected, slack, name) =>
  expected
    .flat()
    .forEach((x, i) =>
      assert.ok(
        Math.abs(got.flat()[i] - x) <= slack,
        `${name ?? ""} ${JSON.stringify(got)}, not ${JSON.stringify(expected)}`,
      ),
    );

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
  near((await points(page))[1], [before[1][0] + 40, before[1][1] + 20], 0.01);
  assert.match(await ask(page, () => a.getAttribute("points")), /^70,330 150,110 /);
  near(await centre(page, 1), [x + 40, y + 20], 0.6);
  await button(page, "Undo").click();
  assert.deepEqual(await points(page), before);
  await button(page, "Redo").click();
  near((await points(page))[1], [before[1][0] + 40, before[1][1] + 20], 0.01);
});

test("Esc and a lost pointer take a drag back, and leave no undo step", async (t) => {
  const page = await openApplet(t, "controls");
  const before = await points(page);
  await pull(page, 2, 60, 60);
  assert.notDeepEqual(await points(page), before);
  await press(page, "Escape");
  assert.deepEqual(await points(page), before);
  await page.mouse.up();
  await pull(page, 2, 30, 60);
  await page.evaluate(() =>
    a.shadowRoot
      .querySelector('[data-index="2"]')
      .dispatchEvent(new PointerEvent("pointercancel", { pointerId: 1, bubbles: true })),
  );
  await settled(page);
  assert.deepEqual(await points(page), before);
  assert.ok(await button(page, "Undo").isDisabled());
});

test("a page that takes the dragged point away meanwhile: nothing breaks", async (t) => {
  const page = await openApplet(t, "controls");
  await pull(page, 6, -40, 40);
  await ask(page, () => {
    a.points = [
      [10, 10],
      [200, 300],
    ];
  });
  await settled(page);
  await page.mouse.move(100, 100);
  await settled(page);
  await page.mouse.up();
  await settled(page);
  assert.deepEqual(
    [await points(page), await message(page)],
    [
      [
        [10, 10],
        [200, 300],
      ],
      "",
    ],
  );
  await drag(page, 1, 20, -30);
  assert.deepEqual((await points(page))[1], [220, 270]);
});

test("arrows move by 1, 10 and 0.1; a held key is one undo step", async (t) => {
  const page = await openApplet(t);
  await focus(page, 0);
  await press(page, "ArrowRight");
  await press(page, "Shift+ArrowDown");
  await press(page, "Alt+ArrowLeft");
  near((await points(page))[0], [70.9, 340], 1e-9);
  await fired(page);
  for (let i = 0; i < 5; i++) await page.keyboard.down("ArrowUp");
  await page.keyboard.up("ArrowUp");
  assert.equal((await fired(page)).filter((type) => type === "change").length, 1);
  near((await points(page))[0], [70.9, 335], 1e-9);
  await press(page, "Control+z");
  near((await points(page))[0], [70.9, 340], 1e-9);
  await press(page, "Control+z", 3);
  assert.deepEqual((await points(page))[0], [70, 330]);
  await press(page, "Control+Shift+z");
  await press(page, "Control+y");
  near((await points(page))[0], [71, 340], 1e-9);
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
  assert.equal(await ask(page, () => a.mode), "4", "the one in view");
});

test("Reset restores what the page set before the first action", async (t) => {
  const page = await openApplet(t, "controls");
  const given = [
    [100, 300],
    [150, 100],
    [400, 120],
    [500, 310],
  ]; // prettier-ignore
  await set(page, { points: given });
  await focus(page, 1);
  await press(page, "ArrowLeft");
  assert.equal((await points(page))[1][0], 149);
  await button(page, "Reset").click();
  await settled(page);
  assert.deepEqual(await points(page), given);
});

test("keys are left alone in fields, and can be switched off", async (t) => {
  const page = await openApplet(t, "controls", { more: `<p><input aria-label="name"></p>` });
  const before = await points(page);
  await page.getByRole("textbox", { name: "name" }).focus();
  for (const key of ["r", "m", "i", "Delete"]) await press(page, key);
  assert.deepEqual(await points(page), before);
  await ask(page, () => a.setAttribute("hotkeys", "off"));
  await page.evaluate(() => /** @type {any} */ (document.activeElement).blur());
  await press(page, "r");
  assert.deepEqual(await points(page), before);
  await focus(page, 3);
  for (const key of ["r", "m", "i", "Delete", "Enter"]) await press(page, key);
  assert.deepEqual(await points(page), before);
  assert.deepEqual(await ask(page, () => [a.mode, a.joints]), ["", ["free"]]);
  await press(page, "ArrowLeft");
  assert.equal((await points(page))[3][0], before[3][0] - 1, "the arrows are the sliders' own");
  await ask(page, () => a.removeAttribute("hotkeys"));
  await press(page, "m");
  assert.equal(await ask(page, () => a.mode), "4");
  await press(page, "m");
  await press(page, "r");
  const random = await points(page);
  random.forEach(([x, y], i) => assert.ok(x >= 0 && x <= 670 && y >= 0 && y <= 480 && x !== before[i][0]));
  await press(page, "?");
  assert.ok(await page.getByRole("dialog", { name: "Keys" }).isVisible());
  await press(page, "r");
  assert.deepEqual(await points(page), random, "the list is open");
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
  assert.equal(
    await ask(page, () => a.shadowRoot.activeElement.getAttribute("aria-label")),
    "P9 x",
    "the new point has the focus",
  );
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
  near((await points(page))[5], [400, 100], 1);
  await page.mouse.click(stage.x + 440, stage.y + 100);
  await settled(page);
  near((await points(page))[5], [440, 100], 1, "again, and no point is added by a double tap");
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

test("the panel's own events stay inside: what is heard is the element's", async (t) => {
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

test("Reset gives back what the page gave", async (t) => {
  const given = [
    [10, 10],
    [100, 200],
    [300, 200],
    [400, 10],
  ];
  const page = await openApplet(t, `controls points="${given.join(" ")}" t="0.25"`);
  await button(page, "Reset").click();
  assert.deepEqual(await points(page), given, "before anything has changed, too");
  await drag(page, 1, 30, 30);
  await button(page, "Add a point").click();
  await button(page, "Reset").click();
  assert.deepEqual([await points(page), await ask(page, () => a.t)], [given, 0.25]);
  await button(page, "Undo").click();
  assert.equal((await points(page)).length, 7);
});

test("a double click adds a segment that ends there", async (t) => {
  const page = await openApplet(t, 'joints="c1"');
  const { x, y } = await boxOf(page.locator("bezier-applet .overlay"));
  await doubleClick(page, [x + 300, y + 60]);
  await settled(page);
  const all = await points(page);
  assert.equal(all.length, 10);
  near(all[9], [300, 60], 1); // clicks come in whole pixels
  assert.deepEqual(await ask(page, () => a.joints), ["c1", "c1"]);
  assert.deepEqual(await ask(page, () => a.figure.continuity.map(({ c1 }) => c1)), [true, true]);
});

test("what the page writes fires no input and no change, and can be undone", async (t) => {
  const page = await openApplet(t);
  await set(page, {
    points: [
      [0, 0],
      [100, 100],
      [200, 0],
      [300, 300],
    ],
  });
  await set(page, { t: 0.25 });
  await ask(page, () => a.insert(0.5));
  await ask(page, () => a.randomize(7));
  const first = await points(page);
  await ask(page, () => a.randomize(7));
  assert.deepEqual(await points(page), first, "equal seeds, equal points");
  await settled(page);
  assert.deepEqual(await fired(page), ["update"]);
  await ask(page, () => [a.undo(), a.undo()]);
  assert.deepEqual((await points(page)).length, 7);
  await ask(page, () => [a.undo(), a.undo()]);
  assert.deepEqual((await points(page))[0], [70, 330]);
  await ask(page, () => a.redo());
  assert.deepEqual((await points(page))[3], [300, 300]);
});

test("companions steer as the user does: input, one change, one undo step", async (t) => {
  const page = await openApplet(t);
  await ask(page, () => [0.1, 0.2, 0.3].forEach((t) => a.steer({ t }, false)));
  await settled(page);
  assert.deepEqual(await fired(page), ["input", "update"]);
  await ask(page, () => a.steer({ t: 0.4 }, true));
  await settled(page);
  assert.deepEqual(await fired(page), ["input", "change", "update"]);
  assert.equal(await ask(page, () => a.figure.t), 0.4);
  await ask(page, () => a.steer({ index: 0, point: [1, 2] }));
  assert.deepEqual((await points(page))[0], [1, 2]);
  await ask(page, () => [a.undo(), a.undo()]);
  assert.deepEqual([await ask(page, () => a.t), (await points(page))[0]], [0.5, [70, 330]]);
});

test("the state goes through JSON and back to the last bit, and a second element shows the same", async (t) => {
  const page = await openApplet(t, "", { more: `<bezier-applet id="b"></bezier-applet>` });
  await ask(page, () => {
    a.randomize(3);
    Object.assign(a, { joints: ["c2"], t: 0.3, show: "hull comb", labels: "b0", tolerance: 3, view: "10 20 67 48" });
    b.state = JSON.parse(JSON.stringify(a));
  });
  await settled(page);
  const [one, other] = await ask(page, () => [a, b].map((each) => JSON.stringify([each.state, each.figure])));
  assert.equal(one, other);
  assert.equal(
    await ask(page, () =>
      ["points", "joints", "t", "show", "labels", "tolerance", "view"].every(
        (name) => a.getAttribute(name) === b.getAttribute(name),
      ),
    ),
    true,
  );
  assert.equal(await ask(page, () => b.getAttribute("view")), "10 20 67 48");
});

test("attributes are read in any order, reflect, and go back to the defaults when they are taken away", async (t) => {
  const page = await openApplet(
    t,
    'mode="4" joints="c1" t="0.2" show="hull" points="0,0 10,100 20,100 100,0 200,-90 300,10 310,20"',
  );
  assert.deepEqual(await ask(page, () => [a.mode, a.t, a.points.length, a.figure.points.length, a.show]), [
    "4",
    0.2,
    7,
    4,
    "hull",
  ]);
  await ask(page, () => a.removeAttribute("mode"));
  await settled(page);
  const { points: all, continuity } = await ask(page, () => ({ points: a.points, continuity: a.figure.continuity }));
  assert.ok(continuity[0].c1);
  near(
    all.slice(0, 4),
    [
      [0, 0],
      [10, 100],
      [20, 100],
      [100, 0],
    ],
    0,
  );
  near(all[4], [180, -100], 1e-9, "held from the start");
  await ask(page, () => ["points", "t", "show", "joints"].forEach((name) => a.removeAttribute(name)));
  await settled(page);
  assert.deepEqual(await ask(page, () => [a.points[0], a.t, a.show]), [[70, 330], 0.5, "polygon"]);
  await set(page, { show: "comb tree" });
  assert.equal(await ask(page, () => a.getAttribute("show")), "comb tree");
  assert.ok((await ask(page, () => a.figure.tree)).segments > 2);
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
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
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

test("Tab goes through the points in the order of the curve", async (t) => {
  const page = await openApplet(t);
  await focus(page, 0);
  for (const name of ["P1 x", "P2 x", "P3 x"]) {
    await page.keyboard.press("Tab");
    assert.equal(await ask(page, () => a.shadowRoot.activeElement.getAttribute("aria-label")), name);
  }
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
