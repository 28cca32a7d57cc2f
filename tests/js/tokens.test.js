// The colours of the elements and of the site are the same, and contrast enough with what is behind them.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { DARK, LIGHT } from "#js/ui/tokens.js";

const css = readFileSync(new URL("../../www/base.css", import.meta.url), "utf8");
const colours = (/** @type {string} */ text) =>
  Object.fromEntries(Array.from(text.matchAll(/--([\w-]+): (#[0-9a-f]{6});/g), ([, name, value]) => [name, value]));
const [, light, dark] = /:root \{(.*?)\n\}.*?prefers-color-scheme: dark\) \{(.*?)\n\}/s.exec(css) ?? [];
const THEMES = /** @type {const} */ ([
  ["light", colours(LIGHT), colours(light)],
  ["dark", colours(DARK), colours(dark)],
]);
/** Names of a colour in the elements and on the site. */
const SAME = Object.entries({
  "bz-ink": "ink",
  "bz-quiet": "quiet",
  "bz-paper": "stage",
  "bz-panel": "stage",
  "bz-raised": "raised",
  "bz-rim": "rim",
  "bz-field": "field",
  "bz-curve": "curve",
  "bz-handle": "handle",
  "bz-level1": "level1",
  "bz-level2": "level2",
  "bz-accent": "accent",
  "bz-on-accent": "on-accent",
  "bz-smooth-ink": "good",
});
const TEXT = ["bz-ink", "bz-quiet", "bz-accent", "bz-broken-ink", "bz-smooth-ink"];
const MARKS = ["bz-field", "bz-curve", "bz-handle", "bz-first", "bz-second", "bz-level1", "bz-level2"];

/** The relative luminance of WCAG. @param {string} hex */
function luminance(hex) {
  const [r, g, b] = [1, 3, 5].map((i) => {
    const x = Number.parseInt(hex.slice(i, i + 2), 16) / 255;
    return x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4;
  });
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

/** @param {string} a @param {string} b */
function contrast(a, b) {
  const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y);
  return (high + 0.05) / (low + 0.05);
}

for (const [theme, elements, site] of THEMES) {
  test(`${theme}: elements and site have the same colours`, () => {
    for (const [own, other] of SAME) assert.equal(elements[own], site[other], `${own} and ${other}`);
  });

  test(`${theme}: text has a contrast of 4.5, marks have 3`, () => {
    for (const ground of ["bz-paper", "bz-raised"]) {
      for (const name of TEXT)
        assert.ok(contrast(elements[name], elements[ground]) >= 4.5, `${name} on ${ground}: ${elements[name]}`);
      for (const name of MARKS)
        assert.ok(contrast(elements[name], elements[ground]) >= 3, `${name} on ${ground}: ${elements[name]}`);
    }
    assert.ok(contrast(elements["bz-on-accent"], elements["bz-accent"]) >= 4.5);
  });
}
