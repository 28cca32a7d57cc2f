// The small figures of the chapters: their numbers are right, keys and pointers work, everyone can use them.
import assert from "node:assert/strict";
import { test } from "node:test";
import { boxOf, openPage } from "./browser.js";
import { dragBy } from "./gestures.js";

/** The page with all figures, once for all tests: each has a figure of its own. Waits until the last is drawn. */
async function open(t) {
  const page = await openPage(t, "/figures/", {
    viewport: { width: 1000, height: 900 },
    reducedMotion: "reduce",
    keep: true,
  });
  await page.locator("fig-bytes svg rect").first().waitFor();
  return page;
}

/** Sets a slider as a person does it with the keyboard's help: value and event. */
const slide = (page, figure, name, value) =>
  page.locator(figure).getByRole("slider", { name, exact: true }).fill(String(value));
const close = (a, b, tolerance = 1e-12) => assert.ok(Math.abs(a - b) <= tolerance, `${a} is not ${b}`);
const choose = (n, k) => (k === 0 ? 1 : (choose(n, k - 1) * (n - k + 1)) / k);
const bernstein = (n, i, t) => choose(n, i) * t ** i * (1 - t) ** (n - i);

test("the pyramid is walked with arrow keys, counts its paths, and their sum is the Bernstein polynomial", async (t) => {
  const page = await open(t);
  const figure = page.locator("fig-pyramid");
  assert.equal(await figure.locator(".node[tabindex='0']").count(), 1, "one stop for Tab");
  await figure.locator(".node[tabindex='0']").focus();
  for (const key of ["ArrowUp", "ArrowRight"]) await page.keyboard.press(key);
  const focused = await figure.evaluate((each) => each.shadowRoot?.activeElement?.getAttribute("aria-label"));
  assert.match(String(focused), /^level 2, coefficient 2/);
  await figure.getByRole("radio", { name: "5" }).check();
  await slide(page, "fig-pyramid", "t", 0.3);
  for (const [level, index] of [
    [5, 2],
    [5, 0],
    [3, 1],
  ]) {
    await figure.getByRole("button", { name: `level ${level}, coefficient ${index}:` }).click();
    assert.equal(await figure.locator(".ways button").count(), choose(level, index));
    close(Number(await figure.locator("[data-sum]").getAttribute("data-sum")), bernstein(level, index, 0.3));
  }
  const lit = () => figure.locator(".arrow.lit").count();
  assert.equal(await lit(), 7, "the arrows between the top and the node: 2 × 1 + 1 … of a parallelogram 2 × 1");
  await figure.locator(".ways button").first().hover();
  await figure.locator(".ways button[aria-pressed=true]").waitFor();
  assert.equal(await lit(), 3, "one path has three steps");
});

test("the binomial's terms are a row of Pascal's triangle and make one", async (t) => {
  const page = await open(t);
  await page.locator("fig-binomial").getByRole("radio", { name: "6" }).check();
  await slide(page, "fig-binomial", "t", 0.35);
  const weights = await page
    .locator("fig-binomial [data-weight]")
    .evaluateAll((bars) => bars.map((bar) => Number(bar.dataset.weight)));
  weights.forEach((weight, i) => close(weight, bernstein(6, i, 0.35)));
  assert.match(
    String(await page.locator("fig-binomial svg").first().getAttribute("aria-label")),
    /1, 6, 15, 20, 15, 6, 1$/,
  );
});

test("the parabola's point is t², and any part of it has the right control points", async (t) => {
  const page = await open(t);
  await slide(page, "fig-parabola", "t", -1.2);
  assert.equal(await page.locator("fig-parabola .point").innerText(), "(−1.2, 1.44)");
  await slide(page, "fig-parabola", "from", -1);
  await slide(page, "fig-parabola", "to", 0.5);
  // P1 is where the tangents at a and b meet: ((a + b) / 2, a b).
  assert.equal(await page.locator("fig-parabola .control").innerText(), "(−1, 1), (−0.25, −0.5), (0.5, 0.25)");
});

test("operations are those of the listings; the clock runs in this browser", async (t) => {
  const page = await open(t);
  const figure = page.locator("fig-costs");
  const counts = (key) =>
    figure.locator(`tr[data-way=${key}] td`).evaluateAll((cells) => cells.slice(0, 2).map((cell) => cell.textContent));
  assert.deepEqual(await counts("written"), ["6−, 9+, 22×", "6−, 9+, 22×"]);
  assert.deepEqual(await counts("casteljau"), ["6−, 18+, 36×", "6−, 18+, 36×"]);
  assert.deepEqual((await counts("horner"))[1], "0−, 9+, 9×");
  await figure.getByRole("button", { name: "Measure" }).click();
  await figure.locator("tr[data-way=package] td[data-time]").waitFor();
  const times = await figure
    .locator("td[data-time]")
    .evaluateAll((cells) => cells.map((cell) => Number(cell.dataset.time)));
  assert.equal(times.length, 6);
  assert.ok(
    times.every((time) => time > 0 && time < 1e6),
    String(times),
  );
});

/** De Casteljau's greatest error in 32 bits, on the figure's first case, written once more. */
function greatestError() {
  const f = Math.fround;
  const axes = [(i) => i / 3, (i) => Math.sin(2.4 * i + 0.7)].map((at) => [0, 1, 2, 3].map((i) => f(at(i))));
  const at = (round, row, t) =>
    row.length === 1
      ? row[0]
      : at(
          round,
          row.slice(1).map((b, i) => round(round(round(1 - t) * row[i]) + round(t * b))),
          t,
        );
  const ts = Array.from({ length: 2304 }, (_, i) => f((i + 0.5) / 2304));
  return Math.max(...ts.map((t) => Math.hypot(...axes.map((axis) => at(f, axis, t) - at((x) => x, axis, t)))));
}

test("rounding: honest errors of four methods, the power basis worst at high degrees", async (t) => {
  const page = await open(t);
  const figure = page.locator("fig-rounding");
  const read = async (name) => {
    await figure.getByRole("combobox").selectOption(name);
    return figure
      .locator("tr[data-method]")
      .evaluateAll((rows) =>
        Object.fromEntries(
          rows.map((row) => [row.dataset.method, Number(row.querySelector("[data-error]").dataset.error)]),
        ),
      );
  };
  const ulp = 2 ** -23;
  for (const [method, error] of Object.entries(await read("near")))
    assert.ok(error > 0.1 * ulp && error < 8 * ulp, `${method}: ${error}`);
  close((await read("near")).casteljau, greatestError(), 1e-12);
  const far = await read("far");
  assert.ok(
    Object.values(far).every((error) => error > 2 ** -11 && error < 0.02),
    JSON.stringify(far),
  ); // 10 000 has 2⁻¹⁰ as its last place
  const high = await read("twentyfour");
  assert.ok(
    high.powers > 1000 * high.casteljau && high.horner > 1000 * high.casteljau && high.casteljau < 1e-5,
    JSON.stringify(high),
  );
  await figure.getByRole("checkbox", { name: "Basis matrix, Horner" }).uncheck();
  assert.equal(await figure.locator("path[data-method]").count(), 3);
});

test("four points in 24 orders are 12 curves", async (t) => {
  const page = await open(t);
  const figure = page.locator("fig-reorder");
  const shapes = await figure
    .locator(".thumb .curve")
    .evaluateAll((paths) => paths.map((path) => path.getAttribute("d")));
  assert.equal(new Set(shapes).size, 24);
  const read = (order) => figure.locator(".thumb", { has: page.getByRole("radio", { name: order }) });
  assert.equal(shapes.length, 24);
  await read("B D A C").locator("input").check();
  assert.match(await figure.locator(".facts").innerText(), /B D A C.*The reverse order is C A D B: the same curve/s);
  assert.equal(await figure.locator(".thumb[data-twin=true] .order").innerText(), "C A D B");
  const before = await read("A B C D").locator(".curve").getAttribute("d");
  await figure.locator(".handle input").first().focus();
  await page.keyboard.press("Shift+ArrowRight");
  const after = await read("A B C D").locator(".curve").getAttribute("d");
  const firstX = (d) => Number(d.match(/-?[\d.]+/)[0]);
  assert.equal(firstX(after) - firstX(before), 10);
});

test("the cubic in space: points, planes, orbit by keys and by hand", async (t) => {
  const page = await open(t);
  const figure = page.locator("fig-curve-3d");
  assert.equal(await figure.locator(".point").innerText(), "(3.375, 4.5, 6.25)"); // (P0 + 3 P1 + 3 P2 + P3) / 8
  await slide(page, "fig-curve-3d", "t", 1);
  assert.equal(await figure.locator(".point").innerText(), "(3, 4, 5)");
  const turn = async () => Number(await figure.getByRole("slider", { name: "Rotation" }).inputValue());
  const before = await turn();
  await figure.locator("svg").focus();
  await page.keyboard.press("ArrowRight");
  assert.equal(await turn(), before - 5);
  await dragBy(page, figure.locator("svg"), -60, 0);
  assert.equal(await turn(), before - 5 + 30);
  assert.match(
    await figure.locator(".facts").last().innerText(),
    /x from 0 to 4\.079, y from 2 to 5\.096, z from 3 to 6\.712/,
  );
});

test("bytes: those of the arrays that the package gives", async (t) => {
  const page = await open(t);
  const bytes = () =>
    page.locator("fig-bytes [data-bytes]").evaluateAll((texts) => texts.map((text) => Number(text.dataset.bytes)));
  // 32n² + 4n + 1 vertices of 12 bytes, and at n = 16 three 16-bit indices for each of 16,256 triangles
  const mesh = (32 * 256 + 4 * 16 + 1) * 12 + 16256 * 6;
  assert.deepEqual((await bytes()).slice(1), [mesh, mesh + (32 * 256 + 65) * 12]);
  await page.locator("fig-bytes").getByRole("radio", { name: "a curve" }).check();
  await slide(page, "fig-bytes", "Segments", 10);
  assert.deepEqual(await bytes(), [48, 132]);
});

test("quadratic and cubic follow one drag; no quadratic is an S", async (t) => {
  const page = await open(t);
  const figure = page.locator("fig-compare");
  assert.match(await figure.locator(".facts").first().innerText(), /Both are the same curve/);
  const at = (name) => figure.getByRole("slider", { name, exact: true }).inputValue().then(Number);
  const before = [await at("quadratic P1, x"), await at("cubic P1, x"), await at("cubic P2, x")];
  const handle = figure.locator(".handle").nth(1);
  await dragBy(page, handle, 40, 0);
  const after = [await at("quadratic P1, x"), await at("cubic P1, x"), await at("cubic P2, x")];
  const moved = after.map((value, k) => value - before[k]);
  assert.ok(
    moved[0] > 5 && Math.abs(moved[0] - moved[1]) < 1e-9 && Math.abs(moved[0] - moved[2]) < 1e-9,
    String(moved),
  );
  await figure.getByRole("button", { name: "Make the cubic equal" }).click();
  close(await at("cubic P1, x"), (await at("cubic P0, x")) / 3 + (2 * after[0]) / 3, 1e-9);
  await figure.getByRole("button", { name: "S-shape" }).click();
  assert.equal(await figure.locator(".turns").innerText(), "one");
  await figure.getByRole("checkbox").check();
  // For a cubic of third difference D the best quadratic with the same ends is off by |D| · max |t (1 − t) (1 − 2t)| / 2.
  const d = Math.hypot(90 - 3 * 56 + 3 * 44 - 10, 16 - 3 * 76 + 3 * 0 - 60);
  close(Number(await figure.locator(".error").getAttribute("data-error")), (d * Math.sqrt(3)) / 36, 1e-6);
});

/** One of the figures about velocity, lengths, distances, intersections, circles and faces. @param {string} name */
async function openFigure(t, name) {
  const page = await open(t);
  const figure = page.locator(name);
  await figure.scrollIntoViewIfNeeded();
  await figure.locator("svg").first().waitFor();
  return { page, figure, facts: () => figure.locator(".facts").first().innerText() };
}

/** The numbers in a text. @param {string} text @param {RegExp} pattern */
const numbers = (text, pattern) => (pattern.exec(text) ?? []).slice(1).map(Number);

test("the velocity at t = 0 is three legs long, and follows a drag", async (t) => {
  const { page, figure, facts } = await openFigure(t, "fig-velocity");
  const leg = () => figure.evaluate((/** @type {any} */ { points: [p, q] }) => [q[0] - p[0], p[1] - q[1]]);
  const shown = async () => numbers((await facts()).replaceAll("−", "-"), /\((-?[\d.]+), (-?[\d.]+)\)/);
  const expected = async () => (await leg()).map((x) => Math.round(30 * x) / 10);
  assert.deepEqual(await shown(), await expected());
  await dragBy(page, figure.locator(".handle").nth(1), 10, -30);
  assert.ok((await leg())[1] > 5);
  assert.deepEqual(await shown(), await expected());
  await figure.getByRole("checkbox").check();
  await figure.locator("circle.ghost").waitFor();
});

test("arc length: the part before t grows to the whole", async (t) => {
  const { figure, facts } = await openFigure(t, "fig-arc-length");
  const lengths = async () => numbers(await facts(), /Length ([\d.]+)\..*: ([\d.]+)\./s);
  const [whole, half] = await lengths();
  assert.ok(half < 0.4 * whole, `${half} of ${whole} at t = 0.5`);
  await figure.getByRole("slider", { name: "t", exact: true }).fill("1");
  assert.deepEqual(await lengths(), [whole, whole]);
});

test("nearest point: Q on the curve is at distance 0", async (t) => {
  const { figure, facts } = await openFigure(t, "fig-nearest");
  assert.match(await facts(), /distance [1-9]\d\.\d/);
  await figure.evaluate((/** @type {any} */ element) => {
    const { x, y } = element.curve.eval(0.25);
    element.q = [x, y];
  });
  assert.match(await facts(), /t = 0\.250, distance 0\.0/);
});

test("intersections: one at first, none when the curve is dragged away", async (t) => {
  const { page, figure, facts } = await openFigure(t, "fig-intersections");
  assert.match(await facts(), /^1 intersection, at/);
  const unit = (await boxOf(figure.locator("svg"))).height / 80;
  await dragBy(page, figure.locator(".handle").nth(4), 30 * unit, 15 * unit);
  assert.match(await facts(), /^0 intersections/);
});

test("a stroke takes its width, join and cap", async (t) => {
  const { figure } = await openFigure(t, "fig-stroke");
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
  const { figure, facts } = await openFigure(t, "fig-circle");
  await figure.getByRole("slider", { name: "h" }).fill("0.5523");
  assert.match(await facts(), /0\.027\d % of the radius/);
  await figure.getByRole("radio", { name: "8" }).check();
  assert.match(await facts(), /0\.000\d %/);
});

test("faces: the one under the pointer is named; click and keys select; operations", async (t) => {
  const { page, figure, facts } = await openFigure(t, "fig-faces");
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
  const { figure } = await openFigure(t, "fig-lengths");
  const read = async () => numbers(await figure.locator(".facts").innerText(), /D1 − D2 = ([\d.]+)\..*: ([\d.]+)\./s);
  const press = () => figure.getByRole("button", { name: "Halve" }).click();
  await press();
  const [difference, distance] = await read();
  await press();
  const [smaller, nearer] = await read();
  assert.ok(difference / smaller > 5 && difference / smaller < 11, `${difference} to ${smaller}`);
  assert.ok(distance / nearer > 3 && distance / nearer < 5.5, `${distance} to ${nearer}`);
});

test("an attribute with nonsense counts as the default", async (t) => {
  const page = await open(t);
  const text = await page.evaluate(async () => {
    const figure = document.querySelector("fig-pyramid");
    for (const [name, value] of [
      ["degree", "77"],
      ["degree", "x"],
      ["t", "NaN"],
      ["t", ""],
    ])
      figure.setAttribute(name, value);
    await figure.updateComplete;
    return `${figure.degree} ${figure.t}`;
  });
  assert.equal(text, "3 0.5");
});

test("printed, the figures keep their pictures and leave the sliders out", async (t) => {
  const page = await open(t);
  await page.emulateMedia({ media: "print" });
  assert.equal(await page.locator("fig-pyramid .controls").isVisible(), false);
  assert.equal(await page.locator("fig-pyramid svg").isVisible(), true);
});
