// Elements in someone else's page, under a strict policy: what the tests of tests/page/embedding*.test.js share.
import { openPage, root } from "./browser.js";
import { keepLedger } from "./ledger.js";
import { serve } from "./server.js";

const CSP = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'";

const NAMES = ["applet", "bernstein", "coordinates", "easing", "equation", "surface"].map((kind) => `bezier-${kind}`);

/** What makes one of a kind cheap to draw, or complete. */
const ATTRIBUTES = { "bezier-surface": { model: "patch", segments: "2" } };

/**
 * A page on a server of its own, with a strict policy, to which `policy` adds; its scripts are those of every bundle in `bundles`,
 * the first of which defines the elements.
 */
export async function openStrict(t, { bundles = ["/dist/"], body = "", policy = "", ...options } = {}) {
  const headers = { "Content-Security-Policy": CSP + policy };
  const server = await serve({ "/dist/": `${root}dist`, "/copy/": `${root}dist` }, headers);
  const page = await openPage(t, "about:blank", {
    baseURL: server.url,
    viewport: { width: 800, height: 1600 }, // all elements are near it
    reducedMotion: "reduce",
    ...options,
  });
  t.after(server.close); // when the page is closed
  await keepLedger(page);
  const scripts = bundles.map((folder) => `<script type="module" src="${folder}elements.js"></script>`).join("");
  server.pages.set(
    "/index.html",
    `<!doctype html><html lang="en"><meta charset="utf-8"><title>Host</title>${scripts}<body>${body}<main></main></body></html>`,
  );
  await page.goto("/index.html");
  await page.evaluate(
    async ([path, names]) => {
      const { loadElement } = await import(path);
      for (const name of names) await loadElement(name); // in this order, which is that of ledger.names
    },
    /** @type {const} */ ([`${bundles[0]}elements.js`, NAMES]),
  );
  await page.waitForFunction(() => globalThis.ledger.names.length > 0); // from now on the test's own tool listens, too
  return page;
}

/** Puts one of each kind into the page; their names. */
export const populate = (page) =>
  page.evaluate((attributes) => {
    globalThis.all = ledger.names.map((name) => {
      const element = document.createElement(name);
      for (const [key, value] of Object.entries(attributes[name] ?? {})) element.setAttribute(key, value);
      element.style.width = "160px";
      return element;
    });
    document.querySelector("main").append(...all);
    return ledger.names;
  }, ATTRIBUTES);

/** Waits until every one has drawn what it has to draw. */
export const settled = (page) =>
  page.waitForFunction(() =>
    all.every(({ isUpdatePending, shadowRoot }) => {
      const canvas = shadowRoot.querySelector("canvas");
      const facts = shadowRoot.querySelector(".facts");
      const shown = canvas ? canvas.width > 1 : shadowRoot.querySelector("svg, math, table");
      return !isUpdatePending && shown && (!facts || /triangles/.test(facts.textContent));
    }),
  );

/** Takes all out and puts them in again, so many times; every other time they get a frame to begin their work. */
export const comeAndGo = (page, times) =>
  page.evaluate(async (times) => {
    const frame = () => new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve))); // after the frame's own work
    for (let i = 0; i < times; i++) {
      for (const element of all) element.remove();
      if (i % 10 === 0) await frame();
      document.querySelector("main").append(...all);
      if (i % 2 === 0) await frame();
    }
  }, times);

/** Waits until all have begun again, which they do a little after they came: as much is alive as there was. */
export const begunAgain = (page, { listeners, observers }) =>
  page.waitForFunction(
    ([listeners, observers]) => ledger.count().listeners >= listeners && ledger.count().observers >= observers,
    [listeners, observers],
  );
