// The tasks of the chapters with the real figures: none is done at the start, the answer that each reveals is accepted, and the value
// is shown while it changes. tests/js/*-tasks.test.js have what solves each and what does not.
import assert from "node:assert/strict";
import { test } from "node:test";
import { goTo, openCurves, sectionsOf, task as taskOf } from "./chapter-page.js";
import { near, open as openSurfaces } from "./surfaces-page.js";

/** @typedef {import("playwright-core").Page} Page */
/** The chapters, and what waits for a figure. @type {Record<string, [(t: any, options: any) => Promise<Page>, number]>} */
const CHAPTERS = { curves: [openCurves, 20], surfaces: [openSurfaces, 10] };

/** A task, in view, with a guess made if it asks for one. @param {Page} page @param {string} name */
async function opened(page, name) {
  await goTo(page, name);
  const id = await page.locator(`lesson-task[name="${name}"]`).getAttribute("for");
  if (id && (await page.locator(`bezier-surface#${id}`).count())) await near(page, id);
  else if (id) await page.locator(`#${id}`).scrollIntoViewIfNeeded();
  const task = await taskOf(page, name);
  return (await task.locator(".answers").count()) ? taskOf(page, name, 0) : task;
}

for (const [chapter, [open, count]] of Object.entries(CHAPTERS))
  test(`${chapter}: no task is done at the start, and the revealed answer counts`, async (t) => {
    const page = await open(t, { keep: false, fresh: true });
    const names = sectionsOf(/** @type {any} */ (chapter)).flatMap(({ tasks }) => tasks);
    assert.ok(names.length > count, names.join(" "));
    for (const name of names) {
      const task = await opened(page, name);
      if ((await task.getAttribute("for")) === null) continue; // a question
      const state = () => task.getAttribute("data-state");
      const press = async (word) => {
        await task.evaluate(async (/** @type {any} */ task, word) => {
          [...task.querySelectorAll("button")].find((button) => button.textContent.includes(word)).click();
          await task.updateComplete;
        }, word);
        return state();
      };
      const states = [await press("Check")];
      assert.equal(
        await task.getByRole("button", { name: "Put it back" }).count(),
        0,
        `${name}: nothing has moved yet`,
      );
      states.push(await press("Reveal"));
      // What a figure computes for a while, as a picture by rays, counts when it is there.
      await page.waitForFunction((name) => {
        const task = /** @type {any} */ (document.querySelector(`lesson-task[name="${name}"]`));
        [...task.querySelectorAll("button")].find((button) => button.textContent.includes("Check"))?.click();
        return task.dataset.state === "done";
      }, name);
      assert.deepEqual(states, ["open", "revealed"], `${name}: ${await task.locator(".words").innerText()}`);
    }
  });

test("sliders and a field solve the tasks about curvature, length, offset and circle, with the value shown meanwhile", async (t) => {
  const page = await openCurves(t, { keep: false, fresh: true });
  const ofT = "input[type=range][aria-valuetext]:not(.handle *)";
  for (const [name, slider, wrong, words, right] of /** @type {[string, string, string, RegExp, string][]} */ ([
    ["sharpest-bend", `#bend ${ofT}`, "0.5", /radius of curvature is \d/, "0.85"],
    ["half-length", `#arc ${ofT}`, "0.6", /t = 0\.60: 4\d\.\d % of the length/, "0.67"],
    ["offset-cusp", "#figure-offset attribute-slider input", "120", /there are cusps/, "112"],
    ["quarter-circle", "#circle input[type=number]", "0.56", /h = 0\.5600: the error is/, "0.5519"],
  ])) {
    const task = await opened(page, name);
    const input = page.locator(slider).first();
    await input.fill(wrong);
    await task.getByText(words).waitFor();
    assert.equal(await task.getAttribute("data-state"), "open", name);
    await input.fill(right);
    await input.blur(); // a typed number counts when the field is left
    await page.locator(`lesson-task[name="${name}"][data-state="done"]`).waitFor();
  }
});
