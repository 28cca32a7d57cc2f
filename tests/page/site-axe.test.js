// Every page of the site: nothing for axe to object to, nothing in the console, and the strict policy is enough. axe looks at
// the whole page once, in the light; in the dark, and in forced colours where text opts out of them, at the colours. Of pages
// of one template it looks at the colours of two.
import { test } from "node:test";
import { TAGS } from "./application-page.js";
import { assertAccessible, COLOUR_RULES } from "./browser.js";
import { openStrict, PAGES, settled } from "./site-pages.js";

/** What has to be drawn before axe looks, by page; elements in chapters start when the reader comes near. */
const DRAWN = {
  "/figures/": ["fig-bytes svg rect"],
  "/curves/joining/": ["#joint [data-index]"],
  "/curves/splines/": ["#basis [data-index]"],
  "/curves/recursive-rendering/": ["#recursion [data-index]"],
  ...Object.fromEntries(Object.entries(TAGS).map(([path, tag]) => [path, [`${tag} svg`]])),
};
/** It has all texts of the site whose style has `forced-color-adjust: none`: pressed buttons, and those of samples. */
const FORCED_COLOURS = ["/surfaces/tessellation/"];
/** These pages are made from one template: the longest of them stands for the colours of all. */
const ONE_TEMPLATE = /^\/api\/(?!curve\/|elements\/)/;

for (const path of PAGES) {
  test(`${path} is accessible`, async (t) => {
    const page = await openStrict(t, path, { colorScheme: "light", reducedMotion: "reduce" });
    for (const selector of DRAWN[path] ?? []) {
      await page.locator(selector.split(" ")[0]).first().scrollIntoViewIfNeeded();
      await page.locator(selector).first().waitFor({ state: "attached" });
    }
    await assertAccessible(page, ONE_TEMPLATE.test(path) ? { without: COLOUR_RULES } : {});
    /** @type {Parameters<typeof page.emulateMedia>[0][]} */
    const themes = ONE_TEMPLATE.test(path) ? [] : [{ colorScheme: "dark" }];
    if (FORCED_COLOURS.includes(path)) themes.push({ forcedColors: "active" });
    for (const media of themes) {
      await page.emulateMedia(media);
      await settled(page);
      await assertAccessible(page, { rules: COLOUR_RULES });
    }
  });
}
