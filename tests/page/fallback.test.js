// Where nothing runs: without JavaScript, on paper, and before an element has begun, what the page put into it is shown.
import assert from "node:assert/strict";
import { test } from "node:test";
import { intersectionsReported, openPage } from "./browser.js";

const PICTURE =
  '<svg viewBox="0 0 670 480" width="100%" role="img" aria-label="A curve"><path d="M70 330C120 90 290 90 335 240" fill="none" stroke="#0072b2" stroke-width="9"/></svg>';
const KINDS = ["bezier-applet", "bezier-surface"];
const html = (between = "") =>
  `<!doctype html><html lang="en"><meta charset="utf-8"><title>Fallback</title><body><main style="max-width: 640px"><h1>Pictures</h1>${between}${KINDS.map((kind) => `<${kind}>${PICTURE}</${kind}>`).join("\n")}</main>
<script type="module" src="dist/elements.js"></script></body></html>`;
const FAR = '<div style="height: 6000px">Much to read</div>';

/** How large the picture in an element is. */
const sizeOf = async (page, kind) => {
  const box = await page.locator(`${kind} svg`).first().boundingBox();
  return box ? [box.width, box.height] : [0, 0];
};

test("without JavaScript the pictures are there", async (t) => {
  const page = await openPage(t, { html: html() }, { javaScriptEnabled: false });
  for (const kind of KINDS) {
    const [width, height] = await sizeOf(page, kind);
    assert.ok(width > 600 && height > 400, `${kind}: ${width} × ${height}`);
  }
});

test("until an element comes near its picture stands in; then it makes room", async (t) => {
  const page = await openPage(t, { html: html(FAR) }, { viewport: { width: 800, height: 600 } });
  await intersectionsReported(page);
  assert.deepEqual(
    await page.evaluate(() => document.querySelectorAll("main :defined:is(bezier-applet, bezier-surface)").length),
    0,
  );
  for (const kind of KINDS) {
    const [width, height] = await sizeOf(page, kind);
    assert.ok(width > 600 && height > 400, `${kind}: ${width} × ${height}`);
  }
  for (const kind of KINDS) {
    await page.locator(kind).scrollIntoViewIfNeeded();
    await page.locator(`${kind} svg`).first().waitFor({ state: "hidden" });
    await page.waitForFunction(
      (kind) => document.querySelector(kind).shadowRoot.querySelector("canvas").width > 100,
      kind,
    );
  }
});

/** How many pixels of a colour's kind a picture of the page has: blue, that is. */
const blue = (page, png) =>
  page.evaluate(
    async (bytes) => {
      const bitmap = await createImageBitmap(new Blob([new Uint8Array(bytes)]));
      const context = /** @type {any} */ (
        Object.assign(document.createElement("canvas"), {
          width: bitmap.width,
          height: bitmap.height,
        }).getContext("2d")
      );
      context.drawImage(bitmap, 0, 0);
      const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
      let count = 0;
      for (let i = 0; i < data.length; i += 4) if (data[i + 2] > data[i] + 40) count++;
      return count;
    },
    [...png],
  );

test("on paper: what has been drawn, and the pictures of what has not", async (t) => {
  const page = await openPage(t, { html: html(FAR) }, { viewport: { width: 800, height: 600 } });
  await page.evaluate(() =>
    document.querySelector("main").prepend(Object.assign(document.createElement("bezier-applet"), { id: "first" })),
  );
  await page.waitForFunction(() => document.querySelector("#first").shadowRoot?.querySelector("canvas")?.width > 100);
  await page.emulateMedia({ media: "print" });
  const first = await page.locator("#first").screenshot();
  assert.ok((await blue(page, first)) > 300, "the curve that is drawn");
  for (const kind of KINDS) {
    const [width, height] = await sizeOf(page, `${kind}:not(#first)`);
    assert.ok(width > 600 && height > 400, kind);
  }
  const paper = await page.pdf();
  assert.ok(paper.length > 10_000);
});
