// Figures of the API reference: dragging a point, a slider or a choice changes the picture and what the sample prints.
// tests/js/api-figures.test.js shows for every figure that its sample depends on its inputs.
import assert from "node:assert/strict";
import { test } from "node:test";
import { entryFolders, readEntries } from "../../www/api/build/entries.js";
import { inputsOf } from "../../www/api/build/sample.js";
import { openPage } from "./browser.js";

/** Where the pointer goes while it drags a point, in pixels from its start; some figures need several for another result. */
const MOVES = "30,10 -30,25 10,-40 60,40 -70,-30 90,-60 -20,80 120,10 -120,40 0,-110"
  .split(" ")
  .map((move) => move.split(",").map(Number));

/** Keys that move a slider or make another choice. */
const KEYS = [..."uullddrrlluurrrrddddlllluuuu"].map(
  (letter) => ({ u: "ArrowUp", l: "ArrowLeft", d: "ArrowDown", r: "ArrowRight" })[letter] ?? "",
);

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
 * Drags a point with the pointer until the picture and the lines differ from the first ones.
 *
 * @param {import("playwright-core").Locator} section
 * @param {import("playwright-core").Locator} handle
 */
async function followsPointer(section, handle) {
  const { mouse } = section.page();
  const before = await shownBy(section);
  const box = await handle.boundingBox();
  assert.ok(box, "expected a visible point");
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await mouse.move(x, y);
  await mouse.down();
  try {
    for (const [dx, dy] of MOVES) {
      await mouse.move(x + dx, y + dy);
      if (differ(before, await shownBy(section))) return true;
    }
    return false;
  } finally {
    await mouse.up();
  }
}

/**
 * Presses keys on a control until the picture and the lines differ from the first ones.
 *
 * @param {import("playwright-core").Locator} section
 * @param {import("playwright-core").Locator} control
 */
async function followsKeys(section, control) {
  const before = await shownBy(section);
  await control.focus();
  for (const key of KEYS) {
    await section.page().keyboard.press(key);
    if (differ(before, await shownBy(section))) return true;
  }
  return false;
}

/** @typedef {Awaited<ReturnType<typeof shownBy>>} Shown */

/** @param {Shown} before @param {Shown} now */
const differ = (before, now) => now.picture !== before.picture && now.lines !== before.lines;

/**
 * Whether one of the inputs changes both: a point by dragging it, or a slider or choice by keys.
 *
 * @param {import("playwright-core").Locator} section
 */
async function anyChanges(section) {
  await section.locator("live-figure").scrollIntoViewIfNeeded();
  for (const handle of await section.locator("live-figure .handle").all()) {
    if (await followsPointer(section, handle)) return true;
  }
  for (const control of await section.locator("live-figure :is(input:not([data-turn]), select)").all()) {
    if (await followsKeys(section, control)) return true;
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
  /** The first figure with an input of one of these kinds. */
  const firstWith = (/** @type {string[]} */ ...kinds) =>
    live.find(([, entry]) => inputsOf(entry.js?.code ?? "").some(({ kind }) => kinds.includes(kind)))?.[0];
  const names = new Set([firstWith("point", "points"), firstWith("number"), firstWith("choice")]);
  test(`${folder}: figures follow a dragged point, a slider, a choice`, async (t) => {
    const page = await openPage(t, `/api/${folder}/`);
    for (const name of names) {
      if (!name) continue;
      await showOnly(page, name);
      assert.ok(await anyChanges(page.locator(`[id="${name}"]`)), name);
    }
  });
}

test("a point follows the pointer and arrow keys, and the code shows where it is", async (t) => {
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
  await page.keyboard.press("ArrowRight");
  const [right] = JSON.parse((await section.locator('[data-input="p"]').textContent()) ?? "");
  assert.ok(right > x, `${right} after ${x}`);
});

test("the pages of the reference are readable without JavaScript", async (t) => {
  const plain = await openPage(t, "/api/curve/", { javaScriptEnabled: false });
  assert.ok(await plain.locator("#nearest svg path").first().isVisible());
  assert.match((await plain.locator("#nearest .sample > pre").textContent()) ?? "", /nearest\.distance\); \/\/ → 1\.5/);
});
