// The recipes: each draws its picture, follows its reader, and shows the code that runs. A message in the console fails.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { test } from "node:test";
import { boxOf, openPage, root } from "./browser.js";
import { centreOf, downloadBy, dragBy, dragFrom } from "./gestures.js";
import { inkedAfterInput, numbersIn, openRecipe, pictureOf } from "./recipes-page.js";

const folder = `${root}www/recipes/code/`;
const NAMES = readdirSync(folder)
  .filter((name) => name.endsWith(".html"))
  .map((name) => name.replace(".html", ""));
const source = (file) => readFileSync(folder + file, "utf8").trim();

test("the page shows the scripts, markup and styles that it uses", async (t) => {
  const page = await openPage(t, "/recipes/", { javaScriptEnabled: false });
  const shown = await page.locator("pre").evaluateAll((all) => all.map(({ textContent }) => textContent.trim()));
  for (const name of [...NAMES.flatMap((name) => [`${name}.js`, `${name}.html`]), "draggable.js", "style.css"])
    assert.ok(shown.includes(source(name)), name);
  assert.equal(await page.locator("figure[data-recipe]").count(), NAMES.length);
  assert.ok(NAMES.length >= 11);
});

test("text along a path: the letters are on the curve, and follow a point", async (t) => {
  const { page, figure } = await openRecipe(t, "text-along-path");
  const distances = () =>
    figure.locator("svg").evaluate((svg) => {
      const path = svg.querySelector("path");
      const points = Array.from({ length: 2001 }, (_, i) => path.getPointAtLength((path.getTotalLength() * i) / 2000));
      const visible = [...svg.querySelectorAll("text")].filter((text) => text.style.visibility !== "hidden");
      return visible.map((text) => {
        const [x, y] = text
          .getAttribute("transform")
          .match(/-?\d[\d.e-]*/g)
          .map(Number);
        return Math.min(...points.map((p) => Math.hypot(p.x - x, p.y - y)));
      });
    });
  const before = await pictureOf(figure);
  for (let round = 0; round < 2; round++) {
    const all = await distances();
    assert.ok(all.length > 20 && Math.max(...all) < 0.5, `${all}`);
    await dragBy(page, figure.locator(".handle").nth(1), 60, 90);
  }
  assert.notEqual(await pictureOf(figure), before);
});

test("hit testing: inside, on the curve, on neither", async (t) => {
  const { page, figure, output } = await openRecipe(t, "hit-testing");
  assert.match(await output.innerText(), /on neither; the curve is [\d.]+ units away/);
  const moveTo = async (x, y) => {
    const box = await boxOf(figure.locator("svg"));
    await page.mouse.move(box.x + (x / 400) * box.width, box.y + (y / 200) * box.height);
  };
  await moveTo(100, 120);
  assert.match(await output.innerText(), /inside of the heart/);
  assert.equal(await figure.locator(".area.hit").count(), 1);
  await moveTo(220, 156);
  assert.match(await output.innerText(), /on the curve/);
  assert.equal(await figure.locator(".area.hit").count(), 0);
});

test("a pen stroke: fewer segments with a larger tolerance; one segment for a straight stroke", async (t) => {
  const { page, figure, output } = await openRecipe(t, "simplify-stroke");
  const segments = async () => numbersIn(await output.innerText())[1];
  const first = await segments();
  await figure.getByRole("slider").fill("0.5");
  assert.ok((await segments()) > first, `${await segments()} and ${first}`);
  const { x, y } = await boxOf(figure.locator("svg"));
  await dragFrom(page, [x + 60, y + 60], 400, 100, 20);
  assert.equal(await segments(), 1);
});

test("a brush stroke follows the pointer; a click makes a dot; the download is the outline", async (t) => {
  const { page, figure, output } = await openRecipe(t, "brush-stroke");
  const before = await pictureOf(figure);
  const [points, segments] = numbersIn(await output.innerText());
  assert.equal(points, 61);
  assert.ok(segments > 6 && segments < 200, `${segments}`);
  const pad = figure.locator("svg");
  await dragBy(page, pad, 90, 40);
  assert.notEqual(await pictureOf(figure), before);
  const box = await boxOf(pad);
  await page.mouse.click(box.x + 0.8 * box.width, box.y + 0.3 * box.height);
  assert.equal(numbersIn(await output.innerText())[0], 1);
  const [left, width] = await figure.locator("path.area").evaluate((path) => {
    const { x, width } = /** @type {SVGPathElement} */ (path).getBBox();
    return [x, width];
  });
  assert.ok(Math.abs(width - 14) < 0.5 && Math.abs(left + width / 2 - 320) < 1, `${width} at ${left}`);
  const { name, bytes } = await downloadBy(figure.getByRole("button"));
  assert.equal(name, "stroke.svg");
  assert.match(bytes.toString(), /<path d="M/);
});

test("ink: the canvas keeps what was drawn, and the preview is empty afterwards", async (t) => {
  const { page, figure, output } = await openRecipe(t, "ink");
  const layers = await figure.locator("canvas").all();
  const inked = () => Promise.all(layers.map((layer) => layer.evaluate(inkedAfterInput)));
  assert.deepEqual(await inked(), [0, 0]);
  await dragBy(page, figure.locator("canvas").first(), 120, 60);
  const [drawing, preview] = await inked();
  assert.ok(drawing > 500 && preview === 0, `${drawing} ${preview}`);
  assert.match(await output.innerText(), /^A stroke of \d+ curves$/);
});

test("two icons: as many marks as intersections, none where they are apart", async (t) => {
  const { page, figure, output } = await openRecipe(t, "icon-intersections");
  const count = async () => numbersIn(await output.innerText())[0];
  assert.ok((await count()) >= 2 && (await count()) % 2 === 0);
  assert.equal(await figure.locator("g circle").count(), await count());
  await dragBy(page, figure.locator(".handle"), 200, 0);
  assert.equal(await count(), 0);
});

test("Boolean operations: the areas add up", async (t) => {
  const { figure, output } = await openRecipe(t, "boolean-operations");
  const area = async (operation) => {
    await figure.getByRole("combobox").selectOption(operation);
    return numbersIn(await output.innerText())[1];
  };
  const [union, intersect, exclude] = [await area("union"), await area("intersect"), await area("exclude")];
  assert.ok(intersect > 0 && Math.abs(union - intersect - exclude) <= 2, `${union} ${intersect} ${exclude}`);
  const [ringArea, difference] = [Math.PI * (85 * 85 - 50 * 62), await area("subtract")];
  assert.ok(Math.abs(difference + intersect - ringArea) < 5, `${difference} ${intersect} ${ringArea}`);
});

test("shape builder: faces are chosen by pointer and keyboard", async (t) => {
  const { page, figure, output } = await openRecipe(t, "shape-builder");
  const faces = figure.getByRole("checkbox");
  assert.equal(await faces.count(), 7);
  for (const face of await faces.all()) if ((await face.getAttribute("aria-checked")) === "true") await face.press(" ");
  assert.match(await output.innerText(), /^0 of 7 faces, area 0$/);
  assert.equal(await figure.locator("path.result").getAttribute("d"), "");
  const [x, y] = await centreOf(figure.getByRole("checkbox", { name: "Face in circle 1 and circle 2 and circle 3" }));
  await page.mouse.move(x, y);
  assert.equal(await figure.locator("path:hover").count(), 1);
  await page.mouse.click(x, y);
  assert.match(await output.innerText(), /^1 of 7 faces, area [1-9]/);
});

test("an exact circle: arcs in SVG, cubics on the canvas; the radius follows its handle", async (t) => {
  const { page, figure, output } = await openRecipe(t, "exact-circle");
  const path = figure.locator("svg path");
  assert.equal((await path.getAttribute("d"))?.match(/60 60 0 0 1/g)?.length, 4);
  const inked = () => figure.locator("canvas").evaluate(inkedAfterInput);
  const before = await inked();
  const circumference = 2 * Math.PI * 60 * 3; // pixels of the canvas
  assert.ok(Math.abs(before / (6 * circumference) - 1) < 0.1, `${before} pixels of a line that is 6 wide`);
  await figure.locator(".handle").last().press("ArrowLeft");
  assert.match(await output.innerText(), /Length: 345\.575192, 2πr: 345\.575192$/);
  await dragBy(page, figure.locator(".handle").last(), -40, 0);
  assert.ok((await inked()) < 0.9 * before, `${await inked()} and ${before}`);
});

test("the outline of a stroke: wider is larger, dashes are contours", async (t) => {
  const { page, figure, output } = await openRecipe(t, "stroke-outline");
  const [, area] = numbersIn(await output.innerText());
  await figure.getByRole("slider", { name: "Width" }).fill("14");
  const [, half] = numbersIn(await output.innerText());
  assert.ok(half > 0.4 * area && half < 0.6 * area, `${half} of ${area}`);
  await figure.getByRole("checkbox", { name: "Dashes" }).check();
  assert.ok(numbersIn(await output.innerText())[0] >= 4);
  const before = await pictureOf(figure);
  await dragBy(page, figure.locator(".handle").last(), -80, 60);
  assert.notEqual(await pictureOf(figure), before);
});

test("camera flight: the view changes with the position", async (t) => {
  const { figure, output } = await openRecipe(t, "camera-flight");
  const before = await pictureOf(figure);
  assert.ok((before.match(/Z/g) ?? []).length >= 20, "rings");
  await figure.getByRole("slider").fill("200");
  assert.notEqual(await pictureOf(figure), before);
  const [at, total] = numbersIn(await output.innerText());
  assert.ok(Math.abs(at - total / 2) < 0.1);
  await figure.getByRole("button", { name: "Play" }).click();
  await figure
    .page()
    .waitForFunction(
      () => !document.querySelector('[data-recipe="camera-flight"] output').textContent.startsWith("23."),
    );
  await figure.getByRole("button", { name: "Pause" }).click();
});

test("teapot in three.js: drawn, with fewer triangles from far away", async (t) => {
  const { figure, output } = await openRecipe(t, "teapot-three");
  const triangles = async () => numbersIn(await output.innerText())[0];
  const near = await triangles();
  const inked = await figure.locator("canvas").evaluate(inkedAfterInput);
  assert.ok(inked > 5000, `${inked} pixels`);
  await figure.getByRole("slider", { name: "Distance" }).fill("80");
  assert.ok((await triangles()) < near / 4, `${await triangles()} and ${near}`);
});

test("an STL file: as many triangles as its header says", async (t) => {
  const { figure, output } = await openRecipe(t, "stl-for-printing");
  const before = await pictureOf(figure);
  const [volume] = numbersIn(await output.innerText());
  await figure.getByRole("slider", { name: "Belly" }).fill("70");
  assert.notEqual(await pictureOf(figure), before);
  assert.ok(numbersIn(await output.innerText())[0] > volume);
  const { name, bytes } = await downloadBy(figure.getByRole("button"));
  assert.equal(name, "vase.stl");
  const triangles = bytes.readUInt32LE(80);
  assert.ok(triangles > 1000);
  assert.equal(bytes.length, 84 + 50 * triangles);
});

test("a vase: a closed mesh of the volume that is shown; it follows the points, the weight and arrow keys", async (t) => {
  const { page, figure, output } = await openRecipe(t, "vase");
  const [patches, volume] = numbersIn(await output.innerText());
  assert.equal(patches, 4 * 9, "a quarter turn for each span of the profile");
  await page.waitForFunction(() => document.querySelector("#vase-surface").surface.patchCount === 36);
  await page.waitForFunction(() => document.querySelector("#vase-surface").figure.mesh.triangles > 1000);
  const { name, bytes } = await downloadBy(figure.getByRole("button", { name: "OBJ" }));
  assert.equal(name, "surface.obj");
  const { open, volume: ofMesh } = solidOf(String(bytes));
  assert.equal(open, 0, "sides of triangles without a neighbour");
  assert.ok(Math.abs(ofMesh / 1000 / volume - 1) < 0.02, `${ofMesh} mm³ and ${volume} cm³`);

  await figure.getByRole("button", { name: "Belly" }).press("ArrowRight");
  const wider = numbersIn(await output.innerText())[1];
  assert.ok(wider > volume, `${wider} and ${volume}`);
  await figure.getByRole("slider").fill("5");
  assert.ok(numbersIn(await output.innerText())[1] > wider);
  const before = await figure.locator("path.area").getAttribute("d");
  await dragBy(page, figure.getByRole("button", { name: "Neck" }), -200, 0);
  assert.notEqual(await figure.locator("path.area").getAttribute("d"), before);
  assert.ok(numbersIn(await output.innerText())[1] > 0, "the neck stays off the axis");
});

/** Sides of triangles that do not have one neighbour, and the volume, of a mesh in an OBJ file. @param {string} text */
function solidOf(text) {
  const rows = text.split("\n").map((row) => row.split(" "));
  const points = rows.filter(([word]) => word === "v").map(([, ...numbers]) => numbers.map(Number));
  const keys = points.map((point) => `${point}`);
  const sides = new Map();
  let volume = 0;
  for (const [word, ...corners] of rows) {
    if (word !== "f") continue;
    const indices = corners.map((corner) => Number(corner.split("/")[0]) - 1);
    const [a, b, c] = indices.map((k) => points[k]);
    volume +=
      a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
    for (let k = 0; k < 3; k++) {
      const ends = [keys[indices[k]], keys[indices[(k + 1) % 3]]];
      const forwards = ends.join(" ");
      const backwards = ends.reverse().join(" ");
      sides.set(forwards, (sides.get(forwards) ?? 0) + 1);
      sides.set(backwards, (sides.get(backwards) ?? 0) - 1);
    }
  }
  return { open: [...sides.values()].filter((count) => count !== 0).length, volume: volume / 6 };
}

test("easing as linear(): more stops for a smaller tolerance; a handle changes the function", async (t) => {
  const { page, figure, output } = await openRecipe(t, "easing-to-linear");
  const stops = async () => (await output.innerText()).split(",").length;
  assert.match(await output.innerText(), /^linear\(0, .*, 1\)$/);
  const few = await stops();
  await figure.getByRole("slider").fill("0.002");
  assert.ok((await stops()) > few);
  const before = await output.innerText();
  await figure.locator(".handle").first().press("ArrowDown");
  assert.notEqual(await output.innerText(), before);
  await dragBy(page, figure.locator(".handle").first(), 60, 120);
  await figure.getByRole("button", { name: "Play" }).click();
  const timing = await figure.locator(".mark").evaluate((ball) => ball.getAnimations()[0].effect?.getTiming());
  assert.match(String(timing?.easing), /^linear\(/);
});
