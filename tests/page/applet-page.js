// What the tests of the applet share: the tutorial's page, hands and eyes.
import { frames, openPage } from "./browser.js";
import { centreOf, pullFrom } from "./gestures.js";
import { countPixels } from "./pixels.js";

export { assertNear } from "./gestures.js"; // for tests/browsers

/** The tutorial's own two lines, to the letter. */
export const TUTORIAL = `<canvas style="margin-bottom: 10px;" id="beziercanvas" width="670px" height="480px">You don't support canvas</canvas>
<script type="text/javascript">window.addEventListener("load", bezierApp, false);</script>`;

/** A page with the classic script and the tutorial's lines; `more` stands between or after them. */
export const tutorialPage = (more = "") =>
  `<!doctype html><html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>Tutorial</title>
<body style="margin: 8px"><main><h1>A lesson</h1><script src="bezier-app.js"></script>${TUTORIAL}${more}</main></body></html>`;

/**
 * Opens the tutorial's page; warnings count as errors.
 *
 * @param {import("node:test").TestContext} t
 * @param {import("playwright-core").BrowserContextOptions & { more?: string }} [options]
 */
export async function openTutorial(t, { more, ...options } = {}) {
  const viewport = { width: 800, height: 1000 };
  const page = await openPage(t, { html: tutorialPage(more) }, { viewport, messages: /./, ...options });
  await handle(page, 0).waitFor();
  return page;
}

/** The HTML handle of a point. */
export const handle = (page, index) => page.locator(`[part="handle"][data-index="${index}"]`);

/** All points, from the applet. */
export const points = (page) => page.evaluate(() => bezierApp().points);

/** Waits until what was changed has been drawn. */
export const drawn = (page) => frames(page);

/** Where a handle's centre is in the window. */
export const centre = (page, index) => centreOf(handle(page, index));

/** Presses on a point and moves it by so many pixels, in steps; the button stays down. */
export async function pull(page, index, dx, dy) {
  await pullFrom(page, await centre(page, index), dx, dy);
  await drawn(page);
}

/** Drags a point by so many pixels. */
export async function drag(page, index, dx, dy) {
  await pull(page, index, dx, dy);
  await page.mouse.up();
  await drawn(page);
}

/** How many pixels of a colour (red, green, blue) lie within 2 CSS pixels of a place of the picture. */
export const countColour = (page, place, colour) =>
  countPixels(page.locator("canvas").first(), { colour, at: place, reach: 2, alpha: 200 });

/** Colours of the light theme. */
export const BLUE = [0, 114, 178];
export const VERMILION = [213, 94, 0];
export const GREEN = [0, 138, 100];

/** A cubic's point by the Bernstein polynomials, written out here so that nothing under test computes it. */
export function cubicAt(/** @type {number[][]} */ [p0, p1, p2, p3], t) {
  const s = 1 - t;
  return [0, 1].map((k) => s ** 3 * p0[k] + 3 * s * s * t * p1[k] + 3 * s * t * t * p2[k] + t ** 3 * p3[k]);
}

/** What P2, P3, P4 are to each other: the sine of the angle between P2P3 and P3P4, its cosine, the two lengths. */
export function joint([, , p2, p3, p4]) {
  const [a, b] = [
    [p3[0] - p2[0], p3[1] - p2[1]],
    [p4[0] - p3[0], p4[1] - p3[1]],
  ];
  const [before, after] = [Math.hypot(...a), Math.hypot(...b)];
  const [cross, dot] = [a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]];
  return { sine: cross / before / after, cosine: dot / before / after, before, after };
}
