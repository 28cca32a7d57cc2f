// The playground of /elements/: a control for each attribute, the live element, and its tag as code.
import assert from "node:assert/strict";
import { test } from "node:test";
import { controlOf, tagText } from "../../www/elements/controls.js";
import { dragBy } from "./gestures.js";
import { frames, openPage } from "./browser.js";
import { openStrict } from "./site-pages.js";

test("the control of an attribute follows from its row in the table", () => {
  assert.deepEqual(controlOf("t", "0 … 1, 0.5", ""), { kind: "number", min: 0, max: 1, step: 0.01, initial: 0.5 });
  assert.deepEqual(controlOf("segments", "1 … 64, 12", ""), { kind: "number", min: 1, max: 64, step: 1, initial: 12 });
  assert.deepEqual(controlOf("theme", "auto, light, dark", ""), { kind: "choice", options: ["auto", "light", "dark"] });
  assert.deepEqual(controlOf("joints", "words: free g1", "continuity"), { kind: "words", options: ["free", "g1"] });
  const show = controlOf("show", "words, polygon", "layers: polygon hull. Without names, …");
  assert.deepEqual(show, { kind: "words", options: ["polygon", "hull"] });
  assert.deepEqual(controlOf("auto-rotate", "boolean", ""), { kind: "flag" });
  assert.deepEqual(controlOf("points", "“x,y x,y …”", ""), { kind: "text" });
});

test("a tag is code that can be pasted", () => {
  assert.equal(
    tagText("bezier-applet", [
      ["t", "0.4"],
      ["readonly", ""],
    ]),
    '<bezier-applet t="0.4" readonly></bezier-applet>',
  );
  assert.match(tagText("bezier-applet", [["label", '"<&']]), /label="&quot;<&amp;"/);
  const long = tagText("bezier-applet", [
    ["points", "60,360 160,60 500,60 600,360"],
    ["show", "polygon construction"],
  ]);
  assert.equal(long.split("\n").length, 4);
});

/** Opens the page with the playground in sight. */
async function open(t) {
  const page = await openStrict(t, "/elements/", { viewport: { width: 1280, height: 900 }, reducedMotion: "reduce" });
  await page.locator("#playground").scrollIntoViewIfNeeded();
  const box = page.locator(".playground");
  await box.locator("form [data-attribute]").first().waitFor();
  const code = async () => {
    await frames(page); // an applet reports a change when it is drawn
    return box.locator("code").innerText();
  };
  const choose = (name) => box.getByRole("radio", { name, exact: true }).check();
  return { page, box, code, choose };
}

test("every element has a control for each of its attributes, and its tag is the code", async (t) => {
  const { page, box, code, choose } = await open(t);
  for (const name of ["applet", "surface", "bernstein", "equation", "coordinates", "easing"]) {
    await choose(name);
    const element = box.locator(`bezier-${name}`);
    assert.equal(await element.count(), 1);
    const observed = await page.evaluate(async (tag) => {
      const type = /** @type {any} */ (await customElements.whenDefined(tag));
      return [...type.observedAttributes];
    }, `bezier-${name}`);
    const controls = await box
      .locator("[data-attribute]")
      .evaluateAll((all) => all.map(({ dataset }) => dataset.attribute));
    assert.deepEqual(controls.sort(), observed.sort(), name);
    assert.ok((await code()).startsWith(`<bezier-${name}`));
    assert.doesNotMatch(await code(), /theme|label|evaluation/, "attributes that have their default are left out");
  }
});

test("a control changes the element and the code; what is dragged in the picture is written into it", async (t) => {
  const { box, code } = await open(t);
  const applet = box.locator("bezier-applet");
  await box.getByRole("checkbox", { name: "comb", exact: true }).check();
  assert.match(await code(), /show="polygon construction comb"/);
  assert.equal(await applet.getAttribute("show"), "polygon construction comb");
  await box.getByRole("combobox", { name: "basis" }).selectOption("b-spline");
  assert.match(await code(), /basis="b-spline"/);
  await box.getByRole("combobox", { name: "basis" }).selectOption("");
  assert.doesNotMatch(await code(), /basis/);
  assert.doesNotMatch(await code(), /points/);
  await dragBy(box.page(), applet.locator('[part="handle"][data-index="1"]'), 20, 10);
  assert.match(await code(), /points="\d/);
  await applet.getByRole("slider", { name: "t", exact: true }).fill("0.7");
  assert.match(await code(), /\bt="0\.7"/);
  assert.equal(await box.locator('[data-attribute="t"] input').inputValue(), "0.7");
});

test("a companion is linked to an applet with one checkbox", async (t) => {
  const { box, code, choose } = await open(t);
  await choose("bernstein");
  await box.getByRole("checkbox", { name: "for", exact: true }).check();
  assert.match(await code(), /^<bezier-applet.*id="my-curve".*<bezier-bernstein.*for="my-curve"/s);
  await box.locator("bezier-applet").getByRole("slider", { name: "t", exact: true }).fill("0.9");
  assert.match(await code(), /t="0\.9"/);
  await box.getByRole("checkbox", { name: "for", exact: true }).uncheck();
  assert.doesNotMatch(await code(), /bezier-applet|for=/);
});

test("without scripts the playground is a picture and its tag", async (t) => {
  const page = await openPage(t, "/elements/", { javaScriptEnabled: false });
  assert.ok(await page.locator(".playground svg path").first().isVisible());
  assert.match(await page.locator(".playground code").innerText(), /^<bezier-applet .*><\/bezier-applet>$/);
  assert.equal(await page.locator(".playground form").isVisible(), false);
});
