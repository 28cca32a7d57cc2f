// The chapter on surfaces in a real browser: every figure starts and gives the graphics card back, links lead somewhere.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { test } from "node:test";
import { boxOf, openPage, root } from "./browser.js";
import { sectionsOf } from "./chapter-page.js";
import { near, open } from "./surfaces-page.js";

const SECTIONS =
  "patches evaluation curves splitting normals joining tessellation cracks adaptive reyes forward-differencing gpu teapot revolution sphere wireframe rays ray-tracing files other-representations".split(
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
  assert.equal(await poster("nine-surface"), true, "not yet near");
  await near(page, "nine-surface");
  await page.locator("footer").scrollIntoViewIfNeeded();
  await page.waitForFunction(() => document.querySelector("#map-surface").shadowRoot.querySelector(".poster"));
  const opacity = await page.evaluate(
    () => getComputedStyle(document.querySelector("#map-surface").shadowRoot.querySelector("canvas")).opacity,
  );
  assert.equal(opacity, "0", "a canvas without its context is white");
  await near(page, "map-surface");
  await page.waitForFunction(() => !document.querySelector("#map-surface").shadowRoot.querySelector(".poster"));
});

test("every figure is drawn when the reader comes near, and few hold the graphics card", async (t) => {
  const page = await open(t);
  const living = () =>
    page.locator("bezier-surface").evaluateAll(
      (all) =>
        all.filter((/** @type {any} */ each) => {
          const canvas = each.shadowRoot.querySelector("canvas");
          return canvas.width > 1 && canvas.getContext("webgl2")?.isContextLost() === false;
        }).length,
    );
  let count = 0;
  for (const { path } of sectionsOf("surfaces")) {
    await page.goto(path);
    const ids = await page.locator("bezier-surface").evaluateAll((all) => all.map(({ id }) => id));
    count += ids.length;
    for (const id of ids) {
      await near(page, id);
      await page.evaluate(async (id) => {
        while (!(await document.getElementById(id).toBlob())) await new Promise((then) => requestAnimationFrame(then));
      }, id);
      assert.ok((await living()) <= MOST_CONTEXTS, `${await living()} at ${id}`);
    }
  }
  assert.ok(count >= 18, `${count} figures`);
});

test("the sections are there, and other pages link to them by their own addresses", () => {
  const names = sectionsOf("surfaces").map(({ id }) => id);
  assert.deepEqual(
    SECTIONS.filter((id) => !names.includes(id)),
    [],
  );
  const pages = readdirSync(`${root}site`, { recursive: true, encoding: "utf8" }).filter((name) =>
    name.endsWith(".html"),
  );
  const links = pages.flatMap((name) =>
    [
      ...readFileSync(`${root}site/${name}`, "utf8").matchAll(/"(?:\.\.\/)*((?:curves|surfaces)\/[\w-]*\/?#[^"]*)"/g),
    ].map(([, link]) => link),
  );
  assert.ok(links.length > 60, `${links.length} links`); // site-links.test.js follows them
  assert.deepEqual(
    links.filter((link) => /^\w+\/#/.test(link)),
    [],
  );
});

test("without JavaScript every figure is there as lines, and the code can be read", async (t) => {
  const viewport = { width: 1100, height: 800 };
  const page = await openPage(t, "/surfaces/patches/", { javaScriptEnabled: false, viewport });
  const figures = page.locator("bezier-surface");
  const count = await figures.count();
  assert.equal(await page.locator("bezier-surface > svg[role=img] path").count(), count);
  const { width, height } = await boxOf(figures.first().locator("svg path"));
  assert.ok(width > 100 && height > 60, `${width} × ${height}`);
  await page.goto("/surfaces/cracks/");
  assert.ok(
    (await page.getByText("fn sample").count()) === 0 &&
      (await page.getByText("TessellationOptions::tolerance").first().isVisible()),
  );
});
