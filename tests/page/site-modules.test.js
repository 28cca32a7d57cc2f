// Which modules of the package a page of the site loads.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openPage } from "./browser.js";
import { settled } from "./site-pages.js";

/** The scripts with more than so many characters have a wasm module inside. */
const MODULE_LENGTH = 100_000;

/** The names of the large scripts that a page has loaded, without what Vite appends. */
async function modulesOf(t, path) {
  const page = await openPage(t, path);
  await settled(page);
  await page.waitForFunction(() => !document.querySelector("main :not(:defined)")); // the scripts of all figures are there
  return page.evaluate(
    (length) =>
      performance
        .getEntriesByType("resource")
        .filter((entry) => /\.js$/.test(entry.name) && /** @type {any} */ (entry).decodedBodySize > length)
        .map(({ name }) => name.replace(/^.*\/|-[\w-]{8}\.js$/g, "")),
    MODULE_LENGTH,
  );
}

test("the module of surfaces is loaded where a surface is, and not for other elements", async (t) => {
  for (const path of ["/teapot/", "/surfaces/", "/embed.html?element=bezier-surface"])
    assert.ok((await modulesOf(t, path)).includes("surfaces"), path);
  for (const path of ["/easing/", "/ink/", "/glyph/", "/curves/", "/texts/", "/embed.html"]) {
    const modules = await modulesOf(t, path);
    assert.ok(!modules.includes("surfaces"), `${path}: ${modules.join(", ")}`);
  }
});

test("the module of rational curves is loaded where a figure has them", async (t) => {
  for (const path of ["/curves/", "/figures/"]) assert.ok((await modulesOf(t, path)).includes("nurbs"), path);
  for (const path of ["/", "/surfaces/", "/recipes/", "/easing/", "/glyph/"])
    assert.ok(!(await modulesOf(t, path)).includes("nurbs"), path);
});
