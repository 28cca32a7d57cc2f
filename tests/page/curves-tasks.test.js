// The tasks of the chapter on curves with the real figures: the answer that each reveals is accepted, and new ones are solved by hand.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openPage } from "./browser.js";

/** @param {import("node:test").TestContext} t */
async function open(t) {
  const page = await openPage(t, "/curves/", {
    viewport: { width: 1100, height: 800 },
    reducedMotion: "reduce",
    fresh: true,
  });
  await page.waitForFunction(() => customElements.get("bezier-applet") && customElements.get("lesson-task"));
  return page;
}

/** A task, in view, with a guess made if it asks for one. @param {import("playwright-core").Page} page @param {string} name */
async function opened(page, name) {
  const task = page.locator(`lesson-task[name="${name}"]`);
  const id = await task.getAttribute("for");
  if (id) await page.locator(`#${id}`).scrollIntoViewIfNeeded();
  await task.scrollIntoViewIfNeeded();
  await task.getByRole("button").first().waitFor();
  if (await task.getByRole("radio").count()) {
    await task.getByRole("radio").first().check();
    await task.getByRole("button", { name: "That is my guess" }).click();
  }
  return task;
}

test("no task is done at the start, and the revealed answer counts", async (t) => {
  const page = await open(t);
  const names = await page
    .locator("lesson-task[for]")
    .evaluateAll((all) => all.map((task) => task.getAttribute("name") ?? ""));
  assert.ok(names.length > 20, names.join(" "));
  for (const name of names) {
    const task = await opened(page, name);
    const check = task.getByRole("button", { name: "Check" });
    await check.click();
    assert.equal(await task.getAttribute("data-state"), "open", `${name} at the start`);
    await task.getByRole("button", { name: "Reveal" }).click();
    assert.equal(await task.getAttribute("data-state"), "revealed", name);
    await check.click();
    assert.equal(await task.getAttribute("data-state"), "done", `${name}: ${await task.locator(".words").innerText()}`);
  }
});

test("sliders solve the tasks about curvature, length, offset and circle, with the value shown meanwhile", async (t) => {
  const page = await open(t);
  for (const [name, slider, wrong, words, right] of /** @type {[string, string, string, RegExp, string][]} */ ([
    [
      "sharpest-bend",
      "#bend input[type=range][aria-valuetext]:not(.handle *)",
      "0.5",
      /radius of curvature is \d/,
      "0.85",
    ],
    [
      "half-length",
      "#arc input[type=range][aria-valuetext]:not(.handle *)",
      "0.6",
      /t = 0\.60: 4\d\.\d % of the length/,
      "0.67",
    ],
    ["offset-cusp", "#figure-offset attribute-slider input", "120", /there are cusps/, "112"],
    ["quarter-circle", "#circle input[type=range]", "0.56", /h = 0\.5600: the error is/, "0.5519"],
  ])) {
    const task = await opened(page, name);
    const input = page.locator(slider).first();
    await input.fill(wrong);
    await task.getByText(words).waitFor();
    assert.equal(await task.getAttribute("data-state"), "open", name);
    await input.fill(right);
    await page.locator(`lesson-task[name="${name}"][data-state="done"]`).waitFor();
  }
});
