// The tutorial's applet: its HTML, a drag, the joint, r and m, the object for pages that embed it.
// tests/js/applet-rules.test.js has the rules: joints, random points, refusals, texts; editor.test.js those of undo, ui.test.js those of drags.
import assert from "node:assert/strict";
import { test } from "node:test";
import { boxOf, openPage, root } from "./browser.js";
import { assertNear } from "./gestures.js";
import { serve } from "./server.js";
import {
  BLUE,
  centre,
  countColour,
  cubicAt,
  drag,
  drawn,
  GREEN,
  handle,
  joint,
  openTutorial,
  points,
  pull,
  tutorialPage,
  VERMILION,
} from "./applet-page.js";

const status = (page) => page.locator('[part="status"]').innerText();

test("the tutorial's HTML, to the letter, shows seven points and two smooth cubics", async (t) => {
  const page = await openTutorial(t);
  assert.equal(await page.locator('[part="handle"]').count(), 7);
  const box = await boxOf(page.locator("canvas"));
  assert.deepEqual([box.width, box.height], [670, 480]);
  const all = await points(page);
  for (const [first, at] of [
    [0, 0.3],
    [0, 0.8],
    [3, 0.3],
    [3, 0.8],
  ]) {
    const place = cubicAt(all.slice(first, first + 4), at);
    assert.ok((await countColour(page, place, BLUE)) >= 4, `the curve runs through ${place}`);
  }
  const continuity = await page.evaluate(() => bezierApp().continuity);
  assert.deepEqual([continuity.g1, continuity.c1], [true, false]);
  assert.match(await status(page), /G1.*P2, P3, P4 aligned: G1 at P3/s);
});

test("a dragged point takes its handle, its coordinates and the curve along", async (t) => {
  const page = await openTutorial(t);
  const before = await points(page);
  const at = await centre(page, 1);
  await drag(page, 1, 120, 60);
  const after = await points(page);
  assertNear(after[1], [before[1][0] + 120, before[1][1] + 60], 0.01, "P1");
  assert.deepEqual(after.with(1, before[1]), before, "the others stay");
  assertNear(await centre(page, 1), [at[0] + 120, at[1] + 60], 0.6, "the handle");
  const [here, there] = [after, before].map((all) => cubicAt(all.slice(0, 4), 0.4));
  assert.ok((await countColour(page, here, BLUE)) >= 4, "the curve is where it belongs");
  assert.equal(await countColour(page, there, BLUE), 0, "and no longer where it was");
});

test("C1 is held in the midst and at the end of a drag, and the label says so; a free P3 breaks the joint", async (t) => {
  const page = await openTutorial(t);
  await page.getByLabel("C1", { exact: true }).check();
  const before = await points(page);
  await pull(page, 4, -60, 40);
  const whileDragging = await points(page);
  await page.mouse.up();
  for (const held of [whileDragging, await points(page)]) {
    assertNear(held[4], [before[4][0] - 60, before[4][1] + 40], 0.01, "P4 follows the pointer");
    const { sine, cosine, before: first, after: second } = joint(held);
    assert.ok(cosine > 0);
    assertNear([sine, first], [0, second], 1e-9, "aligned, P3 half-way");
  }
  assert.deepEqual((await points(page)).toSpliced(4, 1).toSpliced(2, 1), before.toSpliced(4, 1).toSpliced(2, 1));
  assert.equal(await page.evaluate(() => bezierApp().continuity.c1), true);
  assert.match(await status(page), /C1.*G1 and C1 at P3/s);
  await page.getByLabel("Free", { exact: true }).check();
  await drag(page, 3, 40, -30);
  assert.match(await status(page), /C0.*Broken at P3: the tangent turns by \d+°/s);
});

test("a point pressed off its centre does not jump; at the edge of the picture it stops", async (t) => {
  const page = await openTutorial(t);
  const [[x, y], before] = [await centre(page, 6), await points(page)];
  await page.mouse.move(x + 7, y - 6);
  await page.mouse.down();
  await page.mouse.move(x + 17, y + 4);
  await page.mouse.up();
  await drawn(page);
  assertNear((await points(page))[6], [before[6][0] + 10, before[6][1] + 10], 0.01);
  await drag(page, 0, -400, 400);
  assert.deepEqual((await points(page))[0], [0, 480]);
  await drag(page, 0, 50, -50);
  assertNear((await points(page))[0], [50, 430], 1);
});

test("a partner pushed out of the picture waits at its edge and can be fetched back", async (t) => {
  const page = await openTutorial(t);
  await page.evaluate(() =>
    Object.assign(bezierApp(), { joint: "c1", points: bezierApp().points.with(3, [600, 230]) }),
  );
  await drawn(page);
  await drag(page, 2, -100, 0);
  const [x] = (await points(page))[4];
  assert.ok(x > 670, `P4 is outside, at ${x}`);
  await drag(page, 4, -40, 20);
  assertNear([(await points(page))[4][0]], [630], 1);
});

test("r, from anywhere on the page, puts every point at another place", async (t) => {
  const page = await openTutorial(t);
  const before = await points(page);
  await page.keyboard.press("r");
  await drawn(page);
  const after = await points(page);
  assert.ok(
    after.length === 7 && after.every((point, i) => String(point) !== String(before[i])),
    JSON.stringify(after),
  );
  const blue = await Promise.all(
    [0.2, 0.3, 0.4, 0.6, 0.7, 0.8].map((at) => countColour(page, cubicAt(after.slice(0, 4), at), BLUE)),
  );
  assert.ok(blue.filter((count) => count >= 3).length >= 3, `the curve, in part below other lines: ${blue}`);
});

test("m shows four points, m again all of them; nothing is lost", async (t) => {
  const page = await openTutorial(t);
  const before = await points(page);
  await page.keyboard.press("m");
  await drawn(page);
  assert.equal(await page.locator('[part="handle"]').count(), 4);
  assert.deepEqual(await points(page), before, "all seven are still given");
  assert.equal(await page.evaluate(() => bezierApp().continuity), null);
  assert.equal(await countColour(page, cubicAt(before.slice(3), 0.3), BLUE), 0, "the second cubic is not drawn");
  await page.keyboard.press("m");
  await drawn(page);
  assert.equal(await page.locator('[part="handle"]').count(), 7);
  assert.ok((await countColour(page, cubicAt(before.slice(3), 0.3), BLUE)) >= 4);
});

test("r and m are left alone in fields, with modifiers, and when switched off", async (t) => {
  const more = `<input aria-label="name"><textarea aria-label="words"></textarea><select aria-label="one"><option>r</option></select>
    <div contenteditable="true" role="textbox" aria-label="rich"><b id="rich">x</b></div><x-field></x-field>
    <script>document.querySelector("x-field").attachShadow({ mode: "open" }).innerHTML = '<input id="deep" aria-label="deep">';</script>`;
  const page = await openTutorial(t, { more });
  const before = await points(page);
  for (const field of ['[aria-label="name"]', "textarea", "select", "[contenteditable]", "#deep"]) {
    await page.locator(field).focus();
    await page.keyboard.press("r");
    await page.keyboard.press("m");
  }
  await page.locator("h1").click();
  for (const keys of ["Control+m", "Alt+r"]) await page.keyboard.press(keys);
  await page.getByLabel("r and m on the whole page").uncheck();
  await page.locator('[aria-label="name"]').focus();
  await page.evaluate(() => /** @type {any} */ (document.activeElement).blur());
  await page.keyboard.press("r");
  assert.deepEqual(await points(page), before);
  assert.equal(await page.evaluate(() => bezierApp().visiblePoints), 7);
  await page.getByLabel("P0 x").focus(); // inside the applet they always count
  await page.keyboard.press("m");
  assert.equal(await page.evaluate(() => bezierApp().visiblePoints), 4);
});

test("undo and redo by button and key, with the focus inside only; Esc takes a drag back", async (t) => {
  const page = await openTutorial(t);
  const first = await points(page);
  const [undo, redo] = ["Undo", "Redo"].map((name) => page.getByRole("button", { name }));
  assert.ok((await undo.isDisabled()) && (await redo.isDisabled()));
  await pull(page, 2, 60, 60);
  assert.notDeepEqual(await points(page), first);
  await page.keyboard.press("Escape");
  await page.mouse.up();
  await drawn(page);
  assert.ok((await undo.isDisabled()) && String(await points(page)) === String(first));
  await page.getByLabel("P1 x").focus();
  for (let i = 0; i < 5; i++) await page.keyboard.down("ArrowRight"); // held: one step
  await page.keyboard.up("ArrowRight");
  const moved = await points(page);
  assert.equal(moved[1][0], first[1][0] + 5);
  await page.keyboard.press("Control+z");
  assert.deepEqual(await points(page), first);
  await redo.click();
  assert.deepEqual(await points(page), moved);
  await page.evaluate(() => /** @type {any} */ (document.activeElement).blur());
  await page.keyboard.press("Control+z");
  assert.deepEqual(await points(page), moved, "without the focus it is the page's own");
  await page.evaluate(() => bezierApp().undo());
  assert.deepEqual(await points(page), first);
});

test("events: input while moving, change at the end, none for what the page writes", async (t) => {
  const page = await openTutorial(t);
  await page.evaluate(() => {
    globalThis.log = [];
    for (const type of ["input", "change"]) bezierApp().addEventListener(type, () => log.push(type));
  });
  await page.evaluate(() => {
    const app = bezierApp();
    Object.assign(app, { points: app.points, t: 0.2, joint: "g1", visiblePoints: 4, layers: { hull: true } });
    app.toggleAllPoints();
    app.randomize(1);
    app.append([10, 10]);
  });
  await drawn(page);
  assert.deepEqual(await page.evaluate(() => log), []);
  await drag(page, 0, 10, 10);
  const log = await page.evaluate(() => log);
  assert.ok(log.length >= 2 && log.at(-1) === "change");
  assert.deepEqual([...new Set(log.slice(0, -1))], ["input"]);
});

test("assigned values show: points, t, layers", async (t) => {
  const page = await openTutorial(t);
  const cubic = JSON.parse("[[100,400],[100,100],[500,100],[500,400]]");
  const layers = { construction: true, halves: true, polygon: false };
  await page.evaluate((values) => Object.assign(bezierApp(), values), { points: cubic, t: 0.25, layers });
  await drawn(page);
  assert.deepEqual(await points(page), cubic);
  assert.equal(await page.locator('[part="handle"]').count(), 4);
  assert.ok((await countColour(page, cubicAt(cubic, 0.1), BLUE)) >= 6, "the first half");
  assert.ok((await countColour(page, cubicAt(cubic, 0.6), VERMILION)) >= 6, "the second half");
  // The construction from (100, 325) to (200, 100), each a quarter of the way on one of the first two sides.
  assert.ok((await countColour(page, [130, 257.5], GREEN)) >= 2, "the construction");
  assert.equal(await page.getByLabel("t", { exact: true }).inputValue(), "0.25");
  assert.equal(await page.getByLabel("two halves at t").isChecked(), true);
  for (const bad of [
    { points: [] },
    { visiblePoints: 5 },
    { joint: "G9" },
    { t: "half" },
    { layers: { bones: true } },
  ]) {
    const setting = page.evaluate((values) => void Object.assign(bezierApp(), values), bad);
    await assert.rejects(setting, /(RangeError|TypeError): .+: expected .+, got .+/);
  }
  assert.deepEqual(await points(page), cubic);
});

test("bezierApp takes a canvas, its id, or means #beziercanvas; the second call returns the same applet", async (t) => {
  const page = await openTutorial(t, {
    more: '<canvas id="other" width="300" height="200"></canvas><p id="text"></p>',
  });
  const found = await page.evaluate(() => {
    const other = bezierApp("other");
    const app = bezierApp();
    return [
      app === bezierApp(new Event("load")),
      app === bezierApp("beziercanvas"),
      app === bezierApp(document.getElementById("beziercanvas")),
      other === bezierApp(document.getElementById("other")),
      other !== app,
      app === bezierApp(42),
    ];
  });
  assert.deepEqual(found, new Array(6).fill(true));
  const inside = await page.evaluate(() => bezierApp("other").points.every(([x, y]) => x <= 300 && y <= 200));
  assert.ok(inside, "the points fit a smaller canvas");
  await page.locator('[part="handle"]').last().hover();
  await page.keyboard.press("m");
  const modes = () => page.evaluate(() => [bezierApp().visiblePoints, bezierApp("other").visiblePoints]);
  assert.deepEqual(await modes(), [7, 4], "m is for the applet under the pointer");
});

test("bezierApp on something that is no canvas says what was expected and what came", async (t) => {
  const page = await openPage(t, {
    html: '<!doctype html><html lang="en"><title>No canvas</title><p id="text">x</p><canvas id="gl"></canvas><script src="bezier-app.js"></script></html>',
  });
  const messages = await page.evaluate(() => {
    const text = document.getElementById("text");
    document.getElementById("gl").getContext("webgl2");
    return [undefined, "nowhere", "text", text, new Event("load"), 7, document.createElement("canvas"), "gl"].map(
      (target) => {
        try {
          return bezierApp(target) && "no error";
        } catch (/** @type {any} */ error) {
          return `${error.name}: ${error.message}`;
        }
      },
    );
  });
  assert.match(
    messages[0],
    /^TypeError: bezierApp: expected a canvas with the id "beziercanvas", got none in this document/,
  );
  assert.match(messages[1], /^TypeError: .*"nowhere", got none/);
  assert.match(messages[2], /^TypeError: .*"text", got a <p> element/);
  assert.match(messages[3], /^TypeError: .*expected a canvas, its id or nothing, got a <p> element/);
  for (const message of messages) assert.match(message, /^TypeError: bezierApp: expected .* got /);
  assert.equal(await page.locator("#text").innerText(), "x");
});

test("destroy leaves the page as it was, and a new applet can follow", async (t) => {
  const plain = tutorialPage().replace('window.addEventListener("load", bezierApp, false);', "");
  const page = await openPage(t, { html: plain });
  const html = () => page.evaluate(() => document.documentElement.outerHTML);
  const before = await html();
  await page.evaluate(() => (globalThis.app = bezierApp()));
  await drawn(page);
  assert.notEqual(await html(), before);
  await page.evaluate(() => app.destroy());
  assert.equal(await html(), before);
  await page.keyboard.press("m");
  await page.evaluate(() => {
    const { points } = app;
    app.points = points;
    app.destroy();
  });
  await drawn(page);
  assert.equal(await html(), before);
  assert.equal(await page.evaluate(() => app.visiblePoints), 7, "its keys are gone");
  assert.equal(await page.evaluate(() => bezierApp() !== app && bezierApp().visiblePoints), 7);
  await handle(page, 6).waitFor();
});

test("a strict content security policy is enough for the applet from npm", async (t) => {
  const policy = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'";
  const strict = await serve({ "/dist/": `${root}dist` }, { "Content-Security-Policy": policy });
  t.after(() => strict.close());
  strict.pages.set(
    "/",
    '<!doctype html><html lang="en"><title>Strict</title><canvas id="beziercanvas" width="670" height="480"></canvas></html>',
  );
  const page = await openPage(t, "/", { baseURL: strict.url });
  await page.evaluate(async () => (await import("/dist/applet.js")).bezierApp());
  assert.equal((await boxOf(handle(page, 3))).width, 24, "the styles are in force");
});

test("importing the applet on Node touches no page", async () => {
  const { bezierApp } = await import(`${root}dist/applet.js`);
  assert.equal(typeof bezierApp, "function");
});
