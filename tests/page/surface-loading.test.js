// The part of <bezier-surface> that draws comes by itself, when one is near: late, never, twice, or after the element has gone.
import assert from "node:assert/strict";
import { test } from "node:test";
import { intersectionsReported, openPage } from "./browser.js";
import { facts, look, ready, surfacePage } from "./surface-page.js";

/** By its own name, and by the other one under which a browser is asked again. */
const PART = /\/elements-surface\.js(\?.*)?$/;
const MISSING = "could not be loaded";

/** Opens a page whose requests for the part go to `answer`; `asked` counts them. */
async function openWithRoute(t, html, answer) {
  const page = await openPage(t, "about:blank", { viewport: { width: 800, height: 900 }, reducedMotion: "reduce" });
  const asked = { count: 0 };
  await page.route(PART, (route) => {
    asked.count++;
    return answer(route);
  });
  await page.route("**/loading.html", (route) => route.fulfill({ contentType: "text/html", body: html }));
  await page.goto("/loading.html");
  await page.evaluate(async () => (await import("/dist/elements.js")).loadElement("bezier-surface"));
  return { page, asked };
}

/** A gate that holds requests back until it is opened. */
function gate() {
  let open;
  const opened = new Promise((done) => (open = done));
  return { open, pass: (route) => opened.then(() => route.continue()) };
}

test("a page without a surface in sight does not fetch it; it is fetched once for two that come near", async (t) => {
  const html = surfacePage("", "<bezier-surface id=second></bezier-surface>").replace(
    "<main>",
    '<main><div style="height: 4000px"></div>',
  );
  const { page, asked } = await openWithRoute(t, html, (route) => route.continue());
  await intersectionsReported(page);
  const sizes = () =>
    page.locator("bezier-surface canvas").evaluateAll((/** @type {any[]} */ all) => all.map(({ width }) => width));
  assert.deepEqual([asked.count, await sizes()], [0, [1, 1]], "nothing runs");
  await page.locator("#second").scrollIntoViewIfNeeded();
  await page.waitForFunction(() =>
    [...document.querySelectorAll("bezier-surface")].every((each) =>
      /triangles/.test(each.shadowRoot.querySelector(".facts").textContent),
    ),
  );
  assert.equal(asked.count, 1);
  assert.ok((await sizes()).every((width) => width > 100));
});

test("until it is there the element waits, and what is asked of it then counts", async (t) => {
  const late = gate();
  const { page } = await openWithRoute(t, surfacePage('model="patch" segments="4" controls'), late.pass);
  await page.waitForFunction(() => document.querySelector("bezier-surface").shadowRoot?.querySelector("canvas"));
  const element = page.locator("bezier-surface");
  await element.evaluate((each) => Object.assign(each, { segments: 3, view: { turn: 12 } }));
  await page.getByRole("button", { name: "Nearer" }).click();
  const blob = element.evaluate((/** @type {any} */ each) => each.toBlob().then((picture) => picture?.type));
  late.open();
  assert.equal(await blob, "image/png");
  await ready(page);
  assert.equal((await facts(page)).triangles, 18);
  const view = await element.evaluate((/** @type {any} */ each) => each.view);
  assert.equal(view.turn, 12);
  assert.ok(view.zoom > 1);
  assert.ok((await look(page)).inked > 3000);
});

test("an element that has gone before it arrives stays at rest; put in again it draws", async (t) => {
  const late = gate();
  const { page } = await openWithRoute(t, surfacePage('model="patch" segments="4"'), late.pass);
  await page.waitForFunction(() => document.querySelector("bezier-surface").shadowRoot?.querySelector("canvas"));
  const contexts = await page.evaluate(() => {
    globalThis.made = 0;
    const original = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = /** @returns {any} */ function (...args) {
      globalThis.made++;
      return Reflect.apply(original, this, args);
    };
    globalThis.element = document.querySelector("bezier-surface");
    element.remove();
    return globalThis.made;
  });
  late.open();
  await page.evaluate(() => import("/dist/elements-surface.js").then(() => new Promise((done) => setTimeout(done))));
  assert.equal(await page.evaluate(() => globalThis.made), contexts);
  await page.evaluate(() => document.querySelector("main").append(element));
  await ready(page);
  assert.ok((await page.evaluate(() => globalThis.made)) > contexts);
});

test("taken out and put in again before it arrives, it is built once", async (t) => {
  const late = gate();
  const { page } = await openWithRoute(t, surfacePage('model="patch" segments="4"'), late.pass);
  await page.waitForFunction(() => document.querySelector("bezier-surface").shadowRoot?.querySelector("canvas"));
  await page.evaluate(async () => {
    globalThis.made = 0;
    const original = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = /** @returns {any} */ function (...args) {
      if (args.length > 1) globalThis.made++; // whoever wants to draw says how
      return Reflect.apply(original, this, args);
    };
    const element = document.querySelector("bezier-surface");
    for (let i = 0; i < 5; i++) {
      element.remove();
      document.querySelector("main").append(element);
      await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    }
  });
  late.open();
  await ready(page);
  assert.equal(await page.evaluate(() => globalThis.made), 1);
});

test("where it cannot be fetched the element says so, and asks again when it is put in again", async (t) => {
  let broken = true;
  const { page } = await openWithRoute(t, surfacePage('model="patch" segments="4" controls'), (route) =>
    broken ? route.abort() : route.continue(),
  );
  await page.getByText(MISSING).waitFor();
  await page.getByText("More").click();
  await page.getByRole("slider", { name: "Segments" }).fill("5"); // the panel goes on
  const element = page.locator("bezier-surface");
  const pictureType = () =>
    element.evaluate((/** @type {any} */ each) => each.toBlob().then((picture) => picture?.type)); // waits for the attempt that is under way
  assert.equal(await pictureType(), undefined);
  const putInAgain = () =>
    page.evaluate(() => document.querySelector("main").append(document.querySelector("bezier-surface")));
  const refused = page.waitForEvent("requestfailed", (request) => PART.test(request.url()));
  await putInAgain();
  await refused;
  assert.equal(await pictureType(), undefined);
  assert.equal(await page.getByText(MISSING).count(), 1);
  broken = false;
  const answered = page.waitForResponse((response) => PART.test(response.url()) && response.ok());
  await putInAgain();
  await answered;
  await ready(page);
  await page.getByText(MISSING).waitFor({ state: "detached" });
  assert.equal((await facts(page)).triangles, 50);
  assert.ok(page.problems.splice(0).every((text) => /ERR_FAILED|Failed to load resource/.test(text)));
});
