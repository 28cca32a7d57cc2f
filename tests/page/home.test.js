// The first page: the word, the numbers, the pictures to try, the bar; without scripts, with reduced motion, by keyboard, on a phone.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { assertAccessible, boxOf, COLOUR_RULES, frames, isRelease, openPage, QUIET_FRAMES, root } from "./browser.js";
import { dragBy, dragFrom } from "./gestures.js";
import { openStrict } from "./site-pages.js";

const DESKTOP = { viewport: { width: 1280, height: 800 } };
const PHONE = { viewport: { width: 360, height: 740 }, deviceScaleFactor: 2, hasTouch: true, isMobile: true };
const STILL = { ...DESKTOP, reducedMotion: /** @type {const} */ ("reduce") };

const outline = (page) => page.locator(".word .grip").getAttribute("d");
const positionOf = (page) => page.locator("#word-position").getAttribute("aria-valuetext");
/** Waits until the script has started. */
const started = (page) => page.locator("#word-play:enabled").waitFor();
const thing = (page, name) => page.locator(`[data-thing="${name}"]`);
/** Scrolls to the pictures and waits until their scripts have run. */
async function openGallery(page) {
  await page.locator(".gallery").scrollIntoViewIfNeeded();
  await thing(page, "glyph").locator(".anchor").first().waitFor({ state: "attached" });
  await thing(page, "teapot").locator(".wake").waitFor();
}
/** Gives an element the focus and presses a key. */
async function pressOn(page, selector, key) {
  await page.locator(selector).focus();
  await page.keyboard.press(key);
}

test("without scripts the word, the installation, all pictures and all pages are there", async (t) => {
  const page = await openPage(t, "/", { ...DESKTOP, javaScriptEnabled: false });
  const word = await boxOf(page.locator(".word .ghost"));
  assert.ok(word.width > 900 && word.y + word.height < 520, JSON.stringify(word));
  assert.equal(await page.locator(".word .rounds circle").count(), 9);
  for (const command of ["npm install casteljau", "cargo add casteljau"])
    assert.ok(await page.getByText(command, { exact: true }).isVisible(), command);
  assert.equal(await page.locator(".thing .picture").count(), 6);
  for (const name of ["Bézier curves", "Easing", "API"])
    assert.ok(await page.locator(".ways").getByRole("link", { name, exact: true }).isVisible(), name);
  await page.getByRole("navigation", { name: "Site" }).getByRole("button", { name: "Docs" }).hover();
  assert.ok(await page.getByRole("navigation").getByRole("link", { name: "Recipes" }).isVisible());
});

test("the first view has the word, what the library is, and how to install it", async (t) => {
  const page = await openStrict(t, "/", STILL);
  for (const locator of [
    page.locator("h1"),
    page.getByText("npm install casteljau"),
    page.getByText("API reference"),
  ]) {
    const { y, height } = await boxOf(locator);
    assert.ok(y + height <= 800, await locator.innerText());
  }
});

test("with reduced motion the word is written, as the build has drawn it, and nothing moves", async (t) => {
  const page = await openStrict(t, "/", STILL);
  await started(page);
  assert.equal(await page.locator("#word-play").getAttribute("aria-label"), "Play");
  assert.equal(await page.locator(".word .ink path[stroke-dasharray]").count(), 0);
  const place = await page.locator(".word .pen").getAttribute("transform");
  const html = readFileSync(`${root}site/index.html`, "utf8");
  const [, drawn] = /class="pen"[^>]*transform="translate\(([^)]*)\)"/.exec(html) ?? [];
  assert.ok(place?.startsWith(`translate(${drawn})`), `${place} and ${drawn}`);
  await page.locator(".gallery").scrollIntoViewIfNeeded();
  await thing(page, "glyph").locator(".anchor").first().waitFor({ state: "attached" });
  const moving = () =>
    page.evaluate(() => ["main .pen", ".ball", ".craft"].map((name) => document.querySelector(name)?.outerHTML));
  await frames(page);
  const before = await moving();
  await frames(page, QUIET_FRAMES);
  assert.deepEqual(await moving(), before);
});

test("the word is written, stops, and goes on", async (t) => {
  const page = await openStrict(t, "/", DESKTOP);
  await started(page);
  const play = page.locator("#word-play");
  const before = await positionOf(page);
  await page.waitForFunction(
    (text) => document.querySelector("#word-position")?.getAttribute("aria-valuetext") !== text,
    before,
  );
  await play.click();
  assert.equal(await play.getAttribute("aria-label"), "Play");
  await frames(page);
  const stopped = await positionOf(page);
  await frames(page, QUIET_FRAMES);
  assert.equal(await positionOf(page), stopped);
  await play.click();
  await page.waitForFunction(
    (text) => document.querySelector("#word-position")?.getAttribute("aria-valuetext") !== text,
    stopped,
  );
});

test("a drag bends the line near the pointer; Ctrl+Z and Reset bring it back", async (t) => {
  const page = await openStrict(t, "/", STILL);
  await started(page);
  await frames(page);
  const first = await outline(page);
  const start = await page.evaluate(() => {
    const path = /** @type {SVGPathElement} */ (document.querySelector(".word .ghost path"));
    const { x, y } = path.getPointAtLength(path.getTotalLength() / 2).matrixTransform(path.getScreenCTM() ?? undefined);
    return [x, y];
  });
  const strokes = () =>
    page.locator(".word .ghost path").evaluateAll((paths) => paths.map((path) => path.getAttribute("d")));
  const before = await strokes();
  await dragFrom(page, start, 0, 40);
  await frames(page);
  const after = await strokes();
  assert.notEqual(after[0], before[0], "the c is bent");
  assert.equal(after[3], before[3], "the letters at the other end are not");
  await page.locator("#word-play").focus();
  await page.keyboard.press("Control+z");
  await frames(page);
  assert.equal(await outline(page), first);
  await dragFrom(page, start, 0, 40);
  await page.locator("#word-reset").click();
  await frames(page);
  assert.equal(await outline(page), first);
  assert.ok(await page.locator("#word-reset").isDisabled());
});

test("by keyboard: the pen, the points of the word, and undo", async (t) => {
  const page = await openStrict(t, "/", STILL);
  await started(page);
  await pressOn(page, "#word-position", "Home");
  await frames(page);
  assert.equal(await positionOf(page), "letter c, t = 0.00");
  await pressOn(page, "#word-position", "End");
  await frames(page);
  assert.match((await positionOf(page)) ?? "", /^letter j, t = 1\.00$/);
  const first = await outline(page);
  await pressOn(page, "#word-points", "Enter");
  assert.equal(await page.locator(".points [tabindex='0']").count(), 1, "one stop of the Tab key");
  await page.locator(".points [tabindex='0']").focus();
  await page.keyboard.press("PageDown");
  const focused = () => page.evaluate(() => document.activeElement?.getAttribute("aria-label"));
  assert.match((await focused()) ?? "", /^Point 2 of 43, /);
  await page.keyboard.press("ArrowDown");
  await frames(page);
  assert.notEqual(await outline(page), first);
  await page.keyboard.press("Control+z");
  await frames(page);
  assert.equal(await outline(page), first);
});

test("by keyboard: tabs of the installation, menus of the bar", async (t) => {
  const page = await openStrict(t, "/", STILL);
  await started(page);
  await pressOn(page, "#tab-npm", "ArrowRight");
  assert.ok(await page.getByRole("tabpanel", { name: "cargo" }).isVisible());
  assert.equal(await page.locator(".install [role=tabpanel]:visible").count(), 1);
  await page.keyboard.press("End");
  assert.match(await page.getByRole("tabpanel", { name: "script tag" }).innerText(), /casteljau\.global\.js/);
  const tools = page.getByRole("button", { name: "Tools" });
  await tools.focus();
  await page.keyboard.press("Enter");
  await page.keyboard.press("Tab");
  assert.match(await page.evaluate(() => document.activeElement?.textContent ?? ""), /^Easing/);
  await page.keyboard.press("Escape");
  assert.equal(await tools.getAttribute("aria-expanded"), "false");
  assert.equal(await page.evaluate(() => document.activeElement?.textContent), "Tools");
});

test("at 360 px the bar is one line, its menu has all pages, and nothing is wider", async (t) => {
  const page = await openStrict(t, "/", PHONE);
  await started(page);
  const bar = page.locator(".site-bar");
  assert.ok((await boxOf(bar)).height <= 49);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 360);
  const menu = page.getByRole("button", { name: "Menu" });
  await menu.click();
  const links = page.getByRole("navigation", { name: "Site" }).getByRole("link");
  assert.equal(await links.count(), 16);
  for (const link of await links.all()) assert.ok((await boxOf(link)).height >= 44, await link.innerText());
  await page.keyboard.press("Escape");
  assert.equal(await menu.getAttribute("aria-expanded"), "false");
});

for (const [name, options] of /** @type {const} */ ([
  ["1280 px", STILL],
  ["360 px", { ...PHONE, ...STILL, viewport: PHONE.viewport }],
]))
  test(`axe finds nothing, light and dark, at ${name}`, async (t) => {
    const page = await openStrict(t, "/", options);
    await openGallery(page);
    await assertAccessible(page);
    await page.emulateMedia({ colorScheme: "dark" });
    await frames(page);
    await assertAccessible(page, { rules: COLOUR_RULES });
  });

/** The bytes before the reader does something. */
const MAX_BYTES = 250_000;

test("before the reader does something, the page takes less than 250 kB", async (t) => {
  const page = await openStrict(t, "/", { ...DESKTOP, fresh: true });
  await started(page);
  await frames(page);
  const sizes = await page.evaluate(() =>
    ["navigation", "resource"].flatMap((type) =>
      performance.getEntriesByType(type).map((entry) => {
        const { name, decodedBodySize } = /** @type {PerformanceResourceTiming} */ (entry);
        return { name, size: decodedBodySize };
      }),
    ),
  );
  const sum = (list) => list.reduce((total, { size }) => total + size, 0);
  t.diagnostic(`${sum(sizes)} bytes`);
  if (isRelease) assert.ok(sum(sizes) < MAX_BYTES, JSON.stringify(sizes));
  else t.diagnostic("the package is built for development: its size is not that of a release");
});

test("the numbers are those of the latest benchmarks, the comparison is that of the README", async (t) => {
  const page = await openStrict(t, "/", STILL);
  const { rows } = JSON.parse(readFileSync(`${root}benches/results.json`, "utf8"));
  const ratios = ["nearest", "adaptive-verb-searched"].map((id) => rows.find((row) => row.id === id).ratio);
  const shown = await page.locator(".proof b").allInnerTexts();
  assert.deepEqual(
    shown.slice(0, 2).map((text) => Number.parseFloat(text)),
    ratios.map((ratio) => Number(ratio.toPrecision(2))),
  );
  const readme = readFileSync(`${root}README.md`, "utf8").replaceAll("`", "");
  for (const row of await page.locator("table tbody tr").all()) {
    const [name, ...cells] = await row.locator("th, td").allInnerTexts();
    const line = `| ${[name, ...cells].join(" | ")} |`;
    assert.ok(
      readme.includes(line) || readme.includes(line.replace(name, name[0].toLowerCase() + name.slice(1))),
      line,
    );
  }
});

test("one number can be measured in the browser", async (t) => {
  const page = await openStrict(t, "/", STILL);
  await page.locator("#measure").click();
  await page.getByText(/^\d+ ns in this browser/).waitFor();
});

test("the pictures are live: timing function, letter, shapes, ink, teapot", async (t) => {
  const page = await openStrict(t, "/", STILL);
  await openGallery(page);
  await pressOn(page, '[data-thing="teapot"] .wake', "Enter");
  await page.locator("bezier-surface canvas").waitFor();

  const easing = thing(page, "easing");
  await easing.locator(".handle").first().focus();
  await page.keyboard.press("ArrowRight");
  assert.match(await easing.locator("code").innerText(), /^cubic-bezier\(0\.3[56], 1\.3, 0\.64, 1\)$/);

  const letter = thing(page, "glyph").locator(".letter");
  const before = await letter.getAttribute("d");
  await thing(page, "glyph").locator(".anchor").first().focus();
  await page.keyboard.press("ArrowDown");
  assert.notEqual(await letter.getAttribute("d"), before);

  const shapes = thing(page, "shapes");
  await shapes.getByRole("button", { name: "intersect" }).click();
  await page.waitForFunction(() => {
    const [result, leaf] = document.querySelectorAll('[data-thing="shapes"] path');
    return (
      /** @type {SVGGraphicsElement} */ (result).getBBox().width <
      /** @type {SVGGraphicsElement} */ (leaf).getBBox().width
    );
  });

  const ink = thing(page, "ink").locator("svg");
  const stroke = await ink.locator("path").getAttribute("d");
  await dragBy(page, ink, 40, 20);
  await page.waitForFunction((d) => document.querySelector('[data-thing="ink"] path')?.getAttribute("d") !== d, stroke);
});

test("what moves by itself among the pictures stops after five seconds", async (t) => {
  const page = await openStrict(t, "/", { ...DESKTOP, fresh: true });
  await page.clock.install();
  await page.reload();
  await openGallery(page);
  await thing(page, "easing").scrollIntoViewIfNeeded();
  const ball = () => thing(page, "easing").locator(".ball").getAttribute("cy");
  await page.mouse.move(2, 2);
  await page.clock.runFor(6000);
  const stopped = await ball();
  await page.clock.runFor(500);
  assert.equal(await ball(), stopped);
});

test("old addresses still land: the figure of the former first page, and its sections", async (t) => {
  const page = await openStrict(t, "/#hero?t=0.25");
  await page.waitForURL("**/elements/#hero?t=0.25");
  await page.waitForSelector("html[data-address]");
  assert.equal(await page.locator("#hero bezier-applet").getAttribute("t"), "0.25");
  await page.goto("/");
  for (const id of ["learn", "use", "package"]) assert.equal(await page.locator(`#${id}`).count(), 1, id);
});
