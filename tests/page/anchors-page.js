// Opens pages at an anchor and says where it lands.
import assert from "node:assert/strict";
import { intersectionsReported, openPage } from "./browser.js";

/** So far from its place, below the upper edge of the window and what sticks there, an anchor may land. */
const TOLERANCE_PX = 40;

/** All ids of a page's content, without JavaScript. @param {import("node:test").TestContext} t @param {string} path */
export async function anchorsOf(t, path) {
  const page = await openPage(t, path, { javaScriptEnabled: false });
  return page.locator("main [id]:not(svg *)").evaluateAll((all) => all.map(({ id }) => id));
}

/**
 * Fails unless a page that is opened at an anchor shows it at its place, or has been scrolled to its end.
 *
 * @param {import("node:test").TestContext} t
 * @param {string} path
 * @param {readonly string[]} ids
 * @param {import("playwright-core").BrowserContextOptions & { readsAddress?: boolean, once?: boolean }} [options]
 *   readsAddress: the page's scripts read the address, and mark the document when they have; once: the page is loaded
 *   once, and the other anchors are gone to from there
 */
export async function assertAnchorsLand(t, path, ids, { readsAddress = true, once = false, ...options } = {}) {
  const page = await openPage(t, "about:blank", { viewport: { width: 1280, height: 800 }, ...options });
  for (const id of ids) {
    if (!once) await page.goto("about:blank"); // a new document: otherwise only the fragment changes
    await page.goto(`${path}#${id}`);
    await page.waitForSelector(readsAddress ? "html[data-address]" : "html");
    for (let i = 0; i < 2; i++) await intersectionsReported(page); // what is near has been drawn, and moved what is below
    const { top, margin, rest } = await page.evaluate((id) => {
      const element = document.getElementById(id);
      const page = document.documentElement;
      const box = element.getClientRects().length > 0 ? element : element.firstElementChild; // the sheet of a figure
      return {
        top: box.getBoundingClientRect().top,
        margin: Number.parseFloat(getComputedStyle(page).scrollPaddingBlockStart),
        rest: page.scrollHeight - innerHeight - scrollY,
      };
    }, id);
    const atEnd = rest < 2 && top > 0;
    assert.ok(atEnd || Math.abs(top - margin) <= TOLERANCE_PX, `${path}#${id} is at ${top} px`);
  }
}
