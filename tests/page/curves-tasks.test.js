// The tasks of the chapter on curves with the real figures: the answer that each reveals is accepted, and new ones are solved by hand.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openCurves, task as taskOf } from "./chapter-page.js";

const open = (t) => openCurves(t, { keep: false, fresh: true });

/** A task, in view, with a guess made if it asks for one. @param {import("playwright-core").Page} page @param {string} name */
async function opened(page, name) {
  const id = await page.locator(`lesson-task[name="${name}"]`).getAttribute("for");
  if (id) await page.locator(`#${id}`).scrollIntoViewIfNeeded();
  const task = await taskOf(page, name);
  if (await task.getByRole("radio").count()) return taskOf(page, name, 0);
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
    const states = await task.evaluate(async (/** @type {any} */ task) => {
      const states = [];
      for (const name of ["Check", "Reveal", "Check"]) {
        [...task.querySelectorAll("button")].find((button) => button.textContent.includes(name)).click();
        await task.updateComplete;
        states.push(task.dataset.state);
      }
      return states;
    });
    assert.deepEqual(states, ["open", "revealed", "done"], `${name}: ${await task.locator(".words").innerText()}`);
  }
});

test("sliders solve the tasks about curvature, length, offset and circle, with the value shown meanwhile", async (t) => {
  const page = await open(t);
  const ofT = "input[type=range][aria-valuetext]:not(.handle *)";
  for (const [name, slider, wrong, words, right] of /** @type {[string, string, string, RegExp, string][]} */ ([
    ["sharpest-bend", `#bend ${ofT}`, "0.5", /radius of curvature is \d/, "0.85"],
    ["half-length", `#arc ${ofT}`, "0.6", /t = 0\.60: 4\d\.\d % of the length/, "0.67"],
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
