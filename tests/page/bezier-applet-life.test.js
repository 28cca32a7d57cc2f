// <bezier-applet>: where it lives: late start, moves, taken away, themes, paper, narrow windows.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openPage } from "./browser.js";
import {
  appletPage,
  ask,
  button,
  centre,
  drag,
  ink,
  openApplet,
  points,
  press,
  set,
  settled,
} from "./bezier-applet-page.js";
import { assertNear } from "./gestures.js";

test("nothing runs before it is near; what the page put in is shown until then", async (t) => {
  const page = await openPage(
    t,
    {
      html: appletPage(
        "controls",
        '<svg viewBox="0 0 670 480" id="still"><rect width="670" height="480"/></svg>',
      ).replace("<h1>", '<h1 style="margin-bottom: 3000px">'),
    },
    { viewport: { width: 800, height: 700 } },
  );
  await page.waitForFunction(() => globalThis.bezier);
  await page.evaluate(async () => (await import("/dist/elements.js")).loadElement("bezier-applet"));
  const late = await page.evaluate(async () => {
    globalThis.a = document.getElementById("a");
    await a.updateComplete;
    const parts = performance.getEntriesByType("resource").map(({ name }) => name);
    return [
      a.shadowRoot.querySelectorAll("canvas, .handle").length,
      parts.some((name) => name.includes("elements-applet")),
      document.getElementById("still").getBoundingClientRect().height,
      a.figure.pieces.length,
    ];
  });
  assert.deepEqual(late, [0, false, 480, 2], "its figure is known all the same");
  await page.evaluate(() => a.scrollIntoView());
  await page.waitForFunction(() => a.shadowRoot.querySelectorAll(".handle").length === 7);
  assert.equal(await page.locator("#still").isVisible(), false);
});

test("elements that come near together start one in each idle moment, without those that were scrolled past", async (t) => {
  const more = "<bezier-applet></bezier-applet>".repeat(5);
  const queue = "globalThis.idle = []; globalThis.requestIdleCallback = (act) => globalThis.idle.push(act);";
  const html = appletPage("", "", more).replace("<h1>", `<script>${queue}</script><h1>`);
  const page = await openPage(t, { html }, { viewport: { width: 800, height: 4000 } });
  const started = () =>
    page.evaluate(
      () =>
        [...document.querySelectorAll("bezier-applet")].filter((each) => each.shadowRoot?.querySelector(".overlay"))
          .length,
    );
  const waiting = () => page.waitForFunction(() => globalThis.idle.length === 1);
  const frames = () =>
    page.evaluate(async () => {
      for (let i = 0; i < 3; i++) await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
    });
  const next = async () => {
    await waiting();
    await page.evaluate(() => globalThis.idle.shift()());
    await frames();
  };
  await waiting();
  assert.equal(await started(), 0);
  for (let count = 1; count <= 3; count++) {
    await next();
    assert.equal(await started(), count);
  }
  const push = (/** @type {string} */ margin) =>
    page.evaluate((value) => {
      document.querySelector("main").style.marginTop = value;
    }, margin);
  await push("9000px");
  await frames();
  for (let count = 4; count <= 6; count++) await next();
  assert.equal(await started(), 3);
  await push("0");
  for (let count = 4; count <= 6; count++) await next();
  assert.equal(await started(), 6);
});

test("moved about it keeps its state and works; taken away it stops", async (t) => {
  const page = await openApplet(t, "controls", { more: `<section id="there"></section>` });
  await drag(page, 1, 30, 30);
  const before = await points(page);
  await page.evaluate(() => document.getElementById("there").append(a));
  await settled(page);
  assert.deepEqual(await points(page), before);
  await drag(page, 1, 10, 10);
  assertNear((await points(page))[1], [before[1][0] + 10, before[1][1] + 10], 0.01);
  await press(page, "Control+z");
  assert.deepEqual(await points(page), before);
  await page.evaluate(() => a.remove());
  assert.equal(await ask(page, () => a.isConnected), false, "remove without an index is every element's");
  await page.evaluate(() => {
    a.points = "1,1 2,2 3,3 4,4";
    document.querySelector("main").append(a);
  });
  await page.waitForFunction(() => a.shadowRoot.querySelectorAll(".handle").length === 4);
});

test("removed in the middle of a drag and put back a hundred times, it holds nothing", async (t) => {
  const page = await openApplet(t, "controls");
  const before = await points(page);
  const [x, y] = await centre(page, 1);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 40, y);
  await settled(page);
  await page.evaluate(() => a.remove());
  await page.mouse.up();
  assert.deepEqual(await points(page), before);
  await page.evaluate(async () => {
    for (let i = 0; i < 100; i++) {
      document.querySelector("main").append(a);
      if (i % 10 === 0) await new Promise((done) => requestAnimationFrame(done));
      a.remove();
    }
    document.querySelector("main").append(a);
  });
  await settled(page);
  await page.waitForFunction(() => a.shadowRoot.querySelector(".overlay").style.width);
  await drag(page, 1, 10, 0);
  assertNear((await points(page))[1], [before[1][0] + 10, before[1][1]], 0.01);
});

const paper = (page) => ask(page, () => getComputedStyle(a.shadowRoot.querySelector(".stage")).backgroundColor);
const [LIGHT, DARK] = ["rgb(243, 246, 250)", "rgb(19, 26, 34)"];

test("light, dark, as the page is: the theme", async (t) => {
  const page = await openApplet(t, "", { colorScheme: "dark" });
  assert.equal(await paper(page), DARK);
  await ask(page, () => a.setAttribute("theme", "light"));
  await settled(page);
  assert.equal(await paper(page), LIGHT);
  assert.match(await ask(page, () => a.toSVG()), /#0072b2|rgb\(0, 114, 178\)/);
  await ask(page, () => a.setAttribute("theme", "dark"));
  await page.emulateMedia({ colorScheme: "light" });
  await settled(page);
  assert.equal(await paper(page), DARK);
  await ask(page, () => a.removeAttribute("theme"));
  await settled(page);
  assert.equal(await paper(page), LIGHT);
  await page.evaluate(() => a.style.setProperty("--bz-curve", "rgb(255, 0, 0)"));
  await page.emulateMedia({ colorScheme: "dark" });
  await settled(page);
  assert.match(await ask(page, () => a.toSVG()), /rgb\(255, 0, 0\)/, "a custom property colours the curve");
});

test("forced colours, print and less motion", async (t) => {
  const page = await openApplet(t, "controls", { forcedColors: "active", reducedMotion: "reduce" });
  assert.ok((await ink(page, [325, 230])) > 10);
  await button(page, "Play t").click();
  await page.waitForFunction(() => a.t >= 0.6);
  assert.ok(Math.abs(((await ask(page, () => a.t)) * 10) % 1) < 1e-6, "in steps");
  await button(page, "Pause").click();
  await page.emulateMedia({ media: "print", forcedColors: "none" });
  assert.equal(await page.locator("bezier-applet .controls").isVisible(), false);
  assert.ok(await page.locator("bezier-applet canvas").isVisible());
});

test("on paper a dark page's picture is drawn for daylight", async (t) => {
  const page = await openApplet(t, 'theme="dark"', { colorScheme: "dark" });
  assert.match(await ask(page, () => a.toSVG()), /rgb\(86, 180, 233\)/);
  await page.emulateMedia({ media: "print" });
  await page.waitForFunction(async () => /rgb\(0, 114, 178\)/.test(await a.toSVG()));
});

test("320 to 420 pixels wide nothing is cut off", async (t) => {
  const page = await openApplet(t, 'controls basis="matrix" show="tree segments offset ticks comb"');
  await page
    .locator("bezier-applet summary")
    .evaluateAll((all) => all.forEach((/** @type {any} */ summary) => summary.click()));
  for (const width of [320, 360, 420]) {
    await page.setViewportSize({ width, height: 900 });
    await settled(page);
    const wide = await ask(page, () => [
      document.documentElement.scrollWidth,
      ...[...a.shadowRoot.querySelectorAll(".controls *, .joints *")]
        .filter(
          (each) => !each.closest("pre") && each.getBoundingClientRect().right > a.getBoundingClientRect().right + 1,
        )
        .map((each) => each.outerHTML),
    ]);
    assert.ok(wide[0] <= width && wide.length === 1, `${width}: ${wide.join("\n")}`);
  }
});

test("targets are 24 pixels at least", async (t) => {
  const page = await openApplet(t, "controls");
  const small = await ask(page, () =>
    [...a.shadowRoot.querySelectorAll("button, select, summary, .handle, .controls input:not([type=file])")]
      .map((each) => (each.type === "checkbox" ? each.parentElement : each))
      .filter(
        (each) =>
          each.checkVisibility() &&
          (each.getBoundingClientRect().height < 24 || each.getBoundingClientRect().width < 24),
      )
      .map((each) => each.outerHTML),
  );
  assert.deepEqual(small, []);
});

test("parts of the panel by the words of `controls`", async (t) => {
  const page = await openApplet(t, 'controls="t joints"');
  const shown = () =>
    ask(page, () =>
      [...a.shadowRoot.querySelectorAll(".joints, .t, .row, fieldset, details")].map(
        (each) => each.className || each.localName,
      ),
    );
  assert.deepEqual(await shown(), ["joints", "t"]);
  await set(page, { controls: "show" });
  assert.deepEqual(await shown(), ["fieldset"]);
  await set(page, { controls: null });
  assert.deepEqual(await shown(), []);
  await set(page, { controls: true });
  assert.equal(await ask(page, () => a.getAttribute("controls")), "");
});

test("what the page wrote before the element was known counts", async (t) => {
  const page = await openPage(t, {
    html: `<!doctype html><html lang="en"><title>Early</title><body><main></main><script type="module">
    const early = Object.assign(document.createElement("bezier-applet"), { points: [[1, 2], [30, 40], [50, 60], [70, 80]], t: 0.125, show: "hull" });
    document.querySelector("main").append(early);
    await import("./dist/elements.js");
    globalThis.early = early;</script>`,
  });
  await page.waitForFunction(() => globalThis.early);
  assert.deepEqual(await page.evaluate(() => [early.points[0], early.t, early.show]), [[1, 2], 0.125, "hull"]);
});

test("the panel shows t, play and joints, the rest on demand; keys are named only where there is a keyboard", async (t) => {
  const visible = async (options) => {
    const page = await openApplet(t, 'controls joints="c1"', options);
    const texts = ["Randomize", "kbd", "Basis"].map((text) =>
      page
        .locator("bezier-applet")
        .locator(text === "kbd" ? "kbd" : `:text("${text}")`)
        .first()
        .isVisible(),
    );
    const all = await Promise.all(texts);
    await page.getByText("More", { exact: true }).click();
    const hidden = await page.getByRole("button", { name: "Randomize" }).isVisible();
    assert.ok(!hidden && (await page.getByRole("slider", { name: "t", exact: true }).isVisible()));
    assert.ok(await page.getByRole("button", { name: "Play t" }).isVisible());
    assert.ok(await page.getByLabel(/^At P3 hold/).isVisible());
    return all;
  };
  assert.deepEqual(await visible({}), [true, true, true]);
  assert.deepEqual(await visible({ hasTouch: true, isMobile: true }), [true, false, true]);
});
