// <bezier-applet> with weights: what is loaded for them and when; a weight is dragged, changed by keys and by a screen reader.
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  ask,
  button,
  drag,
  fired,
  focus,
  ink,
  message,
  openApplet,
  press,
  set,
  settled,
} from "./bezier-applet-page.js";
import { assertAccessibleInBothThemes } from "./browser.js";
import { assertNear, centreOf, dragFrom, pullFrom } from "./gestures.js";

/** An arc of an ellipse. */
const ARC = 'points="100,400 100,100 400,100" degree="2" weights="1 0.75 1"';

const weightHandle = (page, k) => page.locator(`bezier-applet [data-weight="${k}"]`);
const weights = (page) => page.evaluate(() => a.weights);

/** Opens an applet with weights and waits for their handles. */
async function open(t, attributes = ARC, options = {}) {
  const page = await openApplet(t, attributes, options);
  await page.waitForFunction(() => a.shadowRoot.querySelector("[data-weight]"));
  await settled(page);
  await page.evaluate(() => void events.splice(0));
  return page;
}

/** Drags the handle of a weight and waits until it is drawn. */
async function dragWeight(page, k, dx, dy) {
  await dragFrom(page, await centreOf(weightHandle(page, k)), dx, dy, 2);
  await settled(page);
}

/** The last words of the live region. */
const announced = (page, words) =>
  page.waitForFunction((words) => a.shadowRoot.querySelector("[role=status]").textContent.includes(words), words);

const scripts = (page) =>
  page.evaluate(() =>
    performance
      .getEntriesByType("resource")
      .map(({ name }) => new URL(name).pathname)
      .filter((path) => /\/(elements-rational|nurbs[\w-]*)\.js$/.test(path))
      .sort(),
  );

test("rational curves are loaded when there are weights, and not before, without surfaces", async (t) => {
  const page = await openApplet(t, "controls", { fresh: true });
  assert.deepEqual(await scripts(page), []);
  await set(page, { weights: [1, 2, 1, 1, 1, 1, 1] });
  await page.waitForFunction(() => a.shadowRoot.querySelectorAll("[data-weight]").length === 6);
  assert.deepEqual(await scripts(page), ["/dist/elements-rational.js", "/dist/nurbs-rational-curve.js"]);
  assert.deepEqual(await ask(page, () => [a.figure.rational.length, a.figure.pieces.length]), [2, 0]);
  await set(page, { weights: null });
  assert.equal(await page.locator("bezier-applet [data-weight]").count(), 0);
  assert.deepEqual(await ask(page, () => [a.figure.rational.length, a.figure.pieces.length]), [0, 2]);
});

test("where the code for weights cannot be fetched a message says so; it is asked for again with the next change", async (t) => {
  const page = await openApplet(t, "", { fresh: true });
  await page.route("**/elements-rational.js*", (route) => route.abort());
  await page.evaluate(() => a.setAttribute("weights", "1 2 1 1 1 1 1"));
  await page.waitForFunction(() => /could not be loaded/.test(a.shadowRoot.querySelector(".message").textContent));
  assert.equal(await page.locator("bezier-applet [data-index]").count(), 7);
  await page.unroute("**/elements-rational.js*");
  await drag(page, 1, 5, 5);
  await page.waitForFunction(() => a.shadowRoot.querySelectorAll("[data-weight]").length === 6);
  await settled(page);
  assert.equal(await message(page), "");
  page.problems.length = 0; // Chromium says what could not be fetched
});

test("code and SVG of a figure that is far away are those of its rational curve", async (t) => {
  const page = await openApplet(t, "", {
    more: `<div style="height: 5000px"></div><bezier-applet id="b" ${ARC}></bezier-applet>`,
  });
  const [code, svg] = await page.evaluate(async () => {
    const b = document.getElementById("b");
    return [await b.toCode("js"), await b.toSVG()];
  });
  assert.match(code, /new RationalCurve\(/);
  assert.match(svg, />w1 = 0\.75</);
});

test("the curve is drawn with its weights, and a weight is dragged along its leg", async (t) => {
  const page = await open(t);
  const middle = (100 + 2 * 0.75 * 100 + 400) / (2 + 2 * 0.75);
  const drawn = async () => (await ink(page, [middle, middle], 2)) > 0;
  assert.ok(await drawn(), "the middle of the arc");
  await dragWeight(page, 0, 40, -200); // beside the leg, beyond what lies on it
  const [first, second, third] = await weights(page);
  assert.deepEqual([first, third], [1, 1], "one weight alone has changed");
  assert.ok(second > 3, `${second}`);
  assert.ok(!(await drawn()));
  const events = (await fired(page)).filter((type) => type !== "update");
  assert.deepEqual([events[0], events.indexOf("change")], ["input", events.length - 1], "one change, at the end");
  await announced(page, `Weight of P1: ${second}`);
  await ask(page, () => a.undo());
  assert.deepEqual(await weights(page), [1, 0.75, 1]);
  assert.equal(await message(page), "");
});

test("Esc takes the drag of a weight back; the page that is readonly keeps its weights", async (t) => {
  const page = await open(t);
  await pullFrom(page, await centreOf(weightHandle(page, 1)), 60, 0, 2);
  await settled(page);
  assert.ok((await weights(page))[2] > 1);
  await page.keyboard.press("Escape");
  await page.mouse.up();
  assert.deepEqual(await weights(page), [1, 0.75, 1]);
  await set(page, { readonly: true });
  await dragWeight(page, 1, 60, 0);
  assert.deepEqual(await weights(page), [1, 0.75, 1]);
});

test("keys: Tab reaches the weight after the points, arrows change it, one step of undo until the key is up", async (t) => {
  const page = await open(t, `${ARC} controls`);
  await focus(page, 2);
  await press(page, "Tab");
  assert.equal(await ask(page, () => a.shadowRoot.activeElement.getAttribute("aria-label")), "Weight of P1");
  const value = () => ask(page, () => a.shadowRoot.activeElement.getAttribute("aria-valuetext"));
  assert.equal(await value(), "0.75");
  await press(page, "ArrowUp");
  assert.deepEqual(await weights(page), [1, 0.7875, 1]);
  assert.equal(await value(), "0.7875");
  await announced(page, "Weight of P1: 0.7875");
  await press(page, "Shift+ArrowLeft");
  assertNear([(await weights(page))[1]], [0.7875 / 1.05 ** 10], 1e-3);
  await press(page, "Control+z");
  await press(page, "Control+z");
  assert.deepEqual(await weights(page), [1, 0.75, 1]);
  await press(page, "?");
  assert.match(await page.locator("bezier-applet dialog").innerText(), /at a weight: smaller or larger by 5 %/);
});

test("a screen reader moves the slider of a weight, which has its logarithm", async (t) => {
  const page = await open(t);
  await page.evaluate(() => {
    const input = a.shadowRoot.querySelector('[data-weight="0"] input');
    input.value = String(Math.log10(2));
    for (const type of ["input", "change"]) input.dispatchEvent(new Event(type, { bubbles: true, composed: true }));
  });
  await settled(page);
  assertNear([(await weights(page))[1]], [10 ** 0.3], 1e-3);
  assert.deepEqual(await fired(page), ["input", "change", "update"]);
});

test("points move as ever; layers that have no meaning for weights are not offered; the description says what there is", async (t) => {
  const page = await open(t, `${ARC} controls show="polygon offset"`);
  await drag(page, 1, 20, 10);
  assertNear(
    await ask(page, () => a.points),
    [
      [100, 400],
      [120, 110],
      [400, 100],
    ],
    1.5,
  );
  const labels = await page.locator("bezier-applet .layers").innerText();
  assert.match(labels, /Curvature comb/);
  assert.doesNotMatch(labels, /Offset curve|Recursive halving|String art/);
  assert.equal(await page.locator("bezier-applet .measure input").count(), 0);
  await page.waitForFunction(() =>
    /^1 rational Bézier curve of degree 2\..*Weights: 1, 0\.75, 1/.test(
      a.shadowRoot.querySelector("#description").textContent,
    ),
  );
  await assertAccessibleInBothThemes(page);
  await button(page, /Split at t/).click();
  await page.waitForFunction(() => a.shadowRoot.querySelectorAll("[data-weight]").length === 4);
  assert.deepEqual([(await weights(page)).length, await ask(page, () => a.figure.rational.length)], [5, 2]);
});
