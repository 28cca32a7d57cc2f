// The tools: where they are on their pages; addresses do no harm, a strict policy is enough; and the first of them, easing.
import assert from "node:assert/strict";
import { test } from "node:test";
import { easing } from "casteljau";
import { close, open, PHONE, slide, state, TAGS, TOOL, TOOLS } from "./application-page.js";
import { assertAccessibleInBothThemes, boxOf, frames, openPage, root } from "./browser.js";
import { dragBy } from "./gestures.js";
import { serve } from "./server.js";
import { openStrict } from "./site-pages.js";

for (const path of Object.keys(TAGS)) {
  test(`${path} takes no harm from addresses that somebody made up`, async (t) => {
    const page = await open(t, path);
    for (const hash of [
      "%E0%A4%A",
      "null",
      '{"points":[[1,2]],"curve":[9,9,9,9],"d":"M1 wrong"}',
      "x".repeat(1_000_000),
    ]) {
      await page.evaluate((hash) => (location.hash = `#state=${hash}`), hash);
      await page.locator(".state-message").waitFor();
      assert.match(await page.locator(".state-message").innerText(), /could not be used: .+\. The page is as it was\./);
      await page.evaluate(() => document.querySelector(".state-message").remove());
    }
  });
}

for (const path of TOOLS) {
  test(`${path} is accessible on a phone, light and dark, and writes nothing into the console`, async (t) => {
    const page = await openStrict(t, path, { ...PHONE, reducedMotion: "reduce" });
    if (TAGS[path]) await page.locator(`${TAGS[path]} svg`).first().waitFor();
    await assertAccessibleInBothThemes(page);
  });
}

/** What a tool draws in. @type {Record<string, string>} */
const PICTURES = {
  "/easing/": "easing-lab .stage svg",
  "/camera/": "#eye",
  "/glyph/": ".outline-view",
  "/ink/": ".pad",
  "/teapot/": "canvas",
};

for (const path of TOOLS) {
  test(`${path} has its tool in the first screen: below one sentence, and beside its controls where there is room`, async (t) => {
    const page = await openPage(t, path, { ...PHONE, reducedMotion: "reduce" });
    const picture = page.locator(PICTURES[path]).first();
    await picture.waitFor();
    const tool = await boxOf(page.locator(TOOL));
    assert.ok(tool.y < 300, `it starts at ${tool.y}`);
    const small = await boxOf(picture);
    assert.ok(small.y + small.height <= PHONE.viewport.height, "and all of the picture can be seen");
    assert.ok(small.width >= 320 && small.height >= 200, `${small.width} × ${small.height}`);
    await page.setViewportSize({ width: 1280, height: 800 });
    await page.waitForFunction((selector) => document.querySelector(selector).clientWidth >= 1200, TOOL);
    await frames(page);
    const large = await boxOf(picture);
    assert.ok(large.y + large.height <= 800, `the picture ends at ${large.y + large.height}`);
    assert.ok(large.width >= 500 && large.height >= 450, `${large.width} × ${large.height}`);
    if (path === "/teapot/") return assert.equal(large.width, 1280);
    const [first, last] = [
      page.locator(".panes > .pane, .views > .view").first(),
      page.locator(".side, .outside").first(),
    ];
    const [left, right] = [await boxOf(first), await boxOf(last)];
    assert.ok(right.x >= left.x + left.width && Math.abs(right.y - left.y) < 10, "two panes");
  });
}

test("applications and figures work under a strict policy", async (t) => {
  const policy =
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src 'self' data:; font-src 'self'";
  const site = await serve({ "/": `${root}site` }, { "Content-Security-Policy": policy });
  t.after(site.close);
  for (const [path, tag] of [...Object.entries(TAGS), ["/figures/", "fig-compare"]]) {
    const page = await openPage(t, path, { baseURL: site.url });
    await page.locator(tag).first().scrollIntoViewIfNeeded(); // a figure is loaded when it is near
    await page.locator(`${tag} svg`).first().waitFor();
    const handles = page.locator(`${tag} .handle`);
    if (await handles.count()) assert.ok((await handles.first().evaluate((handle) => handle.style.left)).endsWith("%"));
  }
});

test("easing: presets, text and picture are one value, which the address keeps", async (t) => {
  const page = await open(t, "/easing/");
  await page.getByRole("button", { name: "overshoot" }).click();
  assert.match(await page.locator("pre").first().innerText(), /cubic-bezier\(0\.34, 1\.56, 0\.64, 1\)/);
  assert.deepEqual(await state(page), { curve: [0.34, 1.56, 0.64, 1] });
  assert.equal(await page.getByRole("slider", { name: "First handle, y" }).inputValue(), "1.56");
  const text = page.getByLabel("Value");
  assert.equal(await text.inputValue(), "cubic-bezier(0.34, 1.56, 0.64, 1)");
  for (const wrong of ["cubic-bezier(2, 0, 0, 1)", "bouncy", "cubic-bezier(0, NaN, 1, 1)", ""]) {
    await text.fill(wrong);
    await text.press("Enter");
    assert.match(await page.locator(".problem").innerText(), /^Not taken: .+ The last good curve is kept\.$/);
    assert.deepEqual(await page.evaluate(() => document.querySelector("easing-lab").value), [0.34, 1.56, 0.64, 1]);
  }
  await text.fill("transition-timing-function: cubic-bezier(.1, .7, 1, .1);");
  await text.press("Enter");
  assert.deepEqual(await state(page), { curve: [0.1, 0.7, 1, 0.1] });
  await page.reload();
  await page.waitForFunction(() => document.querySelector("easing-lab").value.join() === "0.1,0.7,1,0.1");
});

test("easing: handles are dragged and moved by keys, inside of the picture and of 0 ≤ x ≤ 1", async (t) => {
  const page = await open(t, "/easing/");
  const picture = await boxOf(page.locator("easing-lab .stage"));
  const handle = page.locator(".handle").first();
  const value = async () => (await state(page)).curve;
  await dragBy(page, handle, 40, -60);
  const [x, y, ...second] = await value();
  assert.ok(x > 0.3 && x < 0.4 && y > 0.2 && y < 0.3, `${x} ${y}`);
  assert.deepEqual(second, [0.25, 1]);
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("Shift+ArrowUp");
  close((await value())[0], x - 0.01, 1e-9);
  close((await value())[1], y + 0.1, 1e-9);
  await dragBy(page, handle, -2000, -2000);
  assert.equal((await value())[0], 0);
  assert.ok((await value())[1] > 1);
  const { x: left, y: top, width, height } = await boxOf(handle);
  assert.ok(left > picture.x && top > picture.y && width && height, "the picture shows all of the curve");
});

test("easing: the code is a tab for each language", async (t) => {
  const page = await open(t, "/easing/");
  const shown = () => page.getByRole("tabpanel").innerText();
  assert.match(await shown(), /transition: transform 1\.2s cubic-bezier\(0\.25, 0\.1, 0\.25, 1\)/);
  await page.getByRole("tab", { name: "CSS" }).focus();
  await page.keyboard.press("ArrowRight");
  assert.match(await shown(), /linear\(0, .+, 1\)/);
  const css = (await shown()).match(/linear\(.+\)/)?.[0] ?? "";
  for (let x = 0; x <= 1; x += 0.01) close(easing(css)(x), easing("ease")(x), 0.005 + 1e-9);
  await page.keyboard.press("End");
  assert.match(await shown(), /easing\(0\.25, 0\.1, 0\.25, 1\)/);
  assert.equal(await page.getByRole("tab", { selected: true }).innerText(), "JavaScript");
});

test("easing: the preview is where the browser's own animation is, and x is not t", async (t) => {
  const page = await open(t, "/easing/");
  for (const name of ["gentle stop", "wind up"]) {
    await page.getByRole("button", { name }).click();
    await slide(page, "Time x", 0.6);
    const value = await page.evaluate(() => document.querySelector("easing-lab").value);
    const browsers = await page.evaluate((numbers) => {
      const animation = document.body.animate([{ opacity: 1 }, { opacity: 1 }], {
        duration: 1000,
        easing: `cubic-bezier(${numbers})`,
        fill: "both",
      });
      animation.pause();
      animation.currentTime = 600;
      const { progress } = /** @type {AnimationEffect} */ (animation.effect).getComputedTiming();
      animation.cancel();
      return progress;
    }, value);
    const shown = await page
      .locator("[data-preview=move]")
      .evaluate((/** @type {any} */ box) => box.offsetLeft / (box.parentElement.clientWidth - box.offsetWidth));
    close(shown, browsers, 0.005); // whole pixels
    const t = Number(await page.locator(".t").innerText());
    close(3 * (1 - t) ** 2 * t * value[0] + 3 * (1 - t) * t * t * value[2] + t ** 3, 0.6, 2e-4);
    close(
      Number((await page.locator("b.y").innerText()).replace("−", "-")),
      easing(.../** @type {[number, number, number, number]} */ (value))(0.6),
      1e-4,
    );
  }
});

test("easing: playing runs the time, stops at its end, and can be stopped", async (t) => {
  const page = await open(t, "/easing/");
  const button = page.locator("easing-lab .play");
  // In one go: however slow the machine is, four seconds have not passed between the two clicks.
  await slide(page, "Duration", 4000);
  const words = await button.evaluate(async (/** @type {any} */ button) => {
    const lab = document.querySelector("easing-lab");
    const words = [];
    for (let i = 0; i < 2; i++) {
      button.click();
      await lab.updateComplete;
      words.push([button.ariaLabel, lab.playing]);
    }
    return words;
  });
  assert.deepEqual(words, [
    ["Pause", true],
    ["Play", false],
  ]);
  await slide(page, "Duration", 200);
  await button.click();
  await page.waitForFunction(() => document.querySelector("easing-lab").x === 1);
  await page.waitForFunction(() => !document.querySelector("easing-lab").playing);
});
