// The small figures of the chapters: each is drawn, follows an input and says what it must; what only a figure computes is right.
import assert from "node:assert/strict";
import { test } from "node:test";
import { boxOf, openPage } from "./browser.js";
import { loadFigures } from "./chapter-page.js";
import { dragBy } from "./gestures.js";

/** The page with all figures, once for all tests: each has a figure of its own. Messages of the console are errors. */
async function open(t) {
  const page = await openPage(t, "/figures/", {
    viewport: { width: 1000, height: 900 },
    reducedMotion: "reduce",
    keep: true,
  });
  await loadFigures(page);
  await page.locator("fig-bytes svg rect").first().waitFor();
  return page;
}

/** @typedef {import("playwright-core").Locator} Locator */
/** Sets a slider as a person does it with the keyboard's help: value and event. */
const slide = (name, value) => (/** @type {Locator} */ figure) =>
  figure.getByRole("slider", { name, exact: true }).fill(String(value));
const check = (name) => (/** @type {Locator} */ figure) => figure.getByRole("radio", { name }).check();
const press = (name) => (/** @type {Locator} */ figure) => figure.getByRole("button", { name }).click();
/** Drags a handle by parts of the height of the picture. */
const drag = (index, dx, dy) => async (/** @type {Locator} */ figure) => {
  const { height } = await boxOf(figure.locator("svg").first());
  await dragBy(figure.page(), figure.locator(".handle").nth(index), dx * height, dy * height);
};

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
  await slide("t", 0.3)(figure);
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
  const figure = (await open(t)).locator("fig-reorder");
  const curves = await figure
    .locator(".thumb .curve")
    .evaluateAll((paths) => paths.map((path) => path.getAttribute("d")));
  assert.deepEqual([curves.length, new Set(curves).size], [24, 24]);
  await figure
    .locator(".thumb", { has: figure.page().getByRole("radio", { name: "B D A C" }) })
    .locator("input")
    .check();
  assert.match(await figure.locator(".facts").innerText(), /B D A C.*The reverse order is C A D B: the same curve/s);
  assert.equal(await figure.locator(".thumb[data-twin=true] .order").innerText(), "C A D B");
});

test("bytes: those of the arrays that the package gives", async (t) => {
  const figure = (await open(t)).locator("fig-bytes");
  const bytes = () =>
    figure.locator("[data-bytes]").evaluateAll((texts) => texts.map((text) => Number(text.dataset.bytes)));
  // 32n² + 4n + 1 vertices of 12 bytes, and at n = 16 three 16-bit indices for each of 16,256 triangles
  const mesh = (32 * 256 + 4 * 16 + 1) * 12 + 16256 * 6;
  assert.deepEqual((await bytes()).slice(1), [mesh, mesh + (32 * 256 + 65) * 12]);
  await check("a curve")(figure);
  await slide("Segments", 10)(figure);
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

test("faces: the one under the pointer is named; click and keys select; operations", async (t) => {
  const page = await open(t);
  const figure = page.locator("fig-faces");
  const facts = () => figure.locator(".facts").first().innerText();
  await figure.scrollIntoViewIfNeeded();
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

/**
 * For each figure: inputs, and what it says after them: where, and the text.
 *
 * @type {[string, ((figure: Locator) => Promise<unknown>)[], string, RegExp][]}
 */
const FIGURES = [
  ["fig-parabola", [slide("t", -1.2)], ".point", /^\(−1\.2, 1\.44\)$/],
  // P1 is where the tangents at a and b meet: ((a + b) / 2, a b).
  [
    "fig-parabola",
    [slide("from", -1), slide("to", 0.5)],
    ".control",
    /^\(−1, 1\), \(−0\.25, −0\.5\), \(0\.5, 0\.25\)$/,
  ],
  ["fig-pyramid", [check("5")], "[data-sum]", /\d/],
  ["fig-binomial", [check("6"), slide("t", 0.5)], ".facts", /\d/],
  ["fig-costs", [], "tr[data-way=written] td", /6−, 9\+, 22×/],
  ["fig-costs", [], "tr[data-way=casteljau] td", /6−, 18\+, 36×/],
  ["fig-rounding", [(figure) => figure.getByRole("combobox").selectOption("far")], "tr[data-method]", /\d/],
  ["fig-curve-3d", [], ".point", /^\(3\.375, 4\.5, 6\.25\)$/], // (P0 + 3 P1 + 3 P2 + P3) / 8
  ["fig-curve-3d", [slide("t", 1)], ".point", /^\(3, 4, 5\)$/],
  ["fig-velocity", [slide("t", 0)], ".facts", /^Velocity B′\(0\.00\) = \(51, 9\)/], // 3 (P1 − P0)
  ["fig-velocity", [drag(1, 0.05, -0.1)], ".facts", /\(−?[\d.]+, −?[\d.]+\)/],
  ["fig-arc-length", [slide("t", 1)], ".facts", /Length ([\d.]+)\..*: \1\./s],
  ["fig-nearest", [drag(4, 0.1, 0.1)], ".facts", /t = [01]\.\d+, distance \d/],
  ["fig-intersections", [], ".facts", /^1 intersection, at/],
  ["fig-intersections", [drag(4, 0.375, 0.1875)], ".facts", /^0 intersections/],
  ["fig-families", [check("B-spline")], ".facts", /^Up to \d.*, joints C2, does not cross itself\.$/],
  ["fig-families", [check("Centripetal")], ".facts", /^Through all points, joints G1, does not cross itself\.$/],
  ["fig-fit", [slide("Tolerance", -2)], ".facts", /^6\d cubics for 90 points\. The farthest point is 0\.2\d away\.$/],
  ["fig-fit", [slide("Noise", 0), slide("Tolerance", 1)], ".facts", /^\d cubics/],
  ["fig-simplify", [slide("Tolerance", 0)], ".facts", /^240 lines, [\d,]+ bytes of path data: now 1\d cubics/],
  ["fig-taper", [], ".facts", /centre line: 60\.0\. The radius changes by 0\.20 /],
  ["fig-taper", [slide("First radius", 0), slide("Last radius", 38)], ".facts", /changes by 0\.63 /],
  ["fig-circle", [slide("h", 0.5523)], ".facts", /0\.027\d % of the radius/],
  ["fig-circle", [check("8")], ".facts", /0\.000\d %/],
  ["fig-conic", [slide("w", 0.71)], ".facts", /^An arc of a circle\./],
  ["fig-conic", [slide("w", 3)], ".facts", /^An arc of a hyperbola\..*= 0\.750\.$/],
  ["fig-octant", [slide("w", 0.71)], ".error", /^0\.0011$/],
  ["fig-projection", [slide("t", 0.5)], ".point", /^\(0\.6, 0\.8\)$/],
  ["fig-nurbs", [slide("first knot", 0.8)], ".knots", /^0, 0, 0, 0\.8, 0\.8, 1, 1, 1$/],
  ["fig-lengths", [press("Halve")], ".facts", /D1 − D2 = [\d.]+\./],
  ["fig-stroke", [check("bevel"), check("square")], ".facts, .controls", /./],
  ["fig-bspline-joint", [], ".facts, .controls", /./],
];

for (const [name, inputs, where, text] of FIGURES)
  test(`${name} says ${text.source}`, async (t) => {
    const figure = (await open(t)).locator(name);
    await figure.scrollIntoViewIfNeeded();
    for (const input of inputs) await input(figure);
    assert.match(await figure.locator(where).first().innerText(), text);
  });

test("each figure is drawn, and its picture or its numbers follow the first input", async (t) => {
  const page = await open(t);
  const tags = await page
    .locator("main")
    .evaluate((main) =>
      [...main.querySelectorAll("*")].map((each) => each.localName).filter((name) => name.startsWith("fig-")),
    );
  assert.ok(tags.length >= 18, `${tags}`);
  for (const tag of tags) {
    const figure = page.locator(tag);
    await figure.scrollIntoViewIfNeeded();
    const look = () =>
      figure.evaluate((/** @type {any} */ { shadowRoot }) =>
        [...shadowRoot.querySelectorAll("svg, table, .facts, [data-value]")].map((each) => each.outerHTML).join(),
      );
    const before = await look();
    assert.ok(before.length > 200, `${tag} is drawn`);
    const inputs = figure.locator(
      "input[type=range], input[type=radio]:not(:checked), select, button, input[type=checkbox]",
    );
    const input = inputs.first();
    const type = await input.evaluate((/** @type {any} */ each) => each.type);
    if (type === "range")
      await input.press((await input.inputValue()) === (await input.getAttribute("max")) ? "ArrowLeft" : "ArrowRight");
    else if (type === "select-one")
      await input.selectOption({
        index: await input.evaluate((/** @type {any} */ each) => (each.selectedIndex + 1) % each.length),
      });
    else await input.click();
    for (let k = 0; k < 60 && (await look()) === before; k++)
      await page.evaluate(() => new Promise(requestAnimationFrame));
    assert.notEqual(await look(), before, `${tag} follows`);
  }
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
