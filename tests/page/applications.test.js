// The applications: addresses do no harm, a strict policy is enough; and the first of them, easing.
import assert from "node:assert/strict";
import { test } from "node:test";
import { easing } from "casteljau";
import { close, open, slide, state, TAGS } from "./application-page.js";
import { openPage, root } from "./browser.js";
import { serve } from "./server.js";

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

test("applications and figures work under a strict policy", async (t) => {
  const policy =
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src 'self' data:; font-src 'self'";
  const site = await serve({ "/": `${root}site` }, { "Content-Security-Policy": policy });
  t.after(site.close);
  for (const [path, tag] of [...Object.entries(TAGS), ["/figures/", "fig-compare"]]) {
    const page = await openPage(t, path, { baseURL: site.url });
    await page.locator(`${tag} svg`).first().waitFor();
    const handles = page.locator(`${tag} .handle`);
    if (await handles.count()) assert.ok((await handles.first().evaluate((handle) => handle.style.left)).endsWith("%"));
  }
});

test("easing: presets, text and editor are one value, which the address keeps", async (t) => {
  const page = await open(t, "/easing/");
  await page.getByRole("button", { name: "overshoot" }).click();
  assert.match(await page.locator("pre").first().innerText(), /cubic-bezier\(0\.34, 1\.56, 0\.64, 1\)/);
  assert.deepEqual(await state(page), { curve: [0.34, 1.56, 0.64, 1] });
  await page.waitForFunction(
    () => document.querySelector("bezier-easing").value === "cubic-bezier(0.34, 1.56, 0.64, 1)",
  );
  const text = page.getByLabel("Value");
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

test("easing: the editor inside steers the page", async (t) => {
  const page = await open(t, "/easing/");
  const field = page.locator("bezier-easing input[type=number]").first();
  await field.waitFor();
  await field.fill("0.9");
  await field.press("Enter");
  await page.waitForFunction(() => document.querySelector("easing-lab").value[0] === 0.9);
  assert.equal((await state(page)).curve[0], 0.9);
});

test("easing: the preview is where the browser's own animation is, and x is not t", async (t) => {
  const page = await open(t, "/easing/");
  for (const name of ["gentle stop", "wind up"]) {
    await page.getByRole("button", { name }).click();
    await slide(page, "time x", 0.6);
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
  const button = page.locator("easing-lab .frame .controls > button").first();
  // In one go: however slow the machine is, four seconds have not passed between the two clicks.
  await slide(page, "Duration", 4000);
  const words = await button.evaluate(async (/** @type {any} */ button) => {
    const lab = document.querySelector("easing-lab");
    const words = [];
    for (let i = 0; i < 2; i++) {
      button.click();
      await lab.updateComplete;
      words.push([button.innerText, lab.playing]);
    }
    return words;
  });
  assert.deepEqual(words, [
    ["Stop", true],
    ["Play", false],
  ]);
  await slide(page, "Duration", 200);
  await button.click();
  await page.waitForFunction(() => document.querySelector("easing-lab").x === 1);
  await page.waitForFunction(() => !document.querySelector("easing-lab").playing);
});
