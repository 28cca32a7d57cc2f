// Every page of the site, light and dark: nothing for axe to object to, nothing in the console, and the strict policy is enough.
import { test } from "node:test";
import { assertAccessible } from "./browser.js";
import { openStrict, PAGES, settled } from "./site-pages.js";

/** What a colour scheme changes; the rest is the same as in the light. */
const COLOURS = ["color-contrast", "link-in-text-block"];
for (const path of PAGES) {
  test(`${path}, light and dark`, async (t) => {
    const page = await openStrict(t, path, { colorScheme: "light" });
    await assertAccessible(page);
    await page.emulateMedia({ colorScheme: "dark" });
    await settled(page);
    await assertAccessible(page, { rules: COLOURS });
  });
}
