// The plot of the weights, the equation and the coordinate table: alone, and linked to an applet.
// tests/js/companions.test.js has weights, numbers, points and the plot without a page.
import assert from "node:assert/strict";
import { test } from "node:test";
import { assertAccessibleInBothThemes, boxOf } from "./browser.js";
import { heard, on, openCompanions, paste, settled, shown, text } from "./companions-page.js";
import { assertNear, dragFrom } from "./gestures.js";

const ALL = `<bezier-applet id="figure" t="0.25" show="polygon construction"></bezier-applet>
<bezier-bernstein for="figure"></bezier-bernstein><bezier-equation for="figure"></bezier-equation>
<bezier-equation form="matrix" editable for="figure"></bezier-equation><bezier-equation form="casteljau" for="figure"></bezier-equation>
<bezier-coordinates for="figure"></bezier-coordinates>`;

const field = (page, name) => page.getByRole("spinbutton", { name });
/** The values of the plot's list, by name. */
const weights = (page) =>
  on(page, "bezier-bernstein", ({ shadowRoot }) =>
    Object.fromEntries(
      [...shadowRoot.querySelectorAll("li button")].map((button) => [
        button.innerText.trim().split(/\s+/)[0],
        Number(button.querySelector(".value").innerText.replace("−", "-")),
      ]),
    ),
  );
const figure = (page) =>
  on(page, "bezier-applet", ({ points, figure }) => ({
    t: figure.t,
    points,
    basis: figure.basis,
    matrix: figure.matrix,
  }));

test("they fit pages of 800 and 360 pixels, and are accessible, light and dark, with a message at a field", async (t) => {
  const page = await openCompanions(t, ALL);
  for (const width of [360, 800]) {
    await page.setViewportSize({ width, height: 2000 });
    await shown(page);
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)) <= 0, `${width}`);
  }
  await field(page, "P1 x").fill("");
  await page.keyboard.press("Tab");
  await page.locator("bezier-coordinates .error").waitFor();
  await assertAccessibleInBothThemes(page, settled);
});

test("the weights at t, linked: values, their sum, and the marker follow the applet", async (t) => {
  const page = await openCompanions(t, ALL);
  assert.deepEqual(await weights(page), { P0: 0.4219, P1: 0.4219, P2: 0.1406, P3: 0.0156 });
  assert.match(await text(page, "bezier-bernstein .sum"), /: 1$/);
  const marker = () =>
    on(page, "bezier-bernstein", ({ shadowRoot }) => Number(shadowRoot.querySelector(".marker").getAttribute("x1")));
  const before = await marker();
  await on(page, "bezier-applet", (applet) => (applet.t = 0.75));
  await settled(page);
  assert.deepEqual(await weights(page), { P0: 0.0156, P1: 0.1406, P2: 0.4219, P3: 0.4219 });
  assert.ok((await marker()) > before + 100);
  assert.deepEqual(await heard(page), [], "what the page writes is no event");
});

test("t is dragged in the plot and by the slider; the applet goes along", async (t) => {
  const page = await openCompanions(t, ALL);
  const { x, y, width, height } = await boxOf(page.locator("bezier-bernstein [part=plot]"));
  const at = async () => (await figure(page)).t;
  await dragFrom(page, [x + width / 2, y + height / 2], width * 0.4, 0);
  const dragged = await at();
  assertNear([dragged], [0.914], 0.02);
  const events = await heard(page);
  assert.ok(events.includes("input bezier-bernstein") && events.includes("change bezier-applet"), `${events}`);
  assert.equal(events.filter((event) => event === "change bezier-bernstein").length, 1);
  await page.mouse.move(x + width / 2, y + 5);
  await page.mouse.down();
  assertNear([await at()], [0.47], 0.02, "a press is enough");
  await on(page, "bezier-bernstein", ({ shadowRoot }) =>
    shadowRoot.querySelector("[part=plot]").dispatchEvent(new PointerEvent("pointercancel", { pointerId: 1 })),
  );
  assert.equal(await at(), dragged, "a drag that is broken off leaves nothing");
  await page.mouse.up();
  await page.locator('bezier-bernstein input[type="range"]').focus();
  for (const key of ["Home", "ArrowRight"]) await page.keyboard.press(key);
  assert.equal(await at(), 0.01);
});

test("the focused control point's polynomial stands out, and one that is chosen in the list", async (t) => {
  const page = await openCompanions(t, ALL);
  const chosen = () =>
    on(page, "bezier-bernstein", ({ shadowRoot }) =>
      [...shadowRoot.querySelectorAll("polyline")].findIndex((line) => line.classList.contains("selected")),
    );
  assert.equal(await chosen(), -1);
  await on(page, "bezier-applet", ({ shadowRoot }) =>
    shadowRoot.querySelector('.handle[data-index="2"] input').focus(),
  );
  await settled(page);
  assert.equal(await chosen(), 2);
  await page.getByRole("button", { name: "P1" }).click();
  assert.equal(await chosen(), 1);
  assert.equal(await page.getByRole("button", { name: "P1" }).getAttribute("aria-pressed"), "true");
});

test("degrees up to 64 are plotted alone; lines differ by more than colour; t and the basis are properties", async (t) => {
  const page = await openCompanions(t, '<bezier-bernstein degree="64" t="0.5"></bezier-bernstein>');
  const looks = await on(page, "bezier-bernstein", ({ shadowRoot }) =>
    [...shadowRoot.querySelectorAll("polyline")].map(
      (line) => `${line.classList[1]} ${line.getAttribute("stroke-dasharray")}`,
    ),
  );
  assert.deepEqual([looks.length, new Set(looks.slice(0, 20)).size], [65, 20]);
  await on(page, "bezier-bernstein", (element) => (element.basis = "hermite"));
  await settled(page);
  assert.deepEqual(Object.keys(await weights(page)), ["P0", "P3", "P1−P0", "P3−P2"]);
  await page.locator('bezier-bernstein input[type="range"]').fill("0.25");
  assert.equal(await on(page, "bezier-bernstein", (element) => element.getAttribute("t")), "0.25");
  assert.deepEqual(await heard(page), ["input bezier-bernstein", "change bezier-bernstein"]);
});

test("the equation: MathML with live numbers that add up, and a text for screen readers", async (t) => {
  const page = await openCompanions(t, ALL);
  const first = "bezier-equation >> nth=0";
  const sum = () =>
    on(page, first, ({ shadowRoot }) =>
      [...shadowRoot.querySelectorAll("mtr.total mn")].map((mn) => Number(mn.textContent.replace("−", "-"))),
    );
  for (const point of [
    [110, 90],
    [300, 20],
  ]) {
    await on(page, "bezier-applet", (applet, point) => applet.edit({ index: 1, point }, true), point);
    await settled(page);
    const place = await on(page, "bezier-applet", ({ figure }) => figure.pieces[figure.segment].curve.eval(figure.t));
    assertNear(await sum(), [place.x, place.y], 5.1e-4);
  }
  // Row by row: what is printed adds up to what is printed below, with negative weights too.
  await on(page, "bezier-applet", (applet) => applet.setAttribute("basis", "catmull-rom"));
  await settled(page);
  const { rows, totals } = await on(page, first, ({ shadowRoot }) => {
    const value = (mtd) =>
      [...mtd.querySelectorAll("mn")].map((mn) => Number(mn.textContent.replace("−", "-"))).reduce((a, b) => a * b);
    const all = [...shadowRoot.querySelectorAll("mtr")].slice(1).map(({ children }) => [...children]);
    const signed = (sign, mtd) => (sign.textContent.includes("−") ? -1 : 1) * value(mtd);
    const rows = all.slice(0, -1).map((cells) => [signed(cells[2], cells[3]), signed(cells[4], cells[5])]);
    const last = all[all.length - 1];
    return { rows, totals: [value(last[3]), value(last[5])] };
  });
  assert.equal(rows.length, 4);
  assert.ok(Math.min(...rows.flat()) < 0, "negative weights");
  for (const axis of [0, 1])
    assert.ok(Math.abs(rows.reduce((sum, row) => sum + row[axis], 0) - totals[axis]) < 0.8, `${rows} for ${totals}`);
  const { namespace, label } = await on(page, first, ({ shadowRoot }) => {
    const math = shadowRoot.querySelector("math");
    return { namespace: math.querySelector("mtable").namespaceURI, label: math.getAttribute("aria-label") };
  });
  assert.match(namespace, /MathML/);
  assert.match(label, /^B of 0\.25 is x [\d.]+, y [\d.]+, from −0\.07 P0 plus/);
  const region = page.locator("bezier-equation").first().getByRole("group", { name: "Equation" });
  assert.equal(await region.getAttribute("tabindex"), "0");
});

test("on a narrow phone the equation scrolls inside, by the keyboard too", async (t) => {
  const page = await openCompanions(t, '<bezier-equation form="casteljau"></bezier-equation>', {
    viewport: { width: 360, height: 700 },
  });
  const region = page.getByRole("group", { name: "Equation" });
  await region.focus();
  await page.keyboard.press("ArrowRight");
  await page.waitForFunction(
    () => document.querySelector("bezier-equation").shadowRoot.querySelector(".scroll").scrollLeft > 0,
  );
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 360);
});

test("the basis is switched and the matrix edited: the applet follows, one undo step each", async (t) => {
  const page = await openCompanions(t, ALL);
  const matrix = page.locator('bezier-equation[form="matrix"]');
  await matrix.getByLabel("Basis").selectOption("catmull-rom");
  assert.equal((await figure(page)).basis, "catmull-rom");
  await settled(page);
  const cell = matrix.getByLabel("Row 1, column 2");
  assert.equal(await cell.inputValue(), "1.5");
  await cell.fill("2.25");
  await page.keyboard.press("Enter");
  const edited = await figure(page);
  assert.deepEqual([edited.basis, edited.matrix[1], edited.matrix[0]], ["matrix", 2.25, -0.5]);
  await on(page, "bezier-applet", (applet) => applet.undo());
  assert.equal((await figure(page)).basis, "catmull-rom");
  await settled(page);
  assert.equal(await cell.inputValue(), "1.5");
  await matrix.getByLabel("Basis").selectOption("hermite");
  await settled(page);
  const at = () => on(page, "bezier-applet", ({ figure }) => figure.pieces[0].curve.eval(0.4));
  const before = await at();
  await matrix.getByLabel("Basis").selectOption("matrix");
  const after = await at();
  assert.ok(Math.hypot(before.x - after.x, before.y - after.y) < 1e-9, "own numbers begin with the same curve");
});

test("the matrix refuses what is no number, at the field", async (t) => {
  const page = await openCompanions(t, '<bezier-equation form="matrix" editable basis="b-spline"></bezier-equation>');
  const cell = page.getByLabel("Row 4, column 1");
  await cell.fill("");
  await page.keyboard.press("Tab");
  assert.match(await text(page, "bezier-equation .error"), /^Expected a number, got nothing; 0\.167 is kept\./);
  assert.equal(await cell.inputValue(), "0.1667");
  assert.equal(await cell.getAttribute("aria-invalid"), "true");
  await paste(cell, "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1");
  assert.deepEqual(await on(page, "bezier-equation", ({ basis, matrix }) => [basis, matrix]), [
    "matrix",
    "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1",
  ]);
});

/** What is linked to a conic section. */
const RATIONAL = `<bezier-applet id="figure" t="0.25" points="100,400 100,100 400,100" degree="2" weights="1 0.75 2"></bezier-applet>
<bezier-bernstein for="figure"></bezier-bernstein><bezier-equation for="figure"></bezier-equation>
<bezier-equation form="matrix" editable for="figure"></bezier-equation><bezier-equation form="casteljau" for="figure"></bezier-equation>
<bezier-coordinates for="figure"></bezier-coordinates>`;

/** Opens these and waits until the curve is there. */
async function openRational(t, options = {}) {
  const page = await openCompanions(t, RATIONAL, options);
  await page.locator("bezier-equation math").first().waitFor();
  return page;
}

/** The numbers of the elements that match, in an equation. */
const numbersIn = (page, form, selector) =>
  on(
    page,
    form === "sum" ? "bezier-equation:not([form])" : `bezier-equation[form="${form}"]`,
    ({ shadowRoot }, selector) =>
      [...shadowRoot.querySelectorAll(selector)].map((each) =>
        [...each.querySelectorAll("mn")].map((mn) => Number(mn.textContent.replace("−", "-"))),
      ),
    selector,
  );

test("equations of a rational curve: numerator, denominator and their quotient, in every form", async (t) => {
  const page = await openRational(t);
  const { x, y } = await on(page, "bezier-applet", ({ figure }) => figure.rational[0].curve.eval(0.25));
  // w(t) = 1·0.5625 + 0.75·0.375 + 2·0.0625
  const [w, ax, ay] = [0.96875, 0.96875 * x, 0.96875 * y];
  const [[sumW, sumX, sumY]] = await numbersIn(page, "sum", "mtr.total");
  assertNear([sumW, sumX, sumY], [w, ax, ay], 1e-4);
  const [quotient] = await numbersIn(page, "sum", "math:last-child");
  assertNear(quotient, [0.25, ax, ay, w, x, y], 1e-3);
  const [powers, product, last] = await numbersIn(page, "matrix", "math[display]");
  assertNear(powers.slice(-3), [0.5625, 0.375, 0.0625], 1e-3);
  assertNear(product.slice(-3), [ax, ay, w], 1e-3);
  assertNear(last, quotient, 1e-3);
  assert.equal(
    await page.locator("bezier-equation .cells").count(),
    0,
    "numbers of a matrix that has weights cannot be changed",
  );
  const [cells] = await numbersIn(page, "casteljau", "mtr:first-child mtd:last-child");
  assertNear(cells.slice(2), [x, y, 0, 2, w], 1e-3);
  assert.deepEqual(await weights(page), { P0: 0.5806, P1: 0.2903, P2: 0.129 });
  assert.match(await text(page, "bezier-bernstein .sum"), /^Sum of the functions: 1$/);
});

test("with weights, the table of coordinates has a column for them; one that is too small is refused", async (t) => {
  const page = await openRational(t);
  const weight = field(page, "P1 w");
  const own = () => on(page, "bezier-applet", ({ weights }) => weights);
  assert.equal(await weight.inputValue(), "0.75");
  await weight.fill("2.5");
  await page.keyboard.press("Enter");
  assert.deepEqual(await own(), [1, 2.5, 2]);
  assert.ok((await heard(page)).includes("change bezier-coordinates"));
  await on(page, "bezier-applet", (applet) => applet.undo());
  assert.deepEqual(await own(), [1, 0.75, 2]);
  await weight.fill("-1");
  await page.keyboard.press("Enter");
  assert.match(
    await text(page, "bezier-coordinates .error"),
    /^weights\[1\]: expected a number from 0\.001 to 1000, got -1/,
  );
  assert.deepEqual(await own(), [1, 0.75, 2]);
  await field(page, "P1 x").fill("150");
  await page.keyboard.press("Enter");
  assert.deepEqual(
    [await own(), (await figure(page)).points[1]],
    [
      [1, 0.75, 2],
      [150, 100],
    ],
  );
  await on(page, "bezier-applet", (applet) => applet.removeAttribute("weights"));
  await settled(page);
  assert.equal(await weight.count(), 0);
});

test("companions of a rational curve fit 360 pixels and are accessible, light and dark", async (t) => {
  const page = await openRational(t, { viewport: { width: 360, height: 2000 } });
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 360);
  await assertAccessibleInBothThemes(page, settled);
});

test("the product of the powers and the matrix is shown with all its decimals", async (t) => {
  const page = await openCompanions(t, '<bezier-equation form="matrix" t="0.5"></bezier-equation>');
  const [row] = await numbersIn(page, "matrix", "math[display]");
  assert.deepEqual(row, [0.125, 0.25, 0.5, 1, 0.125, 0.375, 0.375, 0.125]);
});

test("coordinates are typed: the applet moves with every digit, and Enter makes one undo step; Escape takes them back", async (t) => {
  const page = await openCompanions(t, ALL);
  const [input, other] = [field(page, "P1 x"), field(page, "P1 y")];
  const p1 = async () => (await figure(page)).points[1];
  await input.fill("");
  await input.pressSequentially("17.5");
  assert.deepEqual(await p1(), [17.5, 90]);
  await page.keyboard.press("Enter");
  assert.ok((await heard(page)).includes("change bezier-coordinates"));
  await on(page, "bezier-applet", (applet) => applet.undo());
  assert.deepEqual(await p1(), [110, 90]);
  await field(page, "P2 x").focus();
  await settled(page);
  assert.equal(await input.inputValue(), "110");
  await input.focus();
  await input.fill("400");
  await page.keyboard.press("Escape");
  assert.deepEqual([await p1(), await input.inputValue()], [[110, 90], "110"]);
  await input.fill("12");
  await on(page, "bezier-applet", (applet) => applet.edit({ index: 1, point: [44, 55] }, false));
  await settled(page);
  assert.deepEqual([await input.inputValue(), await other.inputValue()], ["12", "55"], "what is typed is not touched");
  await on(page, "bezier-applet", (applet) => Object.assign(applet, { readonly: true, t: 0.9 }));
  await settled(page);
  assert.ok(await input.isDisabled());
});

test("what is no number is refused with a message at the field, and the last good value stays", async (t) => {
  const page = await openCompanions(t, ALL);
  const input = field(page, "P1 x");
  const message = () => text(page, "bezier-coordinates .error");
  for (const [key, bad] of [
    ["Delete", ""],
    ["1", "e999"],
  ]) {
    await input.press("ControlOrMeta+a");
    await input.press(key);
    await input.pressSequentially(bad);
    await page.keyboard.press("Tab");
    await settled(page);
    assert.match(await message(), /^Expected a number, got (nothing|what is none); (1e\+)?\d+ is kept\.$/);
    assert.ok(Number.isFinite(Number(await input.inputValue())) && (await input.inputValue()) !== "");
    assert.equal(await input.getAttribute("aria-invalid"), "true");
  }
  const before = (await figure(page)).points;
  for (const bad of ["NaN", "<b>", "x".repeat(1e5)]) {
    await paste(input, bad);
    await settled(page);
    assert.match(await message(), /expected/i, bad);
    assert.ok((await message()).length < 160);
    assert.deepEqual((await figure(page)).points, before);
  }
  await input.fill("5");
  await settled(page);
  assert.equal(await page.locator("bezier-coordinates .error").count(), 0);
});

test("pasted lines fill the table, from where they are pasted; more of them make more points", async (t) => {
  const page = await openCompanions(t, ALL);
  const coordinates = async () => (await figure(page)).points.join(" ");
  const lines = (count) => Array.from({ length: count }, (_, k) => `${10 * k},${20 + k}`).join("\r\n");
  await paste(field(page, "P2 x"), lines(3));
  assert.equal(await coordinates(), "70,330 110,90 0,20 10,21 20,22 590,400 600,130");
  await on(page, "bezier-applet", (applet) => applet.undo());
  assert.match(await coordinates(), /^70,330 110,90 235,120 /, "one undo step");
  await paste(field(page, "P0 y"), lines(10));
  await page.waitForFunction(
    () => document.querySelector("bezier-coordinates").shadowRoot.querySelectorAll("tbody tr").length === 10,
  );
  const before = await coordinates();
  await paste(field(page, "P0 x"), "1,2\n3,x");
  assert.match(await text(page, "bezier-coordinates .error"), /line 2: expected a number, got “x”/);
  assert.equal(await coordinates(), before);
});

test("alone, the table holds points of its own", async (t) => {
  const page = await openCompanions(t, '<bezier-coordinates points="1,2 3,4"></bezier-coordinates>');
  await field(page, "P1 y").fill("40");
  await page.keyboard.press("Enter");
  assert.deepEqual(await heard(page), ["input bezier-coordinates", "change bezier-coordinates"]);
  assert.deepEqual(
    await on(page, "bezier-coordinates", (element) => [element.points.join(" "), element.getAttribute("points")]),
    ["1,2 3,40", "1,2 3,40"],
  );
  await on(page, "bezier-coordinates", (element) => (element.points = JSON.parse("[[5,6],[7,8],[9,10]]")));
  await settled(page);
  assert.equal(await field(page, "P2 y").inputValue(), "10");
});
