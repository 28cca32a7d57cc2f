// <bezier-surface> with weights: the models sphere, torus, cylinder and cone, and surfaces of casteljau/nurbs. What is loaded for them
// and when.
import assert from "node:assert/strict";
import { test } from "node:test";
import { assertNear } from "./gestures.js";
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
      .filter((path) => /surface-rational|nurbs/.test(path))
      .sort(),
  );

test("casteljau/nurbs is loaded for a model with weights, and not before; one may go on to any other model", async (t) => {
  const page = await openSurface(t, 'model="teacup"', /** @type {any} */ ({ fresh: true }));
  assert.deepEqual(await scripts(page), []);
  await set(page, { model: "sphere", segments: 6 });
  await page.waitForFunction(
    () => /** @type {any} */ (document.querySelector("bezier-surface")).figure.mesh.triangles === 8 * 2 * 36,
  );
  assert.deepEqual(await scripts(page), ["/dist/elements-surface-rational.js", "/dist/nurbs.js"]);
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
