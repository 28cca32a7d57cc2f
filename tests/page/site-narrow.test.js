// Every page of the site on a narrow phone, at 200 % zoom and in forced colours: nothing sticks out, nothing is lost.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openStrict, PAGES } from "./site-pages.js";

const PHONE = { viewport: { width: 360, height: 740 }, deviceScaleFactor: 2, hasTouch: true, isMobile: true };
/** What a window of 1280 px has left at 200 %. */
const ZOOMED = { viewport: { width: 640, height: 400 }, deviceScaleFactor: 2, forcedColors: /** @type {const} */ ("active") };

for (const path of PAGES) {
  test(`${path} fits`, async (t) => {
    for (const options of [PHONE, ZOOMED]) {
      const page = await openStrict(t, path, options);
      const wide = await page.evaluate(() =>
        [...document.querySelectorAll("body *")]
          .filter((element) => element.getBoundingClientRect().right > innerWidth + 1 && !element.closest("math, .scroll, .skip"))
          .map((element) => element.outerHTML.slice(0, 80)),
      );
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), options.viewport.width, wide.join("\n"));
      assert.equal(await page.locator("h1").count(), 1);
    }
  });
}
