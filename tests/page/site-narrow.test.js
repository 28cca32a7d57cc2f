// Every page of the site on a narrow phone, at 200 % zoom and in forced colours: nothing sticks out, nothing is lost.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openStrict, PAGES, settled } from "./site-pages.js";

const PHONE = { viewport: { width: 360, height: 740 }, deviceScaleFactor: 2, hasTouch: true, isMobile: true };
/** What a window of 1280 px has left at 200 %. */
const ZOOMED = { width: 640, height: 400 };

for (const path of PAGES) {
  test(`${path} fits`, async (t) => {
    const page = await openStrict(t, path, PHONE);
    await fits(page, PHONE.viewport);
    await page.setViewportSize(ZOOMED);
    await page.emulateMedia({ forcedColors: "active" });
    await settled(page);
    await fits(page, ZOOMED);
    assert.equal(await page.locator("h1").count(), 1);
  });
}

async function fits(page, { width }) {
  const wide = await page.evaluate(() =>
    [...document.querySelectorAll("body *")]
      .filter(
        (element) =>
          element.getBoundingClientRect().right > innerWidth + 1 &&
          !element.closest("math, .scroll, .skip, pre > code"),
      )
      .map((element) => element.outerHTML.slice(0, 80)),
  );
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width, wide.join("\n"));
}
