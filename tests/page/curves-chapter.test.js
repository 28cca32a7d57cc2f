// The chapter on curves in a real browser: every figure starts, tasks can be solved by pointer and keys.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { boxOf, openPage, root } from "./browser.js";
import { done, goTo, nearApplet as near, openCurves as open, sectionsOf, task } from "./chapter-page.js";

const PHONE = { viewport: { width: 360, height: 740 }, deviceScaleFactor: 2, hasTouch: true, isMobile: true };
const SECTIONS =
  "parameter quadratic de-casteljau bernstein splitting derivatives properties shapes joining higher-degrees splines fitting recursive-rendering arc-length bounding-boxes nearest-point intersections offsets varying-width circles rational-curves boolean-operations uses cost-and-numerical-stability".split(
    " ",
  );

/** Everything that draws. Those of the package draw on a canvas once they are near; the site's own draw an SVG. */
const FIGURES =
  "main :is(bezier-applet, bezier-bernstein, bezier-equation, bezier-easing, fig-affine, fig-arc-length, fig-binomial, fig-bspline-joint, fig-bytes, fig-circle, fig-compare, fig-conic, fig-costs, fig-curve-3d, fig-faces, fig-families, fig-fit, fig-intersections, fig-lengths, fig-nearest, fig-nurbs, fig-parabola, fig-projection, fig-pyramid, fig-reorder, fig-rounding, fig-simplify, fig-speed, fig-stroke, fig-taper, fig-velocity)";

test("on a narrow phone every figure draws when the reader comes near, nothing scrolls sideways, and the console stays clean", async (t) => {
  const page = await open(t, PHONE);
  let count = 0;
  for (const { path } of sectionsOf("curves")) {
    await page.goto(path);
    const handles = await page.locator(FIGURES).elementHandles();
    count += handles.length;
    for (const handle of handles) {
      await handle.scrollIntoViewIfNeeded();
      // Before the next one is brought near: a figure that is scrolled past does not start.
      await page.waitForFunction((/** @type {any} */ element) => {
        const root = element.shadowRoot;
        const canvas = root?.querySelector("canvas");
        if (element.localName === "bezier-applet") return canvas?.width > 1 && root.querySelector("[data-index]");
        return Boolean(root?.querySelector("svg, math, canvas, table"));
      }, handle);
    }
    const wide = await page.evaluate(() => [
      document.documentElement.scrollWidth,
      ...[...document.querySelectorAll("main *")]
        .filter((e) => e.getBoundingClientRect().right > 361 && !e.closest(".scroll, math, svg, pre, .matrix"))
        .map((e) => e.outerHTML.slice(0, 80)),
    ]);
    assert.deepEqual(wide, [360], path);
  }
  assert.ok(count > 60, `${count} figures`);
});

test("the sections, and every place that the list of the texts links to, are there", async () => {
  const sections = sectionsOf("curves");
  const names = sections.map(({ id }) => id);
  assert.deepEqual(
    SECTIONS.filter((id) => !names.includes(id)),
    [],
  );
  const bare = sections.filter(({ tasks, ids }) => tasks.length === 0 || !ids.some((id) => id.startsWith("sample-")));
  assert.deepEqual(
    bare.map(({ id }) => id),
    [],
    "each has a task and a sample",
  );
  // site-links.test.js follows these links.
  const texts = await readFile(`${root}site/texts/index.html`, "utf8");
  assert.doesNotMatch(texts, /"(\.\.\/)*(curves|surfaces)\/#/, "the build writes the section into each link");
  assert.ok((texts.match(/curves\/[\w-]+\/#figure-/g)?.length ?? 0) > 30);
});

test("arrow keys: P4 where equal velocities need it, with the distance shown meanwhile", async (t) => {
  const page = await open(t);
  const applet = await near(page, "durations");
  const found = await task(page, "time-ratio", 1);
  await applet.evaluate((/** @type {any} */ element) => (element.points = element.points.with(4, [492, 366])));
  await applet.locator("[data-index='4'] input").first().focus();
  await page.keyboard.press("ArrowDown");
  await found.getByText("P4 is 13 px from the exact place.").waitFor();
  await page.keyboard.press("Shift+ArrowDown");
  assert.match(await done(page, "time-ratio"), /^P4 is 3\.61 px from the exact place/);
  assert.deepEqual((await applet.evaluate((/** @type {any} */ element) => element.points))[4], [492, 377]);
  // At exactly twice the handle the plot, which counts two seconds for the second piece, has no jump; at equal handles it has.
  const lasting = page.locator('fig-speed[for="durations"]');
  await applet.evaluate((/** @type {any} */ element) => (element.points = element.points.with(4, [490, 380])));
  await lasting.getByText("No jump at the joint.").waitFor();
  await applet.evaluate((/** @type {any} */ element) => (element.points = element.points.with(4, [410, 290])));
  await lasting.getByText("It jumps from 361 to 181 at the joint.").waitFor();
  const joint = await near(page, "joint");
  const plot = page.locator('fig-speed[for="joint"]');
  await page.locator('lesson-task[name="aligned-only"]').getByRole("button", { name: "Reveal" }).click();
  await plot.getByText("It jumps from 361 to 181 at the joint.").waitFor();
  await joint.evaluate((/** @type {any} */ element) => (element.points = element.points.with(4, [410, 290])));
  await plot.getByText("No jump at the joint.").waitFor();
});

test("sliders of the page steer their figures: segments, tolerance, zoom, degree", async (t) => {
  const page = await open(t);
  await near(page, "polyline");
  await task(page, "half-pixel", 1);
  await page.getByRole("slider", { name: "Segments" }).first().fill("24");
  assert.match(await done(page, "half-pixel"), /24 segments: the error is 0\.47 px\. With one segment fewer/);

  await near(page, "recursion");
  assert.match(await page.locator("#tree").innerText(), /6 pieces, measured error 14\.5\d px/);
  await task(page, "enough-pieces", 2);
  await page.getByRole("slider", { name: "Tolerance, px" }).fill("-4");
  assert.match(await done(page, "enough-pieces"), /^32 pieces/);
  assert.equal(await page.locator("#recursion").getAttribute("tolerance"), "0.0625");

  const zoom = await near(page, "zoom");
  await page.getByRole("button", { name: "1,000 ×", exact: true }).click();
  const width = await zoom.evaluate((element) => Number(element.getAttribute("view")?.split(" ")[2]));
  assert.ok(Math.abs(width - 0.67) < 1e-9, String(width));

  const elevation = await near(page, "elevation");
  const middle = () =>
    elevation.evaluate((/** @type {any} */ element) => Object.values(element.figure.pieces[0].curve.eval(0.5)));
  const before = await middle();
  await page.getByRole("button", { name: "Raise the degree" }).click();
  assert.equal((await elevation.evaluate((/** @type {any} */ element) => element.points)).length, 4);
  assert.ok((await middle()).every((x, i) => Math.abs(x - before[i]) < 1e-9));
  assert.match(await page.locator("degree-buttons [role=status]").innerText(), /Degree 3/);
});

test("the matrix: a basis by its name, then numbers typed, NaN refused", async (t) => {
  const page = await open(t);
  const applet = await near(page, "basis");
  await page.locator("attribute-choice").getByRole("radio", { name: "Catmull–Rom" }).check();
  const fields = page.locator("#matrix input");
  await page.waitForFunction(() => document.querySelector("#matrix input").value === "−0.5");
  for (const [i, value] of [0, 0, 0, 0, 0, 0, 0, 0, "−1", 0, 0, 1, 1, 0, 0, 0].entries())
    await fields.nth(i).fill(String(value));
  await done(page, "straight-matrix");
  await fields.nth(0).fill("NaN");
  assert.match(await page.locator("#matrix .note").innerText(), /expected a number, got “NaN”/);
  const kept = await applet.evaluate((/** @type {any} */ element) => element.figure.pieces[0].curve.eval(0.5));
  assert.deepEqual(kept, { x: 335, y: 360 });
});

test("figures that share their points move together, and a dashed curve lies where it should", async (t) => {
  const page = await open(t);
  await goTo(page, "figure-bases");
  const four = page.locator("#figure-bases bezier-applet");
  await four.first().scrollIntoViewIfNeeded();
  await page.waitForFunction(() =>
    document.querySelector("#figure-bases bezier-applet").shadowRoot.querySelector("[data-index]"),
  );
  await four.first().locator("[data-index='1'] input").first().focus();
  await page.keyboard.press("Shift+ArrowUp");
  for (const points of await four.evaluateAll((all) => all.map((/** @type {any} */ { points }) => points[1])))
    assert.deepEqual(points, [190, 100]);

  const large = await near(page, "quadratic-steps");
  await large.getByRole("slider", { name: "t", exact: true }).fill("0.2");
  assert.deepEqual(
    await page.locator("#figure-steps bezier-applet").evaluateAll((all) => all.map((/** @type {any} */ { t }) => t)),
    [0.2, 0.2, 0.2],
  );

  const match = await near(page, "match");
  await task(page, "match-shape");
  await page.locator('lesson-task[name="match-shape"]').getByRole("button", { name: "Reveal" }).click();
  assert.match(
    await page.locator('lesson-task[name="match-shape"] .words').innerText(),
    /greatest distance is 0\.00 px/,
  );
  const [picture, dashed] = await Promise.all([
    boxOf(match.locator("canvas")),
    boxOf(page.locator("#figure-match curve-target > svg")),
  ]);
  for (const side of /** @type {const} */ (["x", "y", "width", "height"]))
    assert.ok(Math.abs(picture[side] - dashed[side]) < 2.5, `${side}: ${picture[side]} and ${dashed[side]}`);
});

test("what can be seen before the scripts: pictures of the applets, the text, the code", async (t) => {
  const page = await openPage(t, "/curves/parameter/", { javaScriptEnabled: false });
  let count = 0;
  for (const { path } of sectionsOf("curves")) {
    await page.goto(path);
    count += await page.locator("bezier-applet > svg path").count();
    assert.equal(await page.locator("bezier-applet:not(:has(> svg))").count(), 0);
    const samples = await page.locator("lesson-sample").count();
    assert.equal(await page.locator("lesson-sample pre:visible").count(), 2 * samples, "both languages");
    assert.ok((await page.locator("lesson-task").first().innerText()).length > 20);
    for (const picture of await page.locator("bezier-applet > svg:first-of-type").all()) {
      const { width, height } = await boxOf(picture);
      assert.ok(width > 200 && height > 140, `${path}: ${width} × ${height}`);
    }
  }
  assert.ok(count > 100, `${count} paths`);
});
