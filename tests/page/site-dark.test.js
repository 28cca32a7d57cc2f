// Every page of the site, dark: enough contrast, and nothing in the console. What does not depend on colours is tested light.
import { test } from "node:test";
import { assertAccessible } from "./browser.js";
import { openStrict, PAGES } from "./site-pages.js";

for (const path of PAGES) {
  test(`${path}, dark`, async (t) => assertAccessible(await openStrict(t, path, { colorScheme: "dark" }), { rules: ["color-contrast", "link-in-text-block"] }));
}
