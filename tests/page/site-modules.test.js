// Which modules of the package a page of the site loads.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { gzipSync } from "node:zlib";
import { frames, intersectionsReported, isRelease, openPage, QUIET_FRAMES, root } from "./browser.js";
import { loadFigures, sectionsOf } from "./chapter-page.js";
import { settled } from "./site-pages.js";

/** The scripts with more than so many characters have a wasm module inside. */
const MODULE_LENGTH = 100_000;

/** The names of the large scripts that a page has loaded, without what Vite appends. @param {import("playwright-core").Page} page */
const loaded = (page) =>
  page.evaluate(
    (length) =>
      performance
        .getEntriesByType("resource")
        .filter((entry) => /\.js$/.test(entry.name) && /** @type {any} */ (entry).decodedBodySize > length)
        .map(({ name }) => name.replace(/^.*\/|-[\w-]{8}\.js$/g, "")),
    MODULE_LENGTH,
  );

/** Those that it has loaded when the scripts of all figures are there. */
async function modulesOf(t, path) {
  const page = await openPage(t, path);
  await settled(page);
  await loadFigures(page);
  return loaded(page);
}

/** Whether a module for weights is among the scripts: a release has one for curves and one for surfaces, a development build one for both. */
const hasWeights = (/** @type {string[]} */ names) => names.some((name) => name.startsWith("weights-"));

test("the module of surfaces is loaded where a surface is, and not for other elements", async (t) => {
  for (const path of ["/teapot/", "/surfaces/patches/", "/embed.html?element=bezier-surface"])
    assert.ok((await modulesOf(t, path)).includes("surfaces"), path);
  for (const path of ["/easing/", "/ink/", "/glyph/", "/curves/", "/curves/parameter/", "/texts/", "/embed.html"]) {
    const modules = await modulesOf(t, path);
    assert.ok(!modules.includes("surfaces"), `${path}: ${modules.join(", ")}`);
  }
});

test("the module of rational curves is loaded where a figure that has them is near", async (t) => {
  for (const [first, path, name] of [
    ["/curves/parameter/", "/curves/rational-curves/", "fig-conic"],
    ["/figures/", "/figures/", "fig-conic"],
    ["/surfaces/patches/", "/surfaces/sphere/", "#bodies"],
  ]) {
    const page = await openPage(t, first, { fresh: true });
    await settled(page);
    await intersectionsReported(page);
    await page.waitForFunction(() => customElements.get("lesson-task") || customElements.get("fig-parabola"));
    assert.ok(!hasWeights(await loaded(page)), `${first} at first`);
    if (path !== first) await page.goto(path);
    await page.locator(name).scrollIntoViewIfNeeded();
    await page.locator(`${name} .frame`).waitFor();
    await page.waitForFunction(() =>
      performance.getEntriesByType("resource").some((entry) => entry.name.includes("/weights-")),
    );
  }
  for (const path of ["/", "/easing/", "/glyph/"]) assert.ok(!hasWeights(await modulesOf(t, path)), path);
});

test("/recipes/ loads the modules of surfaces and of weights when a recipe that has them is near", async (t) => {
  const page = await openPage(t, "/recipes/", { fresh: true });
  await settled(page);
  await intersectionsReported(page);
  const isLoaded = async () => {
    const names = await loaded(page);
    return [names.includes("surfaces"), hasWeights(names)];
  };
  assert.deepEqual(await isLoaded(), [false, false]);
  const recipe = page.locator('[data-recipe="vase"]');
  await recipe.scrollIntoViewIfNeeded();
  await page.waitForFunction(() => document.querySelector("#vase-surface").surface?.patchCount === 36);
  assert.deepEqual(await isLoaded(), [true, true]);
});

/** The most that a section may take over the network, for a reader who goes through all of it. */
const MAX_SECTION_KB = 450;

/** Scrolls to the end by a window at a time, until no more files are asked for. @param {import("playwright-core").Page} page */
async function readThrough(page) {
  const count = () => page.evaluate(() => performance.getEntriesByType("resource").length);
  const { height, window } = await page.evaluate(() => ({
    height: document.documentElement.scrollHeight,
    window: innerHeight,
  }));
  for (let y = 0; y < height; y += window) {
    await page.evaluate((y) => scrollTo(0, y), y);
    await frames(page);
  }
  for (let before = -1; before !== (await count()); ) {
    before = await count();
    await frames(page, QUIET_FRAMES);
  }
}

if (isRelease)
  test(`a section takes at most ${MAX_SECTION_KB} kB, compressed`, async (t) => {
    const page = await openPage(t, "/curves/parameter/", { messages: /^$/ });
    const large = [];
    for (const { path } of [...sectionsOf("curves"), ...sectionsOf("surfaces")]) {
      await page.goto(path);
      await settled(page);
      await loadFigures(page);
      await readThrough(page);
      const files = await page.evaluate(() =>
        performance.getEntriesByType("resource").map(({ name }) => new URL(name).pathname),
      );
      const all = new Set([`${path}index.html`, ...files].filter((name) => /\.(html|js|css|woff2)$/.test(name)));
      const bytes = [...all].reduce(
        (sum, name) => sum + gzipSync(readFileSync(`${root}site${name}`), { level: 9 }).length,
        0,
      );
      t.diagnostic(`${path} ${(bytes / 1000).toFixed(0)} kB`);
      if (bytes > 1000 * MAX_SECTION_KB) large.push(`${path}: ${(bytes / 1000).toFixed(0)} kB`);
    }
    assert.deepEqual(large, []);
  });
