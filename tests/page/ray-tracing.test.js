// The pictures of the chapter on surfaces that are computed on the page: ray tracing in a Web Worker, and REYES dicing.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openPage, root } from "./browser.js";
import { serve } from "./server.js";
import { done, goTo, task } from "./chapter-page.js";
import { near, open } from "./surfaces-page.js";

/** Of the pixels of the traced picture: how many are the teapot's, and whether the corners are background. */
const coverage = (page) =>
  page.evaluate(() => {
    const canvas = document.querySelector("ray-tracing").shadowRoot.querySelector("canvas");
    const { width, height } = canvas;
    const { data } = canvas.getContext("2d").getImageData(0, 0, width, height);
    const alpha = data.filter((_, i) => i % 4 === 3);
    return { width, height, covered: alpha.filter((a) => a === 255).length / alpha.length, corner: alpha[0] };
  });

const stateOf = (page) => page.evaluate(() => document.querySelector("ray-tracing").figure);

test("the teapot is traced to the end, without and with a changed view, and the task sees it", async (t) => {
  const page = await open(t);
  await near(page, "trace-mesh");
  await task(page, "outline-edges", 1);
  const figure = page.locator("ray-tracing");
  await figure.getByRole("button", { name: "Trace this view" }).click();
  await figure.getByRole("button", { name: "Cancel" }).waitFor();
  await figure.getByText("Finished.").waitFor();
  assert.match(await done(page, "outline-edges"), /You predicted it/);
  const { width, height, covered, corner } = await coverage(page);
  assert.ok(width > 100 && width === height, `${width} × ${height}`);
  assert.ok(covered > 0.15 && covered < 0.5, `${covered}`);
  assert.equal(corner, 0);
  await page.locator("#trace-mesh").locator("canvas").press("ArrowLeft");
  await figure.getByText("The view has changed since then.").waitFor();
});

test("tracing can be cancelled, and started again", async (t) => {
  const page = await open(t);
  await near(page, "trace-mesh");
  const figure = page.locator("ray-tracing");
  await figure.getByRole("button", { name: "Trace this view" }).click();
  await page.waitForFunction(() => document.querySelector("ray-tracing").figure.progress > 0);
  await figure.getByRole("button", { name: "Cancel" }).click();
  await figure.getByText("Cancelled.").waitFor();
  const { state, progress } = await stateOf(page);
  assert.equal(state, "cancelled");
  assert.ok(progress > 0 && progress < 1, `${progress}`);
  await figure.getByRole("checkbox", { name: "Shadows" }).uncheck();
  await figure.getByRole("button", { name: "Trace this view" }).click();
  await figure.getByText("Finished.").waitFor();
});

test("the worker starts in any folder of a plain file server", async (t) => {
  const server = await serve({ "/some/folder/": `${root}site` });
  t.after(() => server.close());
  const page = await openPage(t, "/some/folder/surfaces/ray-tracing/", {
    baseURL: server.url,
    reducedMotion: "reduce",
  });
  await page.locator("ray-tracing").scrollIntoViewIfNeeded();
  await page.locator("ray-tracing").getByRole("button", { name: "Trace this view" }).click();
  await page.waitForFunction(() => document.querySelector("ray-tracing").figure.progress > 0);
});

test("a smaller picture and larger micropolygons are fewer micropolygons, and the task counts them", async (t) => {
  const page = await open(t);
  await goTo(page, "figure-reyes");
  const figure = page.locator("reyes-dicing");
  await figure.scrollIntoViewIfNeeded();
  await task(page, "micropolygons", 2);
  const count = async () => Number(await figure.locator("[data-micropolygons]").getAttribute("data-micropolygons"));
  await page.waitForFunction(() => document.querySelector("reyes-dicing").figure.micropolygons > 0);
  const first = await count();
  await figure.getByRole("slider", { name: "Zoom" }).fill("0.5");
  await page
    .locator('lesson-task[name="micropolygons"]')
    .getByText(/At the zoom 0\.50 there are/)
    .waitFor();
  assert.equal(await page.locator('lesson-task[name="micropolygons"]').getAttribute("data-state"), "open");
  const small = await count();
  assert.ok(small < first / 2 && small > first / 8, `${small} of ${first}`);
  await figure.getByRole("slider", { name: "Zoom" }).fill("0.6");
  assert.match(await done(page, "micropolygons"), /At the zoom 0\.60 there are .* You predicted it/);
  await figure.getByRole("slider", { name: "Zoom" }).fill("0.5");
  await figure.getByRole("slider", { name: "Micropolygon size" }).fill("32");
  await page.waitForFunction((small) => document.querySelector("reyes-dicing").figure.micropolygons < small, small);
  const pixels = () =>
    figure.locator("canvas").evaluate((/** @type {HTMLCanvasElement} */ canvas) => canvas.toDataURL());
  const pictures = new Set();
  for (const name of ["1 Bound", "2 Split", "3 Dice", "4 Shade"]) {
    await figure.getByRole("radio", { name }).check();
    await page.evaluate(() => document.querySelector("reyes-dicing").updateComplete);
    pictures.add(await pixels());
  }
  assert.equal(pictures.size, 4);
});
