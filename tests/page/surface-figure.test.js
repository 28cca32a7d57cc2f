// <bezier-surface>: what pages read of it, the layers of the chapter, and the graphics card that it borrows.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openPage } from "./browser.js";
import { difference, look, openSurface, ready, set, settled, surfacePage } from "./surface-page.js";

/** The element's figure without its surface. */
const figure = (page) =>
  page.evaluate(() =>
    JSON.parse(JSON.stringify({ ...document.querySelector("bezier-surface").figure, surface: null })),
  );

test("update follows every change, and the figure then has the mesh that is drawn", async (t) => {
  const page = await openSurface(t, 'model="patch" segments="4"');
  assert.deepEqual((await figure(page)).mesh.triangles, 32);
  const updates = await page.evaluate(async () => {
    const element = document.querySelector("bezier-surface");
    let count = 0;
    element.addEventListener("update", () => count++);
    document.querySelector("main").addEventListener("update", () => (count += 100));
    element.segments = 5;
    await element.updateComplete;
    return count;
  });
  assert.ok(updates >= 1 && updates < 100, `${updates}`);
  await settled(page);
  assert.equal((await figure(page)).mesh.triangles, 50);
});

test("a swept surface ends at u; ribbons and the derivatives are drawn", async (t) => {
  const page = await openSurface(t, 'model="patch" swept u="1"');
  const whole = await look(page);
  await set(page, { u: 0.5 });
  const half = await look(page);
  assert.ok(half.inked < 0.7 * whole.inked && half.inked > 0.2 * whole.inked, `${half.inked} of ${whole.inked}`);
  await set(page, { swept: false });
  assert.equal(await difference(page, whole, await look(page)), 0);
  const before = (await figure(page)).mesh.triangles;
  for (const layer of ["ribbons", "derivatives"]) {
    await set(page, { show: "surface" });
    const plain = await look(page);
    await set(page, { show: `surface ${layer}` });
    assert.ok((await difference(page, plain, await look(page))) > 300, layer);
  }
  await set(page, { show: "surface ribbons" });
  assert.ok((await figure(page)).mesh.triangles > before);
});

test("the nearest point to a probe is drawn; without one nothing is", async (t) => {
  const page = await openSurface(t, 'model="patch"');
  const plain = await look(page);
  await set(page, { probe: "3 -3, 4" });
  assert.deepEqual((await figure(page)).probe, [3, -3, 4]);
  assert.ok((await difference(page, plain, await look(page))) > 100);
  await set(page, { probe: null });
  assert.equal((await figure(page)).nearest, null);
  assert.equal(await difference(page, plain, await look(page)), 0);
});

test("of twenty elements only those near what is seen hold the graphics card, and all can be seen", async (t) => {
  const many = Array.from(
    { length: 20 },
    (_, k) => `<bezier-surface style="margin-block: 200px" segments="${(k % 5) + 1}"></bezier-surface>`,
  ).join("");
  const html = surfacePage("", many).replace(
    "<script",
    "<script>const ask = HTMLCanvasElement.prototype.getContext; globalThis.contexts = new Set(); HTMLCanvasElement.prototype.getContext = function (...args) { const got = ask.apply(this, args); if (got) contexts.add(got); return got; };</script><script",
  );
  const options = {
    viewport: { width: 800, height: 600 },
    reducedMotion: /** @type {const} */ ("reduce"),
    messages: /context/i,
  };
  const page = await openPage(t, { html }, options);
  await ready(page);
  const living = () => page.evaluate(() => [...contexts].filter((each) => !each.isContextLost()).length);
  const elements = page.locator("bezier-surface");
  for (const k of [...Array(21).keys(), 0, 20, 10]) {
    await elements.nth(k).scrollIntoViewIfNeeded();
    await page.waitForFunction(
      (k) =>
        /triangles/.test(document.querySelectorAll("bezier-surface")[k].shadowRoot.querySelector(".facts").textContent),
      k,
    );
    await page.evaluate(async (k) => {
      while (!(await document.querySelectorAll("bezier-surface")[k].toBlob()))
        await new Promise((done) => requestAnimationFrame(done));
    }, k);
    assert.ok((await living()) <= 8, `${await living()} at ${k}`);
  }
  const { inked } = await look(page, 10);
  assert.ok(inked > 10000, `${inked} pixels`);
});
