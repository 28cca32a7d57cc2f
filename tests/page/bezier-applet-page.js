// What the tests of <bezier-applet> share: a page with one element, hands and eyes.
import { openPage } from "./browser.js";
import { centreOf, pullFrom } from "./gestures.js";
import { countPixels } from "./pixels.js";

export const appletPage = (attributes = "", inside = "", more = "") =>
  `<!doctype html><html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width"><meta name="color-scheme" content="light dark"><title>A curve</title>
<body style="margin: 8px; background: Canvas"><main><h1>A curve</h1><bezier-applet id="a" ${attributes}>${inside}</bezier-applet>${more}</main>
<script type="module">import "./dist/elements.js"; import * as casteljau from "./dist/index.js"; globalThis.bezier = casteljau;</script></body></html>`;

/**
 * Opens such a page and waits until the element has drawn; `events` collects what it fires.
 *
 * @param {import("node:test").TestContext} t
 * @param {string} attributes
 * @param {import("playwright-core").BrowserContextOptions & { inside?: string, more?: string, fresh?: boolean }} [options]
 */
export async function openApplet(t, attributes = "", { inside, more, ...options } = {}) {
  const page = await openPage(
    t,
    { html: appletPage(attributes, inside, more) },
    { viewport: { width: 800, height: 1500 }, ...options },
  );
  await page.waitForFunction(
    () =>
      globalThis.bezier && document.querySelector("bezier-applet").shadowRoot?.querySelector(".overlay")?.style.width,
  );
  await page.evaluate(() => {
    globalThis.a = document.getElementById("a");
    a.shadowRoot.querySelector(".more")?.setAttribute("open", "");
    globalThis.events = [];
    for (const type of ["input", "change", "update"])
      document.querySelector("main").addEventListener(type, () => events.push(type), true);
  });
  await settled(page);
  await page.evaluate(() => void events.splice(0));
  return page;
}

/** Waits until what was changed has been drawn. */
export const settled = (page) =>
  page.evaluate(async () => {
    for (let i = 0; i < 2; i++) {
      await a.updateComplete;
      await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
    }
  });

/** What has been fired since the last call, without what repeats. */
export const fired = (page) => page.evaluate(() => events.splice(0).filter((type, i, all) => type !== all[i - 1]));

/** Sets properties of the element and waits until they are drawn. */
export async function set(page, properties) {
  await page.evaluate((given) => Object.assign(a, given), properties);
  await settled(page);
}

export const points = (page) => page.evaluate(() => a.points);

/** The points as the attribute has them: "70,330 110,90 …". */
export const pointsText = (page) => page.evaluate(() => a.points.join(" "));

/** The seven points that are there at first. */
export const FIRST = "70,330 110,90 235,120 325,230 433,362 590,400 600,130";

/** A value of the page's, computed from the element `a`. */
export const ask = (page, what) => page.evaluate(what);

export const handle = (page, index) => page.locator(`bezier-applet [data-index="${index}"]`);

/** The middle of a handle, on the screen. */
export const centre = (page, index) => centreOf(handle(page, index));

/** Presses a point and pulls it, without letting go. */
export async function pull(page, index, dx, dy) {
  await pullFrom(page, await centre(page, index), dx, dy, 2);
  await settled(page);
}

export async function drag(page, index, dx, dy) {
  await pull(page, index, dx, dy);
  await page.mouse.up();
  await settled(page);
}

/** Puts the keyboard on a point. */
export async function focus(page, index) {
  await handle(page, index).locator("input").first().focus();
  await settled(page);
}

/** Presses a key, where the focus is. */
export async function press(page, key, times = 1) {
  for (let i = 0; i < times; i++) await page.keyboard.press(key);
  await settled(page);
}

export const button = (page, name) => page.locator("bezier-applet").getByRole("button", { name });

/** The message below the picture. */
export const message = (page) => page.evaluate(() => a.shadowRoot.querySelector(".message").innerText.trim());

/** How many pixels of the picture, round a place, are drawn on. */
export const ink = (page, at, reach = 4) =>
  countPixels(page.locator("bezier-applet canvas").first(), { at, reach, alpha: 128 });
