// What the tests of the site's pages share: which pages there are, and how one is opened as strictly as it is meant to be served.
import { readdirSync } from "node:fs";
import { after } from "node:test";
import { frames, launch, openPage, root } from "./browser.js";
import { serve } from "./server.js";

/** All pages of the built site, as paths, without the Rust documentation, which rustdoc makes. */
export const PAGES = readdirSync(`${root}site`, { recursive: true, encoding: "utf8" })
  .filter((name) => name.endsWith(".html") && !/^rust[\\/]/.test(name))
  .map((name) => `/${name.replace(/\\/g, "/").replace(/index\.html$/, "")}`)
  .sort();

/** This one carries the tutorial's inline lines, to the letter. */
const INLINE = ["/applet/"];
const POLICY =
  "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:";

/** Every message but a software renderer's own. */
const MESSAGES = /^(?!.*(GL Driver Message|Automatic fallback to software WebGL))/s;

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
 * @param {import("./browser.js").PageOptions} [options]
 */
export async function openStrict(t, path, options = {}) {
  await launch();
  const baseURL = INLINE.includes(path) ? undefined : (await strictSite()).url;
  const page = await openPage(t, path, { messages: MESSAGES, ...options, ...(baseURL && { baseURL }) });
  await settled(page);
  return page;
}

/** Waits until fonts, modules and the first pictures are there: two frames after the address has been read, if the page reads it. */
export async function settled(page) {
  await page.waitForFunction(() => document.readyState === "complete");
  await frames(page);
}
