// What the tests of <bezier-surface> share: a page with one element, hands and eyes.
import assert from "node:assert/strict";
import { openPage } from "./browser.js";

export const SHADINGS = ["smooth", "flat", "normals", "gaussian", "mean", "patches"];

/** A page with one element, filled 640 pixels wide. */
export const surfacePage = (attributes = "", more = "") =>
  `<!doctype html><html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width"><meta name="color-scheme" content="light dark"><title>A surface</title>
<body style="margin: 8px; background: Canvas"><main><h1>A surface</h1><bezier-surface style="max-width: 640px" ${attributes}></bezier-surface>${more}</main>
<script type="module">import "./dist/elements.js"; import * as casteljau from "./dist/index.js"; globalThis.bezier = casteljau;</script></body></html>`;

/** All but those of software rendering on its speed, which say nothing about the page. */
const WARNINGS = /^(?!.*(GL Driver Message|ReadPixels))/;

/**
 * Opens such a page; warnings count as errors.
 *
 * @param {import("node:test").TestContext} t
 * @param {string} attributes
 * @param {import("playwright-core").BrowserContextOptions & { more?: string }} [options]
 */
export async function openSurface(t, attributes = "", { more, ...options } = {}) {
  const viewport = { width: 800, height: 1200 };
  const page = await openPage(
    t,
    { html: surfacePage(attributes, more) },
    { viewport, reducedMotion: "reduce", messages: WARNINGS, ...options },
  );
  await ready(page);
  await page.evaluate(() =>
    document.querySelector("bezier-surface").shadowRoot.querySelector(".more")?.setAttribute("open", ""),
  );
  return page;
}

/** Waits until the element has drawn and told so. */
export const ready = (page) =>
  page.waitForFunction(() =>
    /triangles/.test(document.querySelector("bezier-surface")?.shadowRoot?.querySelector(".facts")?.textContent ?? ""),
  );

/** Sets properties of the element and waits until they are drawn. */
export async function set(page, properties) {
  await page.evaluate((given) => Object.assign(document.querySelector("bezier-surface"), given), properties);
  await settled(page);
  if ("view" in properties) await settled(page); // a mesh by pixels follows after three frames without a movement
}

/** Waits until what was changed has been drawn and told. */
export const settled = (page) =>
  page.evaluate(async () => {
    const element = document.querySelector("bezier-surface");
    for (let i = 0; i < 3; i++) {
      await element.updateComplete;
      await new Promise((done) => requestAnimationFrame(done));
    }
    await element.updateComplete;
  });

/**
 * How many of the picture's pixels are drawn on, their colours, their box. The picture itself stays in the page, under a
 * number.
 */
export const look = (page, index = 0) =>
  page.evaluate(async (index) => {
    const bitmap = await createImageBitmap(await document.querySelectorAll("bezier-surface")[index].toBlob());
    const { width, height } = bitmap;
    const context = /** @type {any} */ (
      Object.assign(document.createElement("canvas"), { width, height }).getContext("2d", {
        willReadFrequently: true,
      })
    );
    context.drawImage(bitmap, 0, 0);
    const { data } = context.getImageData(0, 0, width, height);
    const colours = new Set();
    let [inked, left, right, loud] = [0, width, 0, 0];
    for (let i = 0; i < data.length; i += 4) {
      if (data[i + 3] < 128) continue;
      inked++;
      if (data[i] > 230 && data[i + 1] < 90 && data[i + 2] > 170) loud++; // the colour of the cracks
      colours.add((data[i] << 16) | (data[i + 1] << 8) | data[i + 2]);
      const x = (i / 4) % width;
      [left, right] = [Math.min(left, x), Math.max(right, x)];
    }
    globalThis.pictures ??= [];
    const number = globalThis.pictures.push(data) - 1;
    return { inked, loud, left, right, width, height, colours: colours.size, number };
  }, index);

/** How many pixels of two pictures differ by more than so much in some channel. */
export const difference = (page, a, b, threshold = 24) =>
  page.evaluate(
    ([i, j, threshold]) => {
      const [a, b] = [globalThis.pictures[i], globalThis.pictures[j]];
      let count = 0;
      for (let at = 0; at < a.length; at += 4) {
        const far = (k) => Math.abs(a[at + k] - b[at + k]) > threshold;
        if (far(0) || far(1) || far(2) || far(3)) count++;
      }
      return count;
    },
    [a.number, b.number, threshold],
  );

/** What the read-out says. */
export const facts = async (page) => {
  const text = await page.locator("bezier-surface .facts").innerText();
  const number = (word) => Number(text.replaceAll(/(?<=\d),(?=\d)/g, "").match(new RegExp(`(\\d+)\\s+${word}`))?.[1]);
  return { text, triangles: number("triangles"), vertices: number("vertices") };
};

/** Where the canvas is. */
export const canvasBox = (page) => page.locator("bezier-surface canvas").boundingBox();

/** Of the picture's pixels, so many may differ between core and graphics card: rounding at silhouettes. */
export const FEW = 0.002;

/** Fails unless a shading looks the same whatever evaluates the surface: the core, forward differences, the graphics card. */
export async function assertSamePictures(page, shading) {
  await set(page, { shading, evaluation: "cpu" });
  const cpu = await look(page);
  assert.ok(cpu.inked > 5000, `${cpu.inked} pixels`);
  for (const evaluation of ["forward", "gpu"]) {
    await set(page, { evaluation });
    if (evaluation === "gpu") assert.match((await facts(page)).text, /by the graphics card/);
    const count = await difference(page, cpu, await look(page));
    assert.ok(count <= FEW * cpu.width * cpu.height, `${shading}, ${evaluation}: ${count} pixels differ`);
  }
}
