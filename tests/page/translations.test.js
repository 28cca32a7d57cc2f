// The texts of the elements in another language: no English text is left.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { frames, root } from "./browser.js";
import { openStrict, populate, settled } from "./embedding-page.js";

/** What is the same in every language: names of points, numbers, formulas, keys, formats, keywords of CSS. */
const UNTRANSLATED = [
  /^[A-Zabp]{1,2}\d*( [xyz])?$/,
  /^[A-Z]\d( [A-Z]\d)* …$|^[bp]\d( [bp]\d)* …$|^[bp]₀ [bp]₁ …$/,
  /^(cubic-bezier\(.*\)|ease(-in|-out|-in-out)?|linear)$/,
  /^(SVG|PNG|JSON|OBJ|STL|GLB|JavaScript|Rust|px|ms)$/,
  /^(Tab|Enter|Delete|Esc|Ctrl Z|Ctrl Y)$/,
];

/** The texts of an element, visible or read out. */
const textsOf = (page) =>
  page.evaluate(() => {
    const found = [];
    const visit = (node) => {
      if (node.nodeType === Node.TEXT_NODE) found.push(node.data.trim());
      if (node instanceof Element) {
        if (["STYLE", "PRE"].includes(node.tagName)) return;
        for (const name of ["aria-label", "title"]) found.push(node.getAttribute(name) ?? "");
      }
      for (const child of [...(node.shadowRoot?.childNodes ?? []), ...node.childNodes]) visit(child);
    };
    for (const element of all) visit(element);
    return [...new Set(found)];
  });

test("every text of the elements can be given in another language, and back", async (t) => {
  const page = await openStrict(t);
  await page.setViewportSize({ width: 800, height: 8000 }); // what is far from the view is drawn when it comes near
  await populate(page);
  await page.evaluate(() => {
    for (const element of all) if ("controls" in element) element.controls = true;
  });
  await page.evaluate(() => {
    const [applet, surface] = ["bezier-applet", "bezier-surface"].map((name) => document.querySelector(name));
    Object.assign(applet, {
      show: "polygon construction halves hull extrema inflections bounds ticks offset nearest tree",
    });
    Object.assign(surface, { model: "teapot", show: "surface casteljau ribbons", segments: 2 });
  });
  await settled(page);
  const table = JSON.parse(await readFile(`${root}dist/texts.json`, "utf8"));
  const marked = Object.fromEntries(Object.keys(table).map((text) => [text, `⟦${text}⟧`]));
  const give = (texts) =>
    page.evaluate(async (texts) => {
      (await import("/dist/elements.js")).setTranslations(texts);
      await Promise.all(all.map((element) => element.updateComplete));
    }, texts);
  /** The description of the curve follows after a pause. */
  const described = (isMarked) =>
    page.waitForFunction((isMarked) => {
      const { shadowRoot } = document.querySelector("bezier-applet");
      return shadowRoot.querySelector("#description").textContent.includes("⟦") === isMarked;
    }, isMarked);
  await give(marked);
  await described(true);
  await frames(page);
  const left = (await textsOf(page)).filter(
    (text) => /[A-Za-z]{2}/.test(text) && !/[⟦⟧]/.test(text) && !UNTRANSLATED.some((same) => same.test(text)),
  );
  assert.deepEqual(left, []);
  await give({});
  await described(false);
  await frames(page);
  const back = await textsOf(page);
  assert.ok(back.includes("Undo") && !back.some((text) => /[⟦⟧]/.test(text)), back.join("\n"));
});
