// Links to a place on a page: it is at the upper edge of the window when the page has been drawn, and the scroll is not animated.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { assertAnchorsLand } from "./anchors-page.js";
import { openPage, root } from "./browser.js";
import { sectionsOf } from "./chapter-page.js";

for (const [path, ids] of /** @type {const} */ ([
  ["/curves/properties/", ["figure-hull", "affine-invariance"]],
  ["/surfaces/teapot/", ["figure-height", "history"]],
])) {
  test(`${path} opened at some of its anchors`, (t) => assertAnchorsLand(t, path, ids));
}

/** Places of the chapters as they were one page each, and where they are now. */
const FORWARDED = [
  ["/curves/#quadratic", /^\/curves\/quadratic\/$/],
  ["/curves/#figure-hull", /^\/curves\/properties\/#figure-hull$/],
  ["/curves/#sample-polyline", /^\/curves\/parameter\/#sample-polyline$/],
  ["/curves/#a-cubic-by-hand", /^\/curves\/de-casteljau\/#a-cubic-by-hand$/],
  ["/curves/#construction?t=0.25", /^\/curves\/de-casteljau\/#construction\?t=0\.25$/],
  ["/curves/#splitting?t=0.25", /^\/curves\/splitting\/#splitting\?t=0\.25$/],
  ["/surfaces/#cracks", /^\/surfaces\/cracks\/$/],
  ["/surfaces/#figure-gpu", /^\/surfaces\/gpu\/#figure-gpu$/],
];

test("a place of a chapter leads from the contents to the page of its section", async (t) => {
  const page = await openPage(t, "about:blank");
  for (const [from, to] of FORWARDED) {
    await page.goto("about:blank");
    await page.goto(String(from));
    await page.waitForURL((url) => /** @type {RegExp} */ (to).test(url.pathname + url.hash));
  }
  await page.goto("/curves/");
  await page.evaluate(() => (location.hash = "#figure-zoom"));
  await page.waitForURL(/\/curves\/recursive-rendering\/#figure-zoom$/);
});

test("every id of a section is in the contents of its chapter", async () => {
  for (const chapter of /** @type {const} */ (["curves", "surfaces"]))
    for (const { path, ids } of sectionsOf(chapter)) {
      const html = readFileSync(`${root}site${path}index.html`, "utf8").replace(/<svg\b.*?<\/svg>/gs, "");
      const main = html.slice(html.indexOf('<main id="main"') + 10);
      const own = Array.from(main.matchAll(/<[a-z][^<>]*?\sid="([^"]+)"/g), ([, id]) => id).filter(
        (id) => id !== "main",
      );
      assert.deepEqual(
        own.filter((id) => !ids.includes(id)),
        [],
        path,
      );
      assert.ok(
        ids.every((id) => own.includes(id)),
        path,
      );
    }
});

for (const [path, ids] of /** @type {const} */ ([
  ["/recipes/", ["icon-intersections", "teapot-three", "easing-to-linear", "style"]],
  ["/install/", ["slim", "vue"]],
  ["/migration/", ["paper-js", "curves-of-three-js"]],
  ["/benchmarks/", ["rust", "sizes"]],
])) {
  test(`${path} opened at some of its anchors`, (t) =>
    assertAnchorsLand(t, path, ids, { readsAddress: false, once: path !== "/recipes/" }));
}
