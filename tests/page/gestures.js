// Pointer gestures, and the comparison of places, for the tests of all pages.
import assert from "node:assert/strict";
import { boxOf } from "./browser.js";

/**
 * Fails unless numbers, or points, differ by at most so much.
 *
 * @param {any[]} actual
 * @param {any[]} expected
 * @param {number} tolerance
 * @param {string} [words]
 */
export function assertNear(actual, expected, tolerance, words = "near") {
  const [a, b] = [actual.flat(), expected.flat()];
  const far = a.length === b.length ? Math.max(...a.map((value, i) => Math.abs(value - b[i]))) : NaN;
  assert.ok(far <= tolerance, `${words}: ${JSON.stringify(actual)}, expected ${JSON.stringify(expected)}`);
}

/** The centre of an element, in the window. @param {import("playwright-core").Locator} locator @returns {Promise<[number, number]>} */
export async function centreOf(locator) {
  const { x, y, width, height } = await boxOf(locator);
  return [x + width / 2, y + height / 2];
}

/**
 * Presses the button at a place and moves the pointer by so many pixels; the button stays down.
 *
 * @param {import("playwright-core").Page} page
 * @param {number[]} place
 */
export async function pullFrom(page, [x, y], dx, dy, steps = 4) {
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + dx, y + dy, { steps });
}

/** Drags from a place by so many pixels. */
export async function dragFrom(page, place, dx, dy, steps = 4) {
  await pullFrom(page, place, dx, dy, steps);
  await page.mouse.up();
}

/** Drags an element at its centre by so many pixels. */
export async function dragBy(page, locator, dx, dy) {
  await locator.scrollIntoViewIfNeeded();
  await dragFrom(page, await centreOf(locator), dx, dy);
}

/**
 * Fingers on the page: `touch("touchMove", [10, 20], [30, 40])`; without places all fingers are lifted.
 *
 * @param {import("playwright-core").Page} page with a touch screen
 */
export async function fingersOn(page) {
  const client = await page.context().newCDPSession(page);
  return (/** @type {"touchStart" | "touchMove" | "touchEnd" | "touchCancel"} */ type, ...places) =>
    client.send("Input.dispatchTouchEvent", { type, touchPoints: places.map(([x, y], id) => ({ x, y, id })) });
}

/** Clicks, and reads the file that the page then gives to the user. @param {import("playwright-core").Locator} button */
export async function downloadBy(button) {
  const [download] = await Promise.all([button.page().waitForEvent("download"), button.click()]);
  const chunks = [];
  for await (const chunk of await download.createReadStream()) chunks.push(chunk);
  return { name: download.suggestedFilename(), bytes: Buffer.concat(chunks) };
}

/** Between the two clicks of a double click, in seconds. */
const DOUBLE_CLICK_S = 0.1;

/**
 * Clicks twice at a place. The events carry times of their own, so that it is a double click on a slow machine, too.
 *
 * @param {import("playwright-core").Page} page
 * @param {[number, number]} place in the window
 */
export async function doubleClick(page, [x, y]) {
  await page.mouse.move(x, y);
  const client = await page.context().newCDPSession(page);
  const first = Date.now() / 1000;
  for (const [clickCount, timestamp] of [
    [1, first],
    [2, first + DOUBLE_CLICK_S],
  ]) {
    for (const type of ["mousePressed", "mouseReleased"]) {
      await client.send("Input.dispatchMouseEvent", {
        type: /** @type {any} */ (type),
        x,
        y,
        button: "left",
        clickCount,
        timestamp,
      });
    }
  }
}

/**
 * Taps twice, at two places near each other; see doubleClick.
 *
 * @param {import("playwright-core").Page} page with a touch screen
 * @param {...[number, number]} places in the window
 */
export async function doubleTap(page, ...places) {
  const client = await page.context().newCDPSession(page);
  const first = Date.now() / 1000;
  for (const [k, [x, y]] of places.entries()) {
    const timestamp = first + k * DOUBLE_CLICK_S;
    await client.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [{ x, y }], timestamp });
    await client.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [], timestamp });
  }
}
