// Elements in someone else's page: they come and go a thousand times and leave nothing, and two copies get along.
import assert from "node:assert/strict";
import { test } from "node:test";
import { launch, openPage, root } from "./browser.js";
import { keepLedger, leftOver } from "./ledger.js";
import { serve } from "./server.js";

const CSP = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'";
const TIMES = 1000;
/** Until then the browser compiles what is called often. */
const WARM_UP = 250;
/** A mere byte kept for each time and kind would not be seen; an element, a listener or a closure is. */
const KEPT_BYTES_PER_TIME = 40;

// A thousand frames, as fast as they can be made.
launch(["--disable-frame-rate-limit", "--disable-gpu-vsync"]);

/** What makes one of a kind cheap to draw, or complete. */
const ATTRIBUTES = { "bezier-surface": { model: "patch", segments: "2" } };

/** A page on a server of its own, with a strict policy; its script defines the elements of every bundle in `bundles`. */
async function openStrict(t, { bundles = ["/dist/"], body = "", ...options } = {}) {
  const server = await serve({ "/dist/": `${root}dist`, "/copy/": `${root}dist` }, { "Content-Security-Policy": CSP });
  const page = await openPage(t, "about:blank", { baseURL: server.url, viewport: { width: 800, height: 900 }, reducedMotion: "reduce", ...options });
  t.after(server.close); // when the page is closed
  await keepLedger(page);
  const scripts = bundles.map((folder) => `<script type="module" src="${folder}elements.js"></script>`).join("");
  server.pages.set("/index.html", `<!doctype html><html lang="en"><meta charset="utf-8"><title>Host</title>${scripts}<body>${body}<main></main></body></html>`);
  await page.goto("/index.html");
  await page.waitForFunction(() => globalThis.ledger.names.length > 0);
  return page;
}

/** Puts one of each kind into the page; their names. */
const populate = (page) =>
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
const settled = (page) =>
  page.waitForFunction(() =>
    all.every(({ isUpdatePending, shadowRoot }) => {
      const canvas = shadowRoot.querySelector("canvas");
      const facts = shadowRoot.querySelector(".facts");
      const shown = canvas ? canvas.width > 1 : shadowRoot.querySelector("svg, math, table");
      return !isUpdatePending && shown && (!facts || /triangles/.test(facts.textContent));
    }),
  );

/** Takes all out and puts them in again, so many times; every other time they get a frame to begin their work. */
const comeAndGo = (page, times) =>
  page.evaluate(async (times) => {
    const frame = () => new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
    for (let i = 0; i < times; i++) {
      for (const element of all) element.remove();
      if (i % 10 === 0) await frame();
      document.querySelector("main").append(...all);
      if (i % 2 === 0) await frame();
    }
  }, times);

/** Waits until all have begun again, which they do a little after they came: as much is alive as there was. */
const begunAgain = (page, { listeners, observers }) =>
  page.waitForFunction(([listeners, observers]) => ledger.count().listeners >= listeners && ledger.count().observers >= observers, [listeners, observers]);

test("every kind of element comes and goes a thousand times and leaves nothing", async (t) => {
  const page = await openStrict(t);
  const client = await page.context().newCDPSession(page);
  const empty = await page.evaluate(() => ledger.count()); // the test's own tool listens, too
  const names = await populate(page);
  await settled(page);
  const begun = await page.evaluate(() => ledger.count());
  await comeAndGo(page, WARM_UP);
  await settled(page);
  await begunAgain(page, begun);
  const [before, leftBefore] = [await page.evaluate(() => ledger.count()), await leftOver(client)];
  await comeAndGo(page, TIMES);
  await settled(page);
  await begunAgain(page, before);
  const [after, leftAfter] = [await page.evaluate(() => ledger.count()), await leftOver(client)];
  assert.deepEqual({ ...after, frames: 0 }, { ...before, frames: 0 }, "while they are in the page");
  assert.equal(leftAfter.nodes, leftBefore.nodes, "nodes");
  assert.equal(leftAfter.listeners, leftBefore.listeners, "listeners of all kinds");
  assert.ok(after.contexts <= names.length, `${after.contexts} graphics contexts`);
  const grown = (leftAfter.bytes - leftBefore.bytes) / TIMES;
  assert.ok(grown < KEPT_BYTES_PER_TIME * names.length, `${grown} bytes each time`);
  await page.evaluate(() => all.forEach((element) => element.remove()));
  await page.evaluate(() => new Promise((done) => setTimeout(done)));
  const gone = await page.evaluate(() => [ledger.count(), ledger.types()]);
  assert.deepEqual(gone[0], { ...empty, contexts: after.contexts }, `when they are gone: ${gone[1]}`);
});

test("moved about they stay what they are", async (t) => {
  const page = await openStrict(t, { body: "<section></section>" });
  await populate(page);
  await settled(page);
  const before = await page.evaluate(() => ledger.count());
  await page.evaluate(async () => {
    const [main, section] = [document.querySelector("main"), document.querySelector("section")];
    for (const place of [section, main, section, main]) {
      for (const element of all) place.append(element);
      await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
    }
    for (const place of [section, main]) for (const element of all) place.moveBefore?.(element, null);
  });
  await settled(page);
  assert.deepEqual({ ...(await page.evaluate(() => ledger.count())), frames: 0 }, { ...before, frames: 0 });
});

test("two copies of the bundle on one page: the first defines, both work", async (t) => {
  const page = await openStrict(t, { bundles: ["/dist/", "/copy/"] });
  await populate(page);
  await settled(page);
  const names = await page.evaluate(() => ledger.names);
  assert.equal(new Set(names).size, names.length, `${names}`);
  const made = await page.evaluate(async () => {
    const [first, second] = await Promise.all([import("/dist/elements.js"), import("/copy/elements.js")]);
    return Object.entries(second).map(([name, type]) => [name, type === first[name], new type() instanceof HTMLElement]);
  });
  assert.ok(made.length > 0);
  for (const [name, same, element] of made) assert.ok(same && element, name);
});

test("under a strict policy every kind of element is drawn, styled, and the console is clean", async (t) => {
  const page = await openStrict(t);
  await populate(page);
  await settled(page);
  const sheets = await page.evaluate(() => all.map(({ localName, shadowRoot }) => [localName, shadowRoot.adoptedStyleSheets.length]));
  for (const [name, count] of sheets) assert.ok(count > 0, name);
});

test("where what draws cannot be fetched every kind says so, and asks again when it is put in again", async (t) => {
  const page = await openStrict(t);
  const parts = /elements-(applet|companions|surface)\.js/;
  await page.route(parts, (route) => route.abort());
  const names = await populate(page);
  const saying = (count) => page.waitForFunction((count) => all.filter(({ shadowRoot }) => /could not be (loaded|fetched)/.test(shadowRoot.textContent)).length === count, count);
  await saying(names.length);
  await page.unroute(parts);
  await page.evaluate(() => {
    for (const element of all) element.remove();
    document.querySelector("main").append(...all);
  });
  await settled(page);
  await saying(0);
  assert.ok(page.problems.splice(0).every((text) => /ERR_FAILED|Failed to load resource/.test(text)));
});
