// Opens pages of the built site in a real Chromium. A test that leaves an error in the console fails.
import { AxeBuilder } from "@axe-core/playwright";
import assert from "node:assert/strict";
import { after } from "node:test";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";
import { chromePath, FLAGS } from "./chrome.js";
import { serve } from "./server.js";

export { chromePath };

/** The repository's root, with a slash at its end. */
export const root = fileURLToPath(new URL("../../", import.meta.url));

/** One browser and one server for all tests of a file. */
const shared = { browser: undefined, site: undefined, count: 0 };

after(async () => {
  await (await shared.browser)?.close();
  (await shared.site)?.close();
});

/**
 * The running browser; started at the first call.
 *
 * @param {string[]} [more] flags, where the first call is a test file's own
 */
export function launch(more = []) {
  shared.browser ??= chromium.launch({ executablePath: chromePath(), args: [...FLAGS, ...more] });
  return shared.browser;
}

/**
 * Opens a page of the built site (site/, and dist/ under /dist/), and closes it when the test ends.
 *
 *     test("…", async (t) => {
 *       const page = await openPage(t, "/applet/", { colorScheme: "dark", viewport: { width: 360, height: 640 } });
 *       const other = await openPage(t, { html: `<script src="bezier-app.js"></script>…` });   // at the site's root
 *
 * When the test ends it fails if the console showed an error, unless `page.problems` was emptied by the test itself.
 *
 * @param {import("node:test").TestContext} t
 * @param {string | { html: string }} what a path of the site, or a page as text
 * @param {import("playwright-core").BrowserContextOptions & { baseURL?: string }} [options] baseURL: another server
 * @returns {Promise<import("playwright-core").Page & { problems: string[] }>}
 */
export async function openPage(t, what, options = {}) {
  const baseURL = options.baseURL ?? (await site()).url;
  const context = await (await launch()).newContext({ ...options, baseURL });
  const page = Object.assign(await context.newPage(), { problems: watch(context) });
  t.after(async () => {
    await context.close();
    assert.deepEqual(page.problems, [], "the page's console is clean");
  });
  await page.goto(typeof what === "string" ? what : await written(what.html));
  return page;
}

/**
 * Fails unless axe finds nothing to object to.
 *
 * @param {import("playwright-core").Page} page
 * @param {{ part?: string, rules?: string[] }} [only] a selector, the names of some rules
 */
export async function assertAccessible(page, { part, rules } = {}) {
  const axe = new AxeBuilder({ page }).options({ resultTypes: ["violations"] }); // of the rest only a count is kept
  if (part) axe.include(part);
  if (rules) axe.withRules(rules);
  const { violations } = await axe.analyze();
  const found = violations.map(({ id, help, nodes }) => `${id}: ${help} at ${nodes.map((n) => n.target).join(", ")}`);
  assert.deepEqual(found, []);
}

/** Collects what goes wrong in any page of a context. */
function watch(context) {
  const problems = [];
  context.on("console", (message) => message.type() === "error" && problems.push(message.text()));
  context.on("weberror", (error) => problems.push(String(error.error())));
  return problems;
}

function site() {
  shared.site ??= serve({ "/": `${root}site`, "/dist/": `${root}dist` });
  return shared.site;
}

async function written(html) {
  const path = `/page-${++shared.count}.html`;
  (await site()).pages.set(path, html);
  return path;
}
