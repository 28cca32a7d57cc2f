// Elements in someone else's page: they come and go and leave nothing, and two copies get along.
import assert from "node:assert/strict";
import { test } from "node:test";
import { frames } from "./browser.js";
import { begunAgain, comeAndGo, openStrict, populate, settled } from "./embedding-page.js";

/** embedding.deep.test.js does it a thousand times and looks at the heap, too. */
const TIMES = 20;

test("every kind of element comes and goes and leaves nothing running", async (t) => {
  const page = await openStrict(t);
  const empty = await page.evaluate(() => ledger.count()); // the test's own tool listens, too
  const names = await populate(page);
  await settled(page);
  const before = await page.evaluate(() => ledger.count());
  await comeAndGo(page, TIMES);
  await settled(page);
  await begunAgain(page, before);
  const after = await page.evaluate(() => ledger.count());
  assert.deepEqual({ ...after, frames: 0 }, { ...before, frames: 0 }, "while they are in the page");
  assert.ok(after.contexts <= names.length, `${after.contexts} graphics contexts`);
  await page.evaluate(() => all.forEach((element) => element.remove()));
  await frames(page);
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
      await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
    }
    for (const place of [section, main]) for (const element of all) place.moveBefore?.(element, null);
  });
  await settled(page);
  await begunAgain(page, before);
  assert.deepEqual({ ...(await page.evaluate(() => ledger.count())), frames: 0 }, { ...before, frames: 0 });
});

test("two copies of the bundle on one page: the first defines, both work", async (t) => {
  const page = await openStrict(t, { bundles: ["/dist/", "/copy/"] });
  await populate(page);
  await settled(page);
  const names = await page.evaluate(() => ledger.names);
  assert.equal(new Set(names).size, names.length, `${names}`);
  const made = await page.evaluate(async () => {
    const kinds = ledger.names.map((name) => name.replace("bezier-", ""));
    const modules = (folder) => Promise.all(kinds.map((kind) => import(`/${folder}/elements/${kind}.js`)));
    const [first, second] = await Promise.all([modules("dist"), modules("copy")]);
    const classes = second.flatMap((module, i) =>
      Object.entries(module).flatMap(([name, type]) =>
        name.startsWith("Bezier") ? [[name, type, first[i][name]]] : [],
      ),
    );
    return classes.map(([name, type, other]) => [name, type === other, new type() instanceof HTMLElement]);
  });
  assert.ok(made.length > 0);
  for (const [name, same, element] of made) assert.ok(same && element, String(name));
  const undo = await page.evaluate(async () => {
    const applet = document.querySelector("bezier-applet");
    applet.controls = true;
    const texts = [];
    for (const given of [{ Undo: "Annuler" }, {}]) {
      (await import("/copy/elements.js")).setTranslations(given);
      await applet.updateComplete;
      texts.push(/Annuler/.test(applet.shadowRoot.innerHTML));
    }
    return texts;
  });
  assert.deepEqual(undo, [true, false], "the texts of the copy that did not define the elements");
});

test("under a strict policy every kind of element is drawn, styled, and the console is clean", async (t) => {
  const page = await openStrict(t);
  await populate(page);
  await settled(page);
  const sheets = await page.evaluate(() =>
    all.map(({ localName, shadowRoot }) => [localName, shadowRoot.adoptedStyleSheets.length]),
  );
  for (const [name, count] of sheets) assert.ok(count > 0, name);
});

test("where what draws cannot be fetched every kind says so, and asks again when it is put in again", async (t) => {
  const page = await openStrict(t);
  const parts = /elements-(applet|bernstein|coordinates|easing|equation|surface)\.js/;
  await page.route(parts, (route) => route.abort());
  const names = await populate(page);
  const saying = (count) =>
    page.waitForFunction(
      (count) =>
        all.filter(({ shadowRoot }) => /could not be (loaded|fetched)/.test(shadowRoot.textContent)).length === count,
      count,
    );
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

test("every kind of element works with Trusted Types, if the policy of Lit is allowed", async (t) => {
  const page = await openStrict(t, { policy: "; require-trusted-types-for 'script'; trusted-types lit-html" });
  await populate(page);
  await settled(page);
});
