// What the tests of the chapter on surfaces share.
import { openPage } from "./browser.js";
import { goTo } from "./chapter-page.js";

/** A section of the chapter, once for the tests of a file; `near` goes to others. @param {import("node:test").TestContext} t */
export async function open(t, options = {}) {
  const page = await openPage(t, "/surfaces/patches/", {
    viewport: { width: 1100, height: 800 },
    reducedMotion: "reduce",
    messages: /context/i,
    keep: true,
    ...options,
  });
  await page.waitForSelector("html[data-address]", { state: "attached" });
  return page;
}

/** Scrolls a figure to where it starts, and waits until it has been drawn. @param {import("playwright-core").Page} page @param {string} id */
export async function near(page, id) {
  await goTo(page, id);
  const element = page.locator(`#${id}`);
  await element.scrollIntoViewIfNeeded();
  await page.waitForFunction((id) => {
    const element = /** @type {any} */ (document.getElementById(id));
    return element.figure.mesh.triangles > 0 && element.shadowRoot.querySelector("canvas").width > 1;
  }, id);
  return element;
}

/** The controls of a figure, and the line that says what it shows. */
export const controls = (page, id) => page.locator(`#${id}`);
export const reading = (page, id) => page.locator(`surface-reading[for="${id}"]`);
