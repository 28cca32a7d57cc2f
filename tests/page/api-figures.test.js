// Every figure of the API reference: dragging an input changes the picture and what the sample prints.
import assert from "node:assert/strict";
import { test } from "node:test";
import { entryFolders, readEntries } from "../../www/api/build/entries.js";
import { inputsOf } from "../../www/api/build/sample.js";
import { openPage } from "./browser.js";

/** Keys that move a point or a slider; some figures need several for another result. */
const KEYS = [..."uullddrrlluurrrrddddlllluuuu"].map(
  (letter) => ({ u: "ArrowUp", l: "ArrowLeft", d: "ArrowDown", r: "ArrowRight" })[letter] ?? "",
);

/** So many of them are tried on every control before the others. */
const FIRST_KEYS = 6;

/**
 * What a figure shows when the last change is drawn: its picture and the printed lines.
 *
 * @param {import("playwright-core").Locator} section
 */
const shownBy = (section) =>
  section.evaluate(async (element) => {
    const figure = element.querySelector("live-figure");
    while (figure?.hasAttribute("aria-busy")) {
      await new Promise((resolve) => {
        new MutationObserver(resolve).observe(figure, { attributeFilter: ["aria-busy"] });
      });
    }
    return {
      picture: figure?.querySelector("svg")?.innerHTML,
      lines: [...element.querySelectorAll(".sample > pre [data-output]")].map((part) => part.textContent).join("\n"),
    };
  });

/**
 * Presses keys on a control until the picture and the lines differ from the first ones.
 *
 * @param {import("playwright-core").Locator} section
 * @param {import("playwright-core").Locator} control
 * @param {readonly string[]} keys
 */
async function changes(section, control, keys) {
  const before = await shownBy(section);
  await control.focus();
  for (const key of keys) {
    await section.page().keyboard.press(key);
    const now = await shownBy(section);
    if (now.picture !== before.picture && now.lines !== before.lines) return true;
  }
  return false;
}

/**
 * Whether one of the controls changes both. A few keys on each come first: many controls change the picture alone.
 *
 * @param {import("playwright-core").Locator} section
 * @param {readonly import("playwright-core").Locator[]} controls
 */
async function anyChanges(section, controls) {
  for (const keys of [KEYS.slice(0, FIRST_KEYS), KEYS.slice(FIRST_KEYS)]) {
    for (const control of controls) if (await changes(section, control, keys)) return true;
  }
  return false;
}

/** Hides all entries but one: a frame of a page with fifty pictures takes many times as long. */
const showOnly = (/** @type {import("playwright-core").Page} */ page, /** @type {string} */ name) =>
  page.evaluate((name) => {
    for (const entry of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll(".entry"))) {
      entry.hidden = entry.id !== name;
    }
  }, name);

for (const folder of entryFolders()) {
  const live = [...readEntries(folder)].filter(([, entry]) => entry.draw);
  test(`${folder}: every figure follows its inputs`, async (t) => {
    const page = await openPage(t, `/api/${folder}/`);
    const still = [];
    for (const [name, entry] of live) {
      const section = page.locator(`[id="${name}"]`);
      await showOnly(page, name);
      assert.ok(inputsOf(entry.js?.code ?? "").length > 0, `${entry.file}: expected an input`);
      const controls = section.locator("live-figure :is(button, input:not([data-turn]), select)");
      const followed = await anyChanges(section, await controls.all());
      if (!followed) still.push(name);
    }
    assert.deepEqual(still, [], "no input of these changes both the picture and the printed lines");
  });
}

test("a point follows the pointer, and the code shows where it is", async (t) => {
  const page = await openPage(t, "/api/curve/#nearest");
  const section = page.locator("#nearest");
  const handle = section.getByRole("button", { name: /^p \(/ });
  await handle.scrollIntoViewIfNeeded();
  const box = await handle.boundingBox();
  assert.ok(box);
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + 60, box.y + box.height / 2 + 20, { steps: 3 });
  await page.mouse.up();
  await page.waitForFunction(() => document.querySelector("#nearest [data-output]")?.textContent !== "0.5");
  const [x, y] = JSON.parse((await section.locator('[data-input="p"]').textContent()) ?? "");
  assert.ok(x > 1.2 && y < 2.95, `${x}, ${y}`);
  const t0 = Number(await section.locator("[data-output]").first().textContent());
  assert.ok(t0 > 0.5 && t0 < 1, String(t0));
});

test("the pages of the reference are readable without JavaScript", async (t) => {
  const plain = await openPage(t, "/api/curve/", { javaScriptEnabled: false });
  assert.ok(await plain.locator("#nearest svg path").first().isVisible());
  assert.match((await plain.locator("#nearest .sample > pre").textContent()) ?? "", /nearest\.distance\); \/\/ → 1\.5/);
});
