// The small figures of the chapters: their numbers are right, keys and pointers work, everyone can use them.
import assert from "node:assert/strict";
import { test } from "node:test";
import { boxOf, openPage } from "./browser.js";

/** The page with all figures; waits until the last is drawn. */
async function open(t, options = {}) {
  const page = await openPage(t, "/figures/", {
    viewport: { width: 1000, height: 900 },
    reducedMotion: "reduce",
    ...options,
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

test("the pyramid counts its paths, and their sum is the Bernstein polynomial", async (t) => {
  const page = await open(t);
  const figure = page.locator("fig-pyramid");
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

test("the pyramid is walked with arrow keys, with one stop for Tab", async (t) => {
  const page = await open(t);
  const figure = page.locator("fig-pyramid");
  assert.equal(await figure.locator(".node[tabindex='0']").count(), 1);
  await figure.locator(".node[tabindex='0']").focus();
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("ArrowRight");
  assert.match(
    await page.evaluate(() =>
      document.querySelector("fig-pyramid").shadowRoot.activeElement.getAttribute("aria-label"),
    ),
    /^level 2, coefficient 2/,
  );
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
  const numbers = (d) => d.match(/-?[\d.]+/g);
  const read = (order) => figure.locator(".thumb", { has: page.getByRole("radio", { name: order }) });
  assert.equal(shapes.length, 24);
  await read("B D A C").locator("input").check();
  assert.match(await figure.locator(".facts").innerText(), /B D A C.*The reverse order is C A D B: the same curve/s);
  assert.equal(await figure.locator(".thumb[data-twin=true] .order").innerText(), "C A D B");
  const before = await read("A B C D").locator(".curve").getAttribute("d");
  await figure.locator(".handle input").first().focus();
  await page.keyboard.press("Shift+ArrowRight");
  const after = await read("A B C D").locator(".curve").getAttribute("d");
  assert.equal(Number(numbers(after)[0]) - Number(numbers(before)[0]), 10);
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
  const { x, y } = await boxOf(figure.locator("svg"));
  await page.mouse.move(x + 300, y + 200);
  await page.mouse.down();
  await page.mouse.move(x + 240, y + 200, { steps: 3 });
  await page.mouse.up();
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
  await handle.scrollIntoViewIfNeeded();
  const box = await boxOf(handle);
  await page.mouse.move(box.x + 14, box.y + 12);
  await page.mouse.down();
  await page.mouse.move(box.x + 54, box.y + 12, { steps: 4 });
  await page.mouse.up();
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
