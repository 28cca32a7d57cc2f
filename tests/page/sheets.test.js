// A figure is one sheet with a row of controls, and its room is reserved before the scripts come.
import assert from "node:assert/strict";
import { test } from "node:test";
import { boxOf, openPage } from "./browser.js";
import { goTo, pageOf } from "./chapter-page.js";

test("the button for the full screen is in the row of the controls, or in the caption below other elements", async (t) => {
  const page = await openPage(t, pageOf("curves", "figure-de-casteljau"), {
    viewport: { width: 1280, height: 1000 },
    reducedMotion: "reduce",
    keep: true,
  });
  const figure = page.locator("#figure-de-casteljau");
  await figure.scrollIntoViewIfNeeded();
  const slider = await boxOf(figure.getByRole("slider", { name: "t", exact: true }));
  const button = await boxOf(figure.getByRole("button", { name: "Full screen" }));
  const middle = button.y + button.height / 2;
  assert.ok(middle > slider.y && middle < slider.y + slider.height, `${middle} beside ${slider.y}`);
  assert.ok(button.x >= slider.x + slider.width);
  await goTo(page, "figure-basis");
  const other = page.locator("#figure-basis");
  await other.scrollIntoViewIfNeeded();
  assert.equal(await other.locator("figcaption").getByRole("button", { name: "Full screen" }).count(), 1);
  const [sheet, matrix] = [await boxOf(other.locator(".sheet")), await boxOf(other.locator("basis-matrix table"))];
  assert.ok(matrix.x > sheet.x && matrix.y + matrix.height < sheet.y + sheet.height, "inside of the sheet");
});

/** Figures with different controls. */
const FIGURES = ["#figure-curve", "#figure-basis", "#figure-insert", "#figure-lengths"];
for (const width of [360, 1280]) {
  test(`at ${width} px figures are as tall before the scripts as afterwards`, async (t) => {
    const isPhone = width < 500;
    const options = { viewport: { width, height: 1000 }, hasTouch: isPhone, isMobile: isPhone };
    const plain = await openPage(t, "/curves/parameter/", { ...options, javaScriptEnabled: false });
    const page = await openPage(t, "/curves/parameter/", { ...options, reducedMotion: "reduce" });
    for (const id of FIGURES) {
      await plain.goto(pageOf("curves", id.slice(1)));
      await goTo(page, id.slice(1));
      const heightOf = (/** @type {import("playwright-core").Locator} */ sheet) =>
        sheet.evaluate(({ scrollHeight }) => scrollHeight); // a tall one beside a task scrolls
      const reserved = await heightOf(plain.locator(`${id} .sheet`));
      const figure = page.locator(`${id} .sheet`);
      await figure.scrollIntoViewIfNeeded();
      await figure
        .getByRole("button", { name: /Play|Halve|Split/ })
        .first()
        .waitFor();
      const height = await heightOf(figure);
      assert.ok(Math.abs(height - reserved) <= 4, `${id}: ${reserved} px reserved, ${height} px`);
    }
  });
}
