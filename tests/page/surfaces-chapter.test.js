// The chapter on surfaces in a real browser: every figure starts and gives the graphics card back, links lead somewhere.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { test } from "node:test";
import { boxOf, openPage, root } from "./browser.js";
import { near, open } from "./surfaces-page.js";

const SECTIONS =
  "patches evaluation curves splitting normals joining tessellation cracks adaptive reyes forward-differencing gpu teapot revolution wireframe rays ray-tracing files other-representations".split(
    " ",
  );
/** Browsers lend about sixteen. */
const MOST_CONTEXTS = 10;

test("a figure shows its lines until it is drawn, and again while it is far away", async (t) => {
  // The first test of the file: no figure has been near yet.
  const page = await open(t);
  await near(page, "map-surface");
  const poster = (id) => page.locator(`#${id} > svg`).isVisible();
  await page.waitForFunction(() => !document.querySelector("#map-surface").shadowRoot.querySelector(".poster"));
  assert.equal(await poster("map-surface"), false);
  assert.equal(await poster("file-surface"), true, "not yet near");
  await near(page, "file-surface");
  await page.waitForFunction(() => document.querySelector("#map-surface").shadowRoot.querySelector(".poster"));
  await near(page, "map-surface");
  await page.waitForFunction(() => !document.querySelector("#map-surface").shadowRoot.querySelector(".poster"));
});

test("every figure is drawn when the reader comes near, and few hold the graphics card", async (t) => {
  const page = await open(t);
  const ids = await page.locator("bezier-surface").evaluateAll((all) => all.map(({ id }) => id));
  assert.ok(ids.length >= 18, `${ids.length} figures`);
  const living = () =>
    page.locator("bezier-surface").evaluateAll(
      (all) =>
        all.filter((/** @type {any} */ each) => {
          const canvas = each.shadowRoot.querySelector("canvas");
          return canvas.width > 1 && canvas.getContext("webgl2")?.isContextLost() === false;
        }).length,
    );
  for (const id of [...ids, ids[0]]) {
    await near(page, id);
    await page.evaluate(async (id) => {
      while (!(await document.getElementById(id).toBlob())) await new Promise((then) => requestAnimationFrame(then));
    }, id);
    assert.ok((await living()) <= MOST_CONTEXTS, `${await living()} at ${id}`);
  }
});

test("the sections, the figures' own places, and all that other pages link to are there", async (t) => {
  const page = await open(t);
  assert.deepEqual(await page.locator("main > section").evaluateAll((all) => all.map(({ id }) => id)), SECTIONS);
  assert.deepEqual(await page.locator("main figure:not([id])").count(), 0);
  const pages = readdirSync(`${root}site`, { recursive: true, encoding: "utf8" }).filter((name) =>
    name.endsWith(".html"),
  );
  const wanted = pages.flatMap((name) =>
    [...readFileSync(`${root}site/${name}`, "utf8").matchAll(/surfaces\/#([\w-]+)"/g)].map(([, id]) => id),
  );
  assert.ok(wanted.length > 15);
  assert.deepEqual(await page.evaluate((ids) => ids.filter((id) => !document.getElementById(id)), wanted), []);
  const own = await page.evaluate(() =>
    [...document.querySelectorAll('a[href^="#"]')]
      .map(({ hash }) => hash.slice(1))
      .filter((id) => !document.getElementById(id)),
  );
  assert.deepEqual(own, []);
});

test("without JavaScript every figure is there as lines, and the code can be read", async (t) => {
  const page = await openPage(t, "/surfaces/", { javaScriptEnabled: false, viewport: { width: 1100, height: 800 } });
  const figures = page.locator("bezier-surface");
  const count = await figures.count();
  assert.equal(await page.locator("bezier-surface > svg[role=img] path").count(), count);
  const { width, height } = await boxOf(figures.first().locator("svg path"));
  assert.ok(width > 100 && height > 60, `${width} × ${height}`);
  assert.ok(
    (await page.getByText("fn sample").count()) === 0 &&
      (await page.getByText("TessellationOptions::tolerance").first().isVisible()),
  );
});
