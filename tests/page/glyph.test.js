// The editor of letters: ink and holes, joints, points, path data in and out, quadratics, closeness.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Path } from "casteljau";
import { close, open, PHONE, slide, state } from "./application-page.js";
import { boxOf } from "./browser.js";
import { dragBy, fingersOn } from "./gestures.js";

/** The outline of the page as a Path of ours. */
const outline = async (page) =>
  Path.fromJSON(await page.evaluate(() => document.querySelector("glyph-editor").path.toJSON()));
const data = (page) => page.getByLabel("SVG path data");

test("glyph: letters are inked where their contours wind, holes are holes", async (t) => {
  const page = await open(t, "/glyph/");
  for (const [name, inside, hole] of /** @type {[string, number[], number[]][]} */ ([
    ["a", [570, 600], [400, 650]],
    ["R", [200, 400], [400, 300]],
    ["&", [470, 560], [380, 250]],
  ])) {
    await page.getByRole("button", { name, exact: true }).click();
    const path = await outline(page);
    assert.ok(path.windingNumber(inside) > 0, `${name} has ink`);
    assert.equal(path.windingNumber(hole), 0, `${name} has a hole`);
  }
  await page.getByRole("button", { name: "a", exact: true }).click();
  await page.getByRole("slider", { name: /^Contour 2, point 0, x/ }).focus();
  assert.match(await page.locator(".direction").innerText(), /^counter-clockwise/);
  await page.getByRole("button", { name: "Reverse contour" }).click();
  assert.match(await page.locator(".direction").innerText(), /^clockwise/);
  assert.equal((await outline(page)).windingNumber([400, 650]), 2);
  await page.keyboard.press("Control+z");
  assert.equal((await outline(page)).windingNumber([400, 650]), 0);
});

test("glyph: a smooth joint stays smooth under the hand; freed, it breaks; undo and redo", async (t) => {
  const page = await open(t, "/glyph/");
  const g1 = async () => (await outline(page)).subpaths[0].continuity(3, 1e-6).g1;
  assert.equal(await g1(), true);
  const handle = page.getByRole("slider", { name: "Contour 1, handle 6, x" }).locator("..");
  const drag = () => dragBy(page, handle, -10, 30);
  const before = await data(page).inputValue();
  await drag();
  const after = await data(page).inputValue();
  assert.notEqual(after, before);
  assert.equal(await g1(), true);
  await page.getByRole("button", { name: "Undo" }).click();
  assert.equal(await data(page).inputValue(), before);
  await page.getByRole("button", { name: "Redo" }).click();
  assert.equal(await data(page).inputValue(), after);
  await page.getByRole("slider", { name: "Contour 1, point 5, x" }).focus();
  await page.getByRole("combobox", { name: "Joint" }).selectOption("free");
  await drag();
  assert.equal(await g1(), false);
  await page.getByRole("slider", { name: "Contour 1, point 5, x" }).focus();
  assert.match(await page.locator(".truth").innerText(), /corner of/);
  await page.getByRole("combobox", { name: "Joint" }).selectOption("c1");
  assert.match(await page.locator(".truth").innerText(), /G1, C1/);
});

test("glyph: points are added without changing the outline, and healed away again", async (t) => {
  const page = await open(t, "/glyph/");
  const before = await outline(page);
  await page.getByRole("slider", { name: "Contour 1, point 5, x" }).focus();
  await page.keyboard.press("i");
  const more = await outline(page);
  assert.equal(more.subpaths[0].segmentCount, before.subpaths[0].segmentCount + 1);
  close(more.area(), before.area(), 1e-6);
  await page.getByRole("slider", { name: "Contour 1, point 8, x" }).focus();
  await page.keyboard.press("Delete");
  const healed = await outline(page);
  assert.ok(healed.equals(before, 1e-6));
  const { x, y } = await page.evaluate(() => {
    const editor = document.querySelector("glyph-editor");
    const rect = editor.shadowRoot.querySelector(".outline-view").getBoundingClientRect();
    const [px, py] = editor.scales().place([620, 600]);
    return { x: rect.x + (px * rect.width) / editor.pictureWidth, y: rect.y + (py * rect.width) / editor.pictureWidth };
  });
  await page.mouse.dblclick(x, y);
  assert.equal((await outline(page)).subpaths[0].segmentCount, before.subpaths[0].segmentCount + 1);
  close((await outline(page)).area(), before.area(), 1e-6);
});

test("glyph: path data in; what is none is refused with its place, the last good outline kept", async (t) => {
  const page = await open(t, "/glyph/");
  const good = await data(page).inputValue();
  for (const [wrong, reason] of /** @type {[string, RegExp][]} */ ([
    ["M10 10 L", /character/],
    ["hello", /character 0/],
    ["", /at least one/],
    [`M0 0${"h1v1".repeat(3000)}`, /at most 2000/],
  ])) {
    await data(page).fill(wrong);
    await data(page).blur();
    await page.waitForFunction(
      (reason) => new RegExp(reason).test(document.querySelector("glyph-editor").fieldProblem),
      reason.source,
    );
    const message = page.locator(".in + .problem");
    assert.match(await message.innerText(), /^Not taken: .+The last good outline is kept\.$/s);
    assert.equal(await page.evaluate(() => document.querySelector("glyph-editor").path.toSVG({ precision: 2 })), good);
  }
  await data(page).fill("M0 0H40V40H0Z M10 10V30H30V10Z");
  await data(page).blur();
  await page.waitForFunction(() => document.querySelector("glyph-editor").outline.length === 2);
  assert.equal((await outline(page)).area(), 1200);
  assert.deepEqual(await page.locator(".problem").allInnerTexts(), ["", ""]);
  const kept = await state(page);
  await page.reload();
  await page.waitForFunction(
    (d) => document.querySelector("glyph-editor")?.path?.toSVG({ precision: 2 }) === d,
    kept.d,
  );
});

test("glyph: quadratics within the tolerance, measured", async (t) => {
  const page = await open(t, "/glyph/");
  const before = await outline(page);
  for (const power of [0.5, -1]) {
    await slide(page, "Tolerance", power);
    const error = Number(await page.locator("td.error").getAttribute("data-error"));
    assert.ok(error > 0 && error <= 10 ** power * 1.01, `${error}`);
    await page.getByRole("button", { name: "Convert to quadratic" }).click();
    const quadratic = await outline(page);
    assert.ok(quadratic.subpaths.every((spline) => spline.degrees.every((degree) => degree <= 2)));
    assert.equal(
      Number(await page.locator("td.theirs").innerText()),
      quadratic.subpaths.reduce((sum, spline) => sum + spline.controlPoints().length / 2, 0),
    );
    const far = before
      .equidistantTimes(900)
      .map(({ subpath, t }) => /** @type {any} */ (quadratic.nearest(before.subpaths[subpath].eval(t))).distance);
    close(Math.max(...far), error, 0.05 * error);
    await page.getByRole("button", { name: "Undo" }).click();
  }
});

test("glyph: any closeness, by buttons and keys, and back", async (t) => {
  const page = await open(t, "/glyph/");
  await page.getByRole("slider", { name: "Contour 1, point 5, x" }).focus();
  for (let i = 0; i < 4; i++) await page.getByRole("button", { name: "Close-up" }).click();
  await page.locator(".outline-view").focus();
  await page.keyboard.press("+");
  const units = () => page.evaluate(() => document.querySelector("glyph-editor").seen.units);
  assert.ok((await units()) < 1, String(await units()));
  assert.equal(await page.locator(".handle").count(), 1, "only what is in the picture has a handle");
  await page.keyboard.press("0");
  assert.ok((await units()) > 400);
});

test("glyph: where boxes for fingers overlap, the nearest handle is taken", async (t) => {
  const page = await open(t, "/glyph/", PHONE);
  const first = page.locator(".handle").first();
  await first.scrollIntoViewIfNeeded();
  const centres = await page.locator(".handle").evaluateAll((handles) =>
    handles.map((handle) => {
      const { x, y, width, height } = handle.getBoundingClientRect();
      return { x: x + width / 2, y: y + height / 2, width, name: handle.querySelector("input").ariaLabel };
    }),
  );
  assert.ok(centres.length > 30 && centres[0].width >= 44, "boxes for fingers");
  const seen = centres.filter(({ y }) => y > 0 && y < 740).slice(0, 16);
  for (const { x, y, name } of seen) {
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.up();
    assert.equal(
      await page.evaluate(() => document.querySelector("glyph-editor").shadowRoot.activeElement.ariaLabel),
      name,
    );
  }
});

test("glyph: two fingers zoom", async (t) => {
  const page = await open(t, "/glyph/", PHONE);
  const picture = page.locator(".outline-view");
  for (let i = 0; i < 2; i++) await page.getByRole("button", { name: "Zoom out" }).click(); // room beside the handles
  await picture.scrollIntoViewIfNeeded();
  const units = () => page.evaluate(() => document.querySelector("glyph-editor").seen.units);
  const before = await units();
  const { x, y, width } = await boxOf(picture);
  const touch = await fingersOn(page);
  for (const [k, part] of [0.25, 0.3, 0.35, 0.4, 0.45, 0.5].entries())
    await touch(k ? "touchMove" : "touchStart", [x + 6, y + 20], [x + 6 + part * width, y + 20]);
  await touch("touchEnd");
  const after = await units();
  assert.ok(after < 0.6 * before && after > 0.4 * before, `${before} → ${after}`);
});

test("glyph: Enter goes through the kinds of joint", async (t) => {
  const page = await open(t, "/glyph/");
  await page.getByRole("slider", { name: "Contour 1, point 5, x" }).focus();
  const modes = [];
  for (let i = 0; i < 6; i++) {
    await page.keyboard.press("Enter");
    modes.push(await page.getByRole("combobox", { name: "Joint" }).inputValue());
  }
  assert.deepEqual(modes, ["c1", "g2", "c2", "auto", "free", "g1"]);
});

test("glyph: union, overlaps, stroke and offset of the filled region, each undone in one step", async (t) => {
  const page = await open(t, "/glyph/");
  await data(page).fill("M0 0H400V400H0Z M200 200H600V600H200Z M100 100V150H150V100Z");
  await data(page).blur();
  await page.waitForFunction(() => document.querySelector("glyph-editor").outline.length === 3);
  const given = await data(page).inputValue();
  await slide(page, "Stroke width", 20);
  await slide(page, "Offset distance", -10);
  const squares = 2 * 400 ** 2 - 200 ** 2;
  for (const [name, contours, area] of /** @type {[string, number, number][]} */ ([
    ["Union of contours", 1, squares],
    ["Remove overlaps", 2, squares - 50 ** 2],
    ["Offset", 2, 2 * 380 ** 2 - 180 ** 2 - 70 ** 2],
  ])) {
    await page.getByRole("button", { name, exact: true }).click();
    const path = await outline(page);
    assert.equal(path.subpaths.length, contours, name);
    close(path.area(), area, 1e-6 * squares);
    await page.getByRole("button", { name: "Undo" }).click();
    assert.equal(await data(page).inputValue(), given);
  }
  await page.getByRole("button", { name: "Outline stroke" }).click();
  const stroke = await outline(page);
  for (const [point, winding] of /** @type {[number[], number][]} */ ([
    [[300, 409], 1],
    [[300, 389], 0],
    [[-9, -9], 1],
    [[-11, -11], 0],
    [[125, 125], 0],
    [[125, 141], 1],
  ]))
    assert.equal(stroke.windingNumber(point), winding, `${point}`);
  await page.getByRole("button", { name: "Undo" }).click();
  assert.equal(await data(page).inputValue(), given);
  await slide(page, "Offset distance", -60);
  for (let i = 0; i < 4; i++) await page.getByRole("button", { name: "Offset", exact: true }).click();
  assert.match(await page.locator(".group .problem").innerText(), /^Nothing would be left/);
});

test("glyph: what would change nothing is disabled", async (t) => {
  const page = await open(t, "/glyph/");
  const disabled = () => page.locator("glyph-editor button:disabled").allInnerTexts();
  const set = async (d, contours) => {
    await data(page).fill(d);
    await data(page).blur();
    await page.waitForFunction((n) => document.querySelector("glyph-editor").outline.length === n, contours);
  };
  assert.deepEqual(await disabled(), ["Undo", "Redo", "All", "Remove overlaps", "Convert to cubic"]);
  await set("M0 0H400V400H0Z M200 200H600V600H200Z", 2);
  assert.deepEqual(await disabled(), ["Redo", "All", "Convert to quadratic", "Convert to cubic"]);
  await page.getByRole("button", { name: "Remove overlaps" }).click();
  assert.deepEqual(await disabled(), [
    ...["Redo", "All", "Delete contour", "Union of contours", "Remove overlaps"],
    ...["Convert to quadratic", "Convert to cubic"],
  ]);
  await page.keyboard.press("Control+z"); // the keys work although the button is disabled
  assert.equal((await outline(page)).subpaths.length, 2);
  await set("M0 0L400 0Q200 400 0 0Z", 1);
  assert.ok((await disabled()).includes("Delete point"));
  assert.ok(!(await disabled()).includes("Convert to cubic"));
});
