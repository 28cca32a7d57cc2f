// What the tests of the site's pages share: which pages there are, and how one is opened as strictly as it is meant to be served.
import { readdirSync } from "node:fs";
import { after } from "node:test";
import { launch, openPage, root } from "./browser.js";
import { serve } from "./server.js";

/** All pages of the built site, as paths. */
export const PAGES = readdirSync(`${root}site`, { recursive: true, encoding: "utf8" })
  .filter((name) => name.endsWith(".html"))
  .map((name) => `/${name.replace(/\\/g, "/").replace(/index\.html$/, "")}`)
  .sort();

/** This one carries the tutorial's inline lines, to the letter. */
const INLINE = ["/applet/"];
const POLICY =
  "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:";

/** A software renderer's own remarks. */
const DRIVER = /GL Driver Message|Automatic fallback to software WebGL/;

/** @type {{ strict?: ReturnType<typeof serve> }} */
const shared = {};
after(async () => (await shared.strict)?.close());

/** The site with the strict policy as a header. */
export const strictSite = () =>
  (shared.strict ??= serve({ "/": `${root}site` }, { "Content-Security-Policy": POLICY }));

/**
 * Opens a page with the strict policy, where it allows for it; anything in the console is a problem, not errors alone.
 *
 * @param {import("node:test").TestContext} t
 * @param {string} path
 * @param {import("playwright-core").BrowserContextOptions} [options]
 */
export async function openStrict(t, path, options = {}) {
  await launch();
  const baseURL = INLINE.includes(path) ? undefined : (await strictSite()).url;
  const page = await openPage(t, "about:blank", { ...options, ...(baseURL && { baseURL }) });
  page.on(
    "console",
    (message) =>
      DRIVER.test(message.text()) ||
      message.type() === "error" ||
      page.problems.push(`${message.type()}: ${message.text()}`),
  );
  await page.goto(path, { waitUntil: "load" });
  await settled(page);
  return page;
}

/** Waits until fonts, modules and the first pictures are there: two frames after the address has been read, if the page reads it. */
export async function settled(page) {
  await page.waitForFunction(() => document.readyState === "complete");
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}
