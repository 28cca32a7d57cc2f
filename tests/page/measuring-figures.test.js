// The figures of the chapter on curves about velocity, lengths, distances, intersections, circles and faces.
import assert from "node:assert/strict";
import { test } from "node:test";
import { boxOf, openPage } from "./browser.js";

/** @param {import("node:test").TestContext} t @param {string} name */
async function open(t, name) {
  const page = await openPage(t, "/figures/", { viewport: { width: 900, height: 900 }, reducedMotion: "reduce" });
  const figure = page.locator(name);
  await figure.scrollIntoViewIfNeeded();
  await figure.locator(".facts").first().waitFor();
  return { page, figure, facts: () => figure.locator(".facts").first().innerText() };
}

/** The numbers in a text. @param {string} text @param {RegExp} pattern */
const numbers = (text, pattern) => (pattern.exec(text) ?? []).slice(1).map(Number);

/** Drags a handle of a figure by so many CSS pixels. */
async function drag(page, handle, dx, dy) {
  const { x, y, width, height } = await boxOf(handle);
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.mouse.down();
  await page.mouse.move(x + width / 2 + dx, y + height / 2 + dy, { steps: 3 });
  await page.mouse.up();
}

test("the velocity at t = 0 is three legs long, and follows a drag", async (t) => {
  const { page, figure, facts } = await open(t, "fig-velocity");
  const leg = () => figure.evaluate((/** @type {any} */ { points: [p, q] }) => [q[0] - p[0], p[1] - q[1]]);
  const shown = async () => numbers((await facts()).replaceAll("−", "-"), /\((-?[\d.]+), (-?[\d.]+)\)/);
  const expected = async () => (await leg()).map((x) => Math.round(30 * x) / 10);
  assert.deepEqual(await shown(), await expected());
  await drag(page, figure.locator(".handle").nth(1), 10, -30);
  assert.ok((await leg())[1] > 5);
  assert.deepEqual(await shown(), await expected());
  await figure.getByRole("checkbox").check();
  await figure.locator("circle.ghost").waitFor();
});

test("arc length: the part before t grows to the whole", async (t) => {
  const { figure, facts } = await open(t, "fig-arc-length");
  const lengths = async () => numbers(await facts(), /Length ([\d.]+)\..*: ([\d.]+)\./s);
  const [whole, half] = await lengths();
  assert.ok(half < 0.4 * whole, `${half} of ${whole} at t = 0.5`);
  await figure.getByRole("slider", { name: "t", exact: true }).fill("1");
  assert.deepEqual(await lengths(), [whole, whole]);
});

test("nearest point: Q on the curve is at distance 0", async (t) => {
  const { figure, facts } = await open(t, "fig-nearest");
  assert.match(await facts(), /distance [1-9]\d\.\d/);
  await figure.evaluate((/** @type {any} */ element) => {
    const { x, y } = element.curve.eval(0.25);
    element.q = [x, y];
  });
  assert.match(await facts(), /t = 0\.250, distance 0\.0/);
});

test("intersections: one at first, none when the curve is dragged away", async (t) => {
  const { page, figure, facts } = await open(t, "fig-intersections");
  assert.match(await facts(), /^1 intersection, at/);
  const unit = (await boxOf(figure.locator("svg"))).height / 80;
  await drag(page, figure.locator(".handle").nth(4), 30 * unit, 15 * unit);
  assert.match(await facts(), /^0 intersections/);
});

test("a stroke takes its width, join and cap", async (t) => {
  const page = await openPage(t, "/figures/", { viewport: { width: 900, height: 900 } });
  const figure = page.locator("fig-stroke");
  const outline = () => figure.locator("svg path").first().getAttribute("d");
  let before = await outline();
  for (const change of [
    () => figure.getByRole("radio", { name: "bevel" }).check(),
    () => figure.getByRole("radio", { name: "square" }).check(),
    () => figure.getByRole("slider").fill("6"),
  ]) {
    await change();
    const after = await outline();
    assert.notEqual(after, before);
    before = after;
  }
});

test("a circle of four arcs: 0.027 % with the usual handles", async (t) => {
  const { figure, facts } = await open(t, "fig-circle");
  await figure.getByRole("slider", { name: "h" }).fill("0.5523");
  assert.match(await facts(), /0\.027\d % of the radius/);
  await figure.getByRole("radio", { name: "8" }).check();
  assert.match(await facts(), /0\.000\d %/);
});

test("faces: the one under the pointer is named; click and keys select; operations", async (t) => {
  const { page, figure, facts } = await open(t, "fig-faces");
  const stage = await boxOf(figure.locator("svg"));
  const unit = stage.height / 84;
  const at = (/** @type {number} */ x, /** @type {number} */ y) =>
    /** @type {[number, number]} */ ([stage.x + stage.width / 2 + (x - 60) * unit, stage.y + y * unit]);
  await page.mouse.move(...at(30, 28));
  assert.match(await facts(), /inside A, outside B and C/);
  await page.mouse.move(...at(60, 40));
  assert.match(await facts(), /inside A and B and C\. Area/);
  await page.mouse.click(...at(60, 40));
  assert.match(await facts(), /1 of 7 selected/);
  const face = figure.getByRole("checkbox", { name: "Face in B", exact: true });
  await face.focus();
  await page.keyboard.press("Space");
  assert.equal(await face.getAttribute("aria-checked"), "true");
  assert.match(await facts(), /2 of 7 selected/);
  await figure.getByRole("button", { name: "A ∩ B" }).click();
  assert.deepEqual(await figure.evaluate((/** @type {any} */ { chosen }) => [...chosen].sort()), ["110", "111"]);
});

test("halving: the difference of the lengths shrinks faster than the distance", async (t) => {
  const { figure } = await open(t, "fig-lengths");
  const read = async () => numbers(await figure.locator(".facts").innerText(), /D1 − D2 = ([\d.]+)\..*: ([\d.]+)\./s);
  const press = () => figure.getByRole("button", { name: "Halve" }).click();
  await press();
  const [difference, distance] = await read();
  await press();
  const [smaller, nearer] = await read();
  assert.ok(difference / smaller > 5 && difference / smaller < 11, `${difference} to ${smaller}`);
  assert.ok(distance / nearer > 3 && distance / nearer < 5.5, `${distance} to ${nearer}`);
});
