// What the tests of the companions share.
import { frames, openPage } from "./browser.js";

/** A page with these elements; `script` runs before the elements are defined. */
export const companionsPage = (body, script = "") =>
  `<!doctype html><html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width"><meta name="color-scheme" content="light dark"><title>Companions</title>
<body style="margin: 8px; background: Canvas"><main><h1>Companions</h1>${body}</main>
<script>globalThis.heard = []; for (const type of ["input", "change"]) addEventListener(type, ({ target }) => heard.push(type + " " + (target.localName ?? "")));${script}</script>
<script type="module" src="dist/elements.js"></script></body></html>`;

/**
 * Opens such a page and waits until every companion shows something.
 *
 * @param {import("node:test").TestContext} t
 * @param {string} body
 * @param {import("playwright-core").BrowserContextOptions & { script?: string }} [options]
 */
export async function openCompanions(t, body, { script, ...options } = {}) {
  const page = await openPage(
    t,
    { html: companionsPage(body, script) },
    { viewport: { width: 800, height: 2000 }, reducedMotion: "reduce", ...options },
  );
  await shown(page);
  await heard(page); // forgets the events of the test before
  return page;
}

/** A page whose height has been the same for so many frames does not move any more. */
const STILL_FRAMES = 3;

/** Waits until every element of the page shows something, and nothing moves any more. */
export async function shown(page) {
  await page.waitForFunction(() =>
    [...document.querySelectorAll("bezier-bernstein, bezier-equation, bezier-coordinates, bezier-easing")].every(
      (each) => each.shadowRoot?.querySelector(".frame, .quiet"),
    ),
  );
  await page.waitForFunction(() =>
    [...document.querySelectorAll("bezier-applet")].every((each) => each.shadowRoot?.querySelector(".handle")),
  );
  await page.waitForFunction(
    (frames) => {
      const height = document.documentElement.scrollHeight;
      globalThis.framesOfHeight = height === globalThis.heightBefore ? globalThis.framesOfHeight + 1 : 0;
      globalThis.heightBefore = height;
      return globalThis.framesOfHeight >= frames;
    },
    STILL_FRAMES,
    { polling: "raf" },
  );
}

/** Waits until what was changed is drawn. */
export const settled = (page) => frames(page, 3);

/** What an element inside of a companion says. */
export const text = (page, selector) => page.locator(selector).innerText();

/** What the page has heard since it was asked last: "input" and "change", and from whom. */
export const heard = (page) => page.evaluate(() => globalThis.heard.splice(0));

/** Runs in the page with an element. */
export const on = (page, selector, act, given) => page.locator(selector).evaluate(act, given);

/** Pastes a text into a field. */
export async function paste(locator, text) {
  await locator.focus();
  await locator.evaluate((field, pasted) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData("text", pasted);
    field.dispatchEvent(
      new ClipboardEvent("paste", { clipboardData, bubbles: true, composed: true, cancelable: true }),
    );
  }, text);
}

/** Defines an element that casteljau/elements does not find by itself: in a shadow tree, or far from the visible part. */
export const load = (page, name) =>
  page.evaluate(async (name) => (await import("/dist/elements.js")).loadElement(name), name);
