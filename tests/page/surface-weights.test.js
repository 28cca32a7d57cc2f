// <bezier-surface> with weights: the models sphere, torus, cylinder and cone, and surfaces of casteljau/nurbs. What is loaded for them
// and when.
import assert from "node:assert/strict";
import { test } from "node:test";
import { isRelease } from "./browser.js";
import { assertNear, downloadBy } from "./gestures.js";
import { facts, look, openSurface, set } from "./surface-page.js";

/** Waits until triangles are drawn. */
const drawn = (page) =>
  page.waitForFunction(() => /** @type {any} */ (document.querySelector("bezier-surface")).figure.mesh.triangles > 0);

/** Runs in the page with the element. */
const ask = (page, act) => page.locator("bezier-surface").evaluate(act);

const scripts = (page) =>
  page.evaluate(() =>
    performance
      .getEntriesByType("resource")
      .map(({ name }) => new URL(name).pathname)
      .filter((path) => /\/(elements-surface-rational|nurbs[\w-]*)\.js$/.test(path))
      .sort(),
  );

test("surfaces with weights are loaded for a model that has them, without curves; one may go on to any other model", async (t) => {
  const page = await openSurface(t, 'model="teacup"', /** @type {any} */ ({ fresh: true }));
  assert.deepEqual(await scripts(page), []);
  await set(page, { model: "sphere", segments: 6 });
  await page.waitForFunction(
    () => /** @type {any} */ (document.querySelector("bezier-surface")).figure.mesh.triangles === 8 * 2 * 36,
  );
  assert.deepEqual(await scripts(page), ["/dist/elements-surface-rational.js"]);
  await set(page, { patch: 3, u: 0.3, v: 0.8 });
  const { point, normal } = await ask(page, ({ figure }) => figure.place);
  assertNear([Math.hypot(...point)], [2], 1e-12);
  assertNear(
    normal,
    point.map((x) => x / 2),
    1e-12,
  );
  await set(page, { model: "teapot" });
  assert.equal(await ask(page, ({ surface }) => surface.patchCount), 32);
  await set(page, { model: "cone", tolerance: 0.05 });
  await drawn(page);
  assert.equal(await ask(page, ({ figure }) => figure.mesh.error), 0.05);
});

test("the four models are drawn, in every shading and with every layer", async (t) => {
  const page = await openSurface(t, 'model="torus"');
  for (const model of ["torus", "cylinder", "cone", "sphere"]) {
    await set(page, { model });
    await drawn(page);
    for (const shading of ["smooth", "gaussian", "patches"]) await set(page, { shading });
    await set(page, { show: "surface mesh isocurves tubes net casteljau place derivatives names", patch: 0 });
    await set(page, { show: "surface", evaluation: "gpu" });
    await set(page, { evaluation: "forward", swept: true });
    const { inked } = await look(page);
    assert.ok(inked > 1e4, `${model}: ${inked}`);
    await set(page, { evaluation: "cpu", swept: false, shading: "smooth", patch: null });
  }
  assert.ok((await facts(page)).triangles > 0);
  const open = await ask(page, ({ surface }) => surface.topology().open.length);
  assert.equal(open, 0, "a sphere is closed");
});

test("the curves of an element's surface need casteljau/nurbs, which shares its classes", async (t) => {
  const page = await openSurface(t, 'model="cylinder"', /** @type {any} */ ({ fresh: true }));
  await drawn(page);
  /** The radius 1.5 of the sides, as the curvature of one. */
  const curvature = () => ask(page, ({ surface }) => surface.patch(0).isocurveAtV(0).curvature(0.3));
  if (isRelease) await assert.rejects(curvature, /need an import of casteljau\/nurbs/);
  const isOfItsClass = await page.evaluate(async () => {
    const { RationalSurface } = await import(/** @type {any} */ ("/dist/nurbs.js"));
    return /** @type {any} */ (document.querySelector("bezier-surface")).surface instanceof RationalSurface;
  });
  assert.ok(isOfItsClass);
  assertNear([Math.abs(await curvature())], [1 / 1.5], 1e-12);
});

test("a surface of casteljau/nurbs can be set; what is set later counts", async (t) => {
  const page = await openSurface(t, "controls");
  await page.evaluate(async () => {
    const { NurbsSurface } = await import(/** @type {any} */ ("/dist/nurbs.js"));
    const element = /** @type {any} */ (document.querySelector("bezier-surface"));
    element.surface = NurbsSurface.sphere([0, 0, 0], 1).toSurface();
    element.surface = NurbsSurface.torus([1, 0, 0], 2, 0.5).toSurface();
  });
  await page.waitForFunction(
    () => /** @type {any} */ (document.querySelector("bezier-surface")).surface.patchCount === 16,
  );
  await drawn(page);
  await page.getByText("A surface of your own, of 16 patches.").waitFor();
  await page.evaluate(() => {
    const element = /** @type {any} */ (document.querySelector("bezier-surface"));
    element.surface = null;
  });
  await drawn(page);
  assert.equal(await ask(page, ({ surface }) => surface.patchCount), 32);
});

/** A quarter of a cylinder of radius 1 and height 2: a rational patch of degrees 2 and 1. */
const QUARTER = `surface
vertices 6
1 0 0
1 1 0
0 1 0
1 0 2
1 1 2
0 1 2
patches 1
2 1
0 1 2
3 4 5
w 1 0.7071067811865476 1
w 1 0.7071067811865476 1
`;

const opened = (page, name, text) =>
  page
    .locator('bezier-surface input[type="file"]')
    .setInputFiles({ name, mimeType: "text/plain", buffer: Buffer.from(text) });

test("a file with weights loads the code for weights, and one without does not; it can be saved and undone", async (t) => {
  const page = await openSurface(t, 'controls tolerance="0.01"', /** @type {any} */ ({ fresh: true }));
  await opened(page, "plain.txt", QUARTER.replace(/^w .*\n/gm, ""));
  await page.getByText("A surface of your own, of one patch.").waitFor();
  assert.deepEqual(await scripts(page), []);
  await opened(page, "wrong.txt", QUARTER.replace("w 1", "w 0"));
  await page.getByText(/wrong\.txt: .*above 0/).waitFor();
  await opened(page, "quarter.txt", QUARTER);
  await page.waitForFunction(
    () => "weights" in /** @type {any} */ (document.querySelector("bezier-surface")).surface.patch(0),
  );
  await drawn(page);
  const { x, y } = await ask(page, ({ surface }) => surface.patch(0).eval(0.3, 0.5));
  assertNear([Math.hypot(x, y)], [1], 1e-15);
  const { name, bytes } = await downloadBy(page.getByRole("button", { name: "OBJ" }));
  assert.equal(name, "surface.obj");
  const points = [...String(bytes).matchAll(/^v (\S+) (\S+)/gm)].map(([, ...numbers]) => numbers.map(Number));
  assert.ok(points.length > 10);
  for (const point of points) assertNear([Math.hypot(...point)], [1], 1e-7); // of f32
  await ask(page, (element) => element.undo());
  await drawn(page);
  assert.equal(await ask(page, ({ surface }) => "weights" in surface), false);
});
