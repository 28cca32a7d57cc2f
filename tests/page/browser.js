// Opens pages of the built site in a real Chromium. A test that leaves an error in the console fails.
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { after } from "node:test";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";
import { BROWSER_ADDRESS, launchOptions } from "./chrome.js";
import { serve } from "./server.js";

/** The repository's root, with a slash at its end. */
export const root = fileURLToPath(new URL("../../", import.meta.url));

/** A package that is built for development has no tables of pieces, and modules that are several times as large. */
export const isRelease = existsSync(`${root}dist/custom/pieces.json`);

/** Waiting ends with an error after so long: on a busy machine a page may take many seconds. */
const LONGEST_WAIT_MS = 120_000;

/** One browser and one server for all tests of a file. @type {{ browser?: Promise<import("playwright-core").Browser>, site?: ReturnType<typeof serve>, count: number }} */
const shared = { count: 0 };

after(async () => {
  await Promise.all([...kept.values()].map(({ context }) => context.close()));
  await (await shared.browser)?.close();
  (await shared.site)?.close();
});

/** The browser that the runner has started, or else one of this file's own; connected or started at the first call. */
export function launch() {
  const address = process.env[BROWSER_ADDRESS];
  shared.browser ??= address ? chromium.connect(address) : chromium.launch(launchOptions());
  return shared.browser;
}

/** Options of a context that a page can also change later. */
const CHANGEABLE = ["viewport", "colorScheme", "reducedMotion", "forcedColors"];
const VIEWPORT = { width: 1280, height: 720 };

/**
 * A context that the tests of a file share, one after the other, and its page.
 *
 * @typedef {object} Kept
 * @property {import("playwright-core").BrowserContext} context
 * @property {import("playwright-core").Page & { problems: string[] }} page
 * @property {string} [frame] the page's text around the content of `<main>`, if the content can be replaced
 * @property {string[]} [globals] the names of the global variables after loading
 * @property {import("node:test").TestContext} [test] the test that uses it, or the last one that did
 * @property {boolean} busy whether a test uses it
 * @property {boolean} [loaded] whether the page is one that stays as it is for the next test
 */

/** @type {Map<string, Kept>} by those options of the context that cannot be changed later, and the path of a page that stays */
const kept = new Map();

/**
 * @typedef {import("playwright-core").BrowserContextOptions & {
 *   baseURL?: string, fresh?: boolean, keep?: boolean, messages?: RegExp
 * }} PageOptions baseURL: another server; messages: those of the console that count as errors, besides errors
 */

/**
 * Opens a page of the built site (site/, and dist/ under /dist/). CASTELJAU_SITE can name another folder: `npm test` serves
 * dist/, because pages as text need no more.
 *
 *     test("…", async (t) => {
 *       const page = await openPage(t, "/applet/", { colorScheme: "dark", viewport: { width: 360, height: 640 } });
 *       const other = await openPage(t, { html: `<script src="bezier-app.js"></script>…` });   // at the site's root
 *
 * The tests of a file share a context. A page as text that differs from the last one only in the content of `<main>` is not
 * loaded again: the content is replaced, and global variables of the last test are deleted. With `keep`, the tests of a
 * file that open the same path use one page, which is loaded once: each test gets it as the last one has left it, with the
 * window and the media reset. After a failed test, and with `fresh` (for a page that writes into its storage when it is
 * closed), the page has a context of its own.
 *
 * When the test ends it fails if the console showed an error, unless `page.problems` was emptied by the test itself.
 *
 * @param {import("node:test").TestContext} t
 * @param {string | { html: string }} what a path of the site, or a page as text
 * @param {PageOptions} [options]
 * @returns {Promise<import("playwright-core").Page & { problems: string[] }>}
 */
export async function openPage(t, what, { fresh = false, keep = false, messages, ...options } = {}) {
  const baseURL = options.baseURL ?? (await site()).url;
  const fixed = Object.entries({ ...options, baseURL }).filter(([name]) => !CHANGEABLE.includes(name));
  const key = JSON.stringify(keep ? [what, fixed] : fixed);
  let slot = fresh ? undefined : kept.get(key);
  if (slot && !slot.busy && !slot.test?.passed) {
    await slot.context.close();
    slot = undefined;
  }
  const parts = typeof what === "string" ? undefined : /^(.*<main>)(.*)(<\/main>.*)$/s.exec(what.html);
  const [frame, content] = parts && !parts[2].includes("<script") ? [parts[1] + parts[3], parts[2]] : [];
  const replaces = slot && !slot.busy && frame !== undefined && slot.frame === frame;
  const stays = keep && slot?.loaded && !slot.busy;
  if (!slot || slot.busy) {
    const context = await (await launch()).newContext({ ...options, baseURL });
    context.setDefaultTimeout(LONGEST_WAIT_MS);
    const own = { context, page: await newPage(context), busy: false };
    if (!fresh && !slot) kept.set(key, own);
    slot = own;
  } else if (!replaces && !stays) {
    await slot.page.close(); // again, if it is closed already
    slot.page = await newPage(slot.context);
  }
  const current = slot;
  const { page, context } = current;
  Object.assign(current, { busy: true, test: t, frame, loaded: keep });
  page.problems = [];
  /** @param {import("playwright-core").ConsoleMessage} message */
  const listen = (message) => {
    if (message.type() === "error" || messages?.test(message.text())) page.problems.push(message.text());
  };
  const fail = (error) => page.problems.push(String(error.error()));
  context.on("console", listen).on("weberror", fail);
  t.after(async () => {
    if (kept.get(key) === current) {
      if (!keep) await page.evaluate(leave, frame !== undefined).catch(() => {}); // the page may be closed, or have no storage
      if (!keep && frame === undefined) await page.close();
      current.busy = false;
    } else await context.close();
    context.off("console", listen).off("weberror", fail);
    assert.deepEqual(page.problems, [], "the page's console is clean");
  });
  await adjust(page, options);
  if (replaces) await page.evaluate(replaceContent, /** @type {any} */ ([content, current.globals]));
  else if (!stays) {
    await page.goto(typeof what === "string" ? what : await written(what.html));
    if (frame !== undefined) current.globals = await page.evaluate(() => Object.getOwnPropertyNames(globalThis));
  }
  return page;
}

/** @param {import("playwright-core").BrowserContext} context */
const newPage = async (context) => Object.assign(await context.newPage(), { problems: /** @type {string[]} */ ([]) });

/**
 * Sets those options of a context that can be changed, to their default values if they are absent.
 *
 * @param {import("playwright-core").Page} page
 * @param {import("playwright-core").BrowserContextOptions} options
 */
async function adjust(page, { viewport, colorScheme, reducedMotion, forcedColors }) {
  await page.setViewportSize(viewport ?? VIEWPORT);
  await page.emulateMedia({
    media: null,
    colorScheme: colorScheme ?? "light",
    reducedMotion: reducedMotion ?? "no-preference",
    forcedColors: forcedColors ?? "none",
  });
  await page.mouse.move(0, 0);
}

/** Runs in the page at the end of a test: empties what the pages of a context share, and a page that is not closed. */
function leave(stays) {
  if (stays) document.querySelector("main").replaceChildren();
  localStorage.clear();
  sessionStorage.clear();
}

/** Runs in the page: replaces the content of `<main>`, and removes what the last test has left. */
function replaceContent([content, globals]) {
  const isOfLit = (name) => /^(lit|reactive)/.test(name); // elements that are loaded later need these variables
  for (const name of Object.getOwnPropertyNames(globalThis))
    if (!globals.includes(name) && !isOfLit(name)) delete globalThis[name];
  history.replaceState(null, "", location.pathname);
  scrollTo(0, 0);
  getSelection()?.removeAllRanges();
  const main = document.querySelector("main");
  const empty = main.cloneNode(false); // without the listeners of the last test
  main.replaceWith(empty);
  empty.setHTMLUnsafe(content);
}

/**
 * Fails unless axe finds nothing to object to.
 *
 * @param {import("playwright-core").Page} page
 * @param {{ part?: string, rules?: string[], without?: string[] }} [only] a selector, the names of some rules or of those to leave out
 */
export async function assertAccessible(page, { part, rules, without } = {}) {
  const { AxeBuilder } = await import("@axe-core/playwright"); // most files do without it
  const axe = new AxeBuilder({ page }).options({ resultTypes: ["violations"] }); // of the rest only a count is kept
  axe.setLegacyMode(page.frames().length === 1); // the other mode puts the results of several frames together in a page of its own
  if (part) axe.include(part);
  if (rules) axe.withRules(rules);
  if (without) axe.disableRules(without);
  const { violations } = await axe.analyze();
  const found = violations.map(({ id, help, nodes }) => `${id}: ${help} at ${nodes.map((n) => n.target).join(", ")}`);
  assert.deepEqual(found, []);
}

/** What a colour scheme changes: the other rules find the same in the dark. */
export const COLOUR_RULES = ["color-contrast", "link-in-text-block"];

/**
 * Fails unless axe finds nothing: by all rules in the light, by those about colours in the dark. In forced colours the
 * contrast is the user's, but for text that opts out (`forced-color-adjust`); no element has such text.
 *
 * @param {import("playwright-core").Page} page in the light
 * @param {(page: import("playwright-core").Page) => Promise<unknown>} [settled] waits until a change of the colours is drawn
 */
export async function assertAccessibleInBothThemes(page, settled = frames) {
  await assertAccessible(page);
  await page.emulateMedia({ colorScheme: "dark" });
  await settled(page);
  await assertAccessible(page, { rules: COLOUR_RULES });
}

/**
 * The box of an element, which must be visible.
 *
 * @param {import("playwright-core").Locator} locator
 */
export async function boxOf(locator) {
  const box = await locator.boundingBox();
  assert.ok(box, "expected a visible element");
  return box;
}

/** Waits for so many animation frames: after two, what was changed before has been drawn. */
export const frames = (page, count = 2) =>
  page.evaluate(async (count) => {
    for (let i = 0; i < count; i++) await new Promise((resolve) => requestAnimationFrame(resolve));
  }, count);

/** Frames in which something would have happened that must not happen. */
export const QUIET_FRAMES = 12;

/**
 * Waits until all intersection observers of the page have reported what is in sight, and the requests that followed have
 * been answered: an observer made now reports after them, and a request made now is made after theirs.
 */
export const intersectionsReported = (page) =>
  page.evaluate(async () => {
    for (let i = 0; i < 2; i++) {
      await /** @type {Promise<void>} */ (
        new Promise((resolve) => {
          const observer = new IntersectionObserver(() => {
            observer.disconnect();
            resolve();
          });
          observer.observe(document.documentElement);
        })
      );
    }
    await (await fetch(location.href)).text();
  });

function site() {
  shared.site ??= serve({ "/": `${root}${process.env.CASTELJAU_SITE ?? "site"}`, "/dist/": `${root}dist` });
  return shared.site;
}

async function written(html) {
  const path = `/page-${++shared.count}.html`;
  (await site()).pages.set(path, html);
  return path;
}
