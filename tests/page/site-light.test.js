// Every page of the site, light: nothing for axe to object to, nothing in the console, and the strict policy is enough.
import { test } from "node:test";
import { assertAccessible } from "./browser.js";
import { openStrict, PAGES } from "./site-pages.js";

for (const path of PAGES) {
  test(`${path}, light`, async (t) => assertAccessible(await openStrict(t, path, { colorScheme: "light" })));
}
