// easing() reads and evaluates the texts that Chromium reads, as Chromium does.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { easing } from "casteljau/easing";
import { openPage } from "./browser.js";

const table = JSON.parse(readFileSync(new URL("../texts/easing.json", import.meta.url), "utf8"));

/** Chromium closes parentheses at the end of a text, ends comments there, and reduces numbers that are too large. */
const LENIENT = ["cubic-bezier(0,0,1,1", "ease /*", "cubic-bezier(0,1e999,1,1)", "steps(2147483648)"];
/** Chromium keeps these numbers as 32-bit floats, or not at all. */
const OUT_OF_RANGE = /1\.7e308|2147483647/;

/** For each text: the progress of an animation at some parts of its duration, or null where the text is refused. */
const progressInPage = ([texts, xs]) =>
  texts.map((easing) => {
    try {
      const animation = document.body.animate([{ opacity: 0 }, { opacity: 1 }], {
        duration: 1000,
        easing,
        fill: "both",
      });
      animation.pause();
      return xs.map((x) => {
        animation.currentTime = 1000 * x;
        return animation.effect.getComputedTiming().progress;
      });
    } catch {
      return null;
    }
  });

test("the same outputs and the same refusals as Chromium", async (t) => {
  const page = await openPage(t, "about:blank");
  const xs = [0, 0.01, 0.09, 0.2, 0.31, 0.5, 0.62, 0.75, 0.9, 0.99, 1];
  const texts = table.map((row) => row.text).filter((text) => !LENIENT.includes(text) && !OUT_OF_RANGE.test(text));
  const progress = await page.evaluate(progressInPage, [texts, xs]);
  texts.forEach((text, i) => {
    const isRead = table.find((row) => row.text === text).css !== undefined;
    assert.equal(progress[i] !== null, isRead, text);
    if (!isRead) return;
    const ease = easing(text);
    xs.forEach((x, k) => assert.ok(Math.abs(ease(x) - progress[i][k]) < 1e-5, `${text} at ${x}: ${progress[i][k]}`));
  });
});

test("what toLinear writes is accepted by Chromium, and is near", async (t) => {
  const page = await openPage(t, "about:blank");
  const xs = Array.from({ length: 101 }, (_, k) => k / 100);
  const curves = ["ease", "cubic-bezier(0.68, -0.55, 0.265, 1.55)", "cubic-bezier(0, 1, 1, 0)", "steps(3, jump-both)"];
  const texts = curves.flatMap((css) => [0.1, 0.01, 0.001].map((tolerance) => easing(css).toLinear(tolerance)));
  const progress = await page.evaluate(progressInPage, [texts, xs]);
  texts.forEach((text, i) => {
    const [ease, tolerance] = [easing(curves[Math.floor(i / 3)]), [0.1, 0.01, 0.001][i % 3]];
    xs.forEach((x, k) => assert.ok(Math.abs(ease(x) - progress[i][k]) < tolerance + 1e-5, `${text} at ${x}`));
  });
});
