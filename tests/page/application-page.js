// What the tests of the applications share.
import assert from "node:assert/strict";
import { openPage } from "./browser.js";

/** The pages of the tools, and what a tool is in its page. */
export const TOOLS = ["/easing/", "/camera/", "/glyph/", "/ink/", "/teapot/"];
export const TOOL = "main > :is(easing-lab, camera-path, glyph-editor, ink-pad, .stage)";
export const PHONE = { viewport: { width: 360, height: 740 }, deviceScaleFactor: 2, hasTouch: true, isMobile: true };
/** The applications and their elements. @type {Record<string, string>} */
export const TAGS = {
  "/easing/": "easing-lab",
  "/camera/": "camera-path",
  "/glyph/": "glyph-editor",
  "/ink/": "ink-pad",
};

/** Opens an application, and waits until it has drawn. */
export async function open(t, path, options = {}) {
  const page = await openPage(t, path, {
    viewport: { width: 1000, height: 1000 },
    reducedMotion: "reduce",
    ...options,
  });
  await page.locator(`${TAGS[path]} svg`).first().waitFor();
  return page;
}

/** What the address holds. */
export const state = (page) =>
  page.evaluate(() => JSON.parse(decodeURIComponent(location.hash.slice("#state=".length))));

/** Sets a slider. */
export const slide = (page, name, value) => page.getByRole("slider", { name, exact: true }).first().fill(String(value));

export const close = (a, b, tolerance) => assert.ok(Math.abs(a - b) <= tolerance, `${a} is not ${b}`);
