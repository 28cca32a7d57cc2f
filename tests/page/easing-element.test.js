// <bezier-easing>: an editor of timing functions that is a field of a form.
import assert from "node:assert/strict";
import { test } from "node:test";
import { assertAccessibleInBothThemes, boxOf, QUIET_FRAMES } from "./browser.js";
import { heard, on, openCompanions, paste, settled, shown, text } from "./companions-page.js";
import { centreOf, fingersOn, pullFrom } from "./gestures.js";

const EASE = "cubic-bezier(0.25, 0.1, 0.25, 1)";
const value = (page) => on(page, "bezier-easing", (element) => element.value);
const numbers = async (page) => (await value(page)).match(/-?[\d.]+/g).map(Number);
/** The middle of a handle. */
const centre = (page, index) => centreOf(page.locator(`bezier-easing .handle[data-index="${index}"]`));

const TWO =
  '<bezier-easing name="a" label="Way in"></bezier-easing><bezier-easing label="Way out" required></bezier-easing>';

test("it is accessible, light and dark", async (t) => {
  await assertAccessibleInBothThemes(await openCompanions(t, TWO), settled);
});

for (const [options, least] of /** @type {[object, number][]} */ ([
  [{}, 24],
  [{ viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true }, 44],
])) {
  test(`it fits its page, and handles are ${least} pixels large at least`, async (t) => {
    const page = await openCompanions(t, TWO, options);
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)) <= 0);
    const box = await boxOf(page.locator("bezier-easing .handle").first());
    assert.ok(box.width >= least && box.height >= least);
  });
}

test("a handle is dragged: x stays within 0 and 1, y may leave the square; input while it moves, one change", async (t) => {
  const page = await openCompanions(t, "<bezier-easing></bezier-easing>");
  const [x, y] = await centre(page, 0);
  await pullFrom(page, [x + 3, y + 3], 37, -63, 3);
  assert.notEqual(await value(page), EASE);
  await page.mouse.move(x - 400, y - 255, { steps: 3 });
  await page.mouse.up();
  const [x1, y1, x2, y2] = await numbers(page);
  assert.deepEqual([x1, x2, y2], [0, 0.25, 1]);
  assert.ok(y1 > 1, `${y1} overshoots`);
  const events = await heard(page);
  assert.equal(events.filter((event) => event === "change bezier-easing").length, 1);
  assert.ok(events.filter((event) => event === "input bezier-easing").length >= 2);
  await settled(page);
  const inside = await page.evaluate(() => {
    const { shadowRoot } = document.querySelector("bezier-easing");
    const [stage, handle] = [".stage", ".handle"].map((selector) =>
      shadowRoot.querySelector(selector).getBoundingClientRect(),
    );
    return handle.top + handle.height / 2 > stage.top;
  });
  assert.ok(inside, "the picture makes room for it");
});

test("Escape takes a drag back", async (t) => {
  const page = await openCompanions(t, "<bezier-easing></bezier-easing>");
  const place = await centre(page, 1);
  await pullFrom(page, place, 50, 50);
  assert.notEqual(await value(page), EASE);
  await page.keyboard.press("Escape");
  assert.equal(await value(page), EASE);
  await page.mouse.move(place[0] + 80, place[1] + 50);
  await page.mouse.up();
  assert.equal(await value(page), EASE);
});

test("two fingers move both handles", async (t) => {
  const page = await openCompanions(t, "<bezier-easing></bezier-easing>", { hasTouch: true });
  const touch = await fingersOn(page);
  const [[ax, ay], [bx, by]] = [await centre(page, 0), await centre(page, 1)];
  await touch("touchStart", [ax, ay], [bx, by]);
  await touch("touchMove", [ax + 30, ay - 30], [bx + 30, by + 30]);
  await touch("touchEnd");
  const [x1, y1, x2, y2] = await numbers(page);
  assert.ok(x1 > 0.3 && y1 > 0.15 && x2 > 0.3 && y2 < 0.95, `${[x1, y1, x2, y2]}`);
});

test("by the keyboard alone: handles, numbers, presets", async (t) => {
  const page = await openCompanions(t, "<bezier-easing></bezier-easing>");
  await page.getByRole("slider", { name: "First handle x" }).focus();
  for (const key of ["ArrowRight", "Shift+ArrowUp", "Alt+ArrowLeft"]) await page.keyboard.press(key);
  assert.equal(await value(page), "cubic-bezier(0.259, 0.2, 0.25, 1)");
  assert.equal((await heard(page)).filter((event) => event === "change bezier-easing").length, 3);
  for (let i = 0; i < 4; i++) await page.keyboard.press("Shift+ArrowLeft");
  assert.equal(await value(page), "cubic-bezier(0, 0.2, 0.25, 1)", "no farther than 0");
  await page.keyboard.press("Tab");
  assert.equal(
    await page.evaluate(() =>
      /** @type {any} */ (document.activeElement).shadowRoot.activeElement.getAttribute("aria-label"),
    ),
    "Second handle x",
  );
  await page.keyboard.press("Tab");
  await page.keyboard.type("linear");
  await settled(page);
  assert.equal(await value(page), "cubic-bezier(0, 0, 1, 1)");
  await page.getByRole("spinbutton", { name: "y2" }).fill("-2.5");
  await page.keyboard.press("Enter");
  assert.equal(await value(page), "cubic-bezier(0, 0, 1, -2.5)");
  await settled(page);
  assert.equal(await page.getByLabel("Preset").inputValue(), "");
});

test("numbers that are none, or out of range, are refused at their field", async (t) => {
  const page = await openCompanions(t, "<bezier-easing></bezier-easing>");
  const field = page.getByRole("spinbutton", { name: "x1" });
  await field.fill("1.2");
  await page.keyboard.press("Tab");
  assert.match(await text(page, "bezier-easing .error"), /x1: expected a number from 0 to 1, got 1\.2/);
  assert.deepEqual([await value(page), await field.inputValue()], [EASE, "0.25"]);
  await field.fill("");
  await page.keyboard.press("Tab");
  assert.match(await text(page, "bezier-easing .error"), /got nothing; 0\.25 is kept/);
  await paste(field, "fast");
  assert.match(await text(page, "bezier-easing .error"), /got “fast”/);
  await paste(field, "cubic-bezier(.1, .2, .3, .4)");
  assert.equal(await value(page), "cubic-bezier(0.1, 0.2, 0.3, 0.4)");
});

test("any text as value: what is good is taken, the rest is said and changes nothing", async (t) => {
  const page = await openCompanions(t, '<bezier-easing value="ease-in"></bezier-easing>');
  assert.equal(await value(page), "cubic-bezier(0.42, 0, 1, 1)");
  const set = (text) =>
    on(page, "bezier-easing", (element, text) => Object.assign(element, { value: text }).value, text);
  assert.equal(await set("CUBIC-BEZIER(0,2,1,-1)"), "cubic-bezier(0, 2, 1, -1)");
  for (const bad of ["steps(4)", "cubic-bezier(0, 1e999, 0, 0)", `cubic-bezier(${"1,".repeat(1e5)}1)`]) {
    assert.equal(await set(bad), "cubic-bezier(0, 2, 1, -1)");
    await settled(page);
    const message = await text(page, "bezier-easing .message");
    assert.match(message, /^value: .*expected .* is kept\.$/);
    assert.ok(message.length < 200);
  }
  await set("linear");
  await settled(page);
  assert.equal(await text(page, "bezier-easing .message"), "");
  assert.deepEqual(await heard(page), [], "what the page writes is no event");
});

const FORM = `<form><label>Motion <bezier-easing name="motion" value="ease-out"></bezier-easing></label><fieldset><bezier-easing name="other" required></bezier-easing></fieldset></form>`;
const data = (page) => page.evaluate(() => [...new FormData(document.forms[0])].map((pair) => pair.join("=")));

test("in a form: value, name, reset, required, validity, label, fieldset", async (t) => {
  const page = await openCompanions(t, FORM);
  const first = page.locator("bezier-easing").first();
  assert.deepEqual(await data(page), ["motion=cubic-bezier(0, 0, 0.58, 1)", "other="]);
  assert.equal(await page.evaluate(() => document.forms[0].checkValidity()), false);
  const state = (which) =>
    page.evaluate((which) => {
      const { validity, validationMessage, willValidate, form } = document.querySelectorAll("bezier-easing")[which];
      return [validity.valid, validity.valueMissing, validationMessage, willValidate, form === document.forms[0]];
    }, which);
  assert.deepEqual(await state(0), [true, false, "", true, true]);
  assert.deepEqual(await state(1), [false, true, "Choose an easing.", true, true]);
  assert.equal(await page.locator("bezier-easing:invalid").count(), 1);
  await page.getByLabel("Preset").nth(1).selectOption("ease-in-out");
  assert.deepEqual(await data(page), ["motion=cubic-bezier(0, 0, 0.58, 1)", "other=cubic-bezier(0.42, 0, 0.58, 1)"]);
  assert.equal(await page.evaluate(() => document.forms[0].checkValidity()), true);
  assert.ok(await first.getByRole("group", { name: "Motion" }).isVisible(), "its label names it");
  await on(page, "bezier-easing >> nth=0", (element) => (element.value = "linear"));
  await page.evaluate(() => document.forms[0].reset());
  assert.deepEqual(await data(page), ["motion=cubic-bezier(0, 0, 0.58, 1)", "other="]);
  await on(page, "bezier-easing >> nth=0", (element) => element.setAttribute("value", "ease-in"));
  assert.equal((await data(page))[0], "motion=cubic-bezier(0.42, 0, 1, 1)", "after a reset the attribute counts again");
  await on(page, "bezier-easing >> nth=0", (element) => element.setAttribute("value", "ease-out"));
  await page.evaluate(() => (document.querySelector("fieldset").disabled = true));
  await settled(page);
  assert.deepEqual(await data(page), ["motion=cubic-bezier(0, 0, 0.58, 1)"]);
  assert.ok(await page.getByRole("spinbutton", { name: "x1" }).nth(1).isDisabled());
  await on(page, "bezier-easing >> nth=0", (element) => element.setCustomValidity("Not this one."));
  assert.deepEqual((await state(0)).slice(0, 3), [false, false, "Not this one."]);
});

test("its form can be named by an id, as frameworks set a property", async (t) => {
  const page = await openCompanions(t, '<form id="f"></form><bezier-easing></bezier-easing>');
  const forms = await on(page, "bezier-easing", (element) =>
    ["f", undefined].map((form) => Object.assign(element, { form }).form?.id ?? null),
  );
  assert.deepEqual(forms, ["f", null]);
});

test("a click on its label goes into it; what is missing is shown and focused when the form is sent", async (t) => {
  const page = await openCompanions(t, FORM);
  await page.getByText("Motion").click({ position: { x: 3, y: 3 } });
  assert.equal(await page.evaluate(() => /** @type {any} */ (document.activeElement).getAttribute("name")), "motion");
  await page.evaluate(() => document.forms[0].requestSubmit());
  await page.waitForFunction(() => /** @type {any} */ (document.activeElement).getAttribute("name") === "other");
});

test("the browser gives back what was chosen", async (t) => {
  const page = await openCompanions(t, FORM);
  await on(page, "bezier-easing >> nth=0", (element) =>
    element.formStateRestoreCallback("cubic-bezier(0.1, 0.2, 0.3, 0.4)", "restore"),
  );
  assert.equal((await data(page))[0], "motion=cubic-bezier(0.1, 0.2, 0.3, 0.4)");
});

test("the attribute is what it begins with: it counts until the user or the page has chosen", async (t) => {
  const page = await openCompanions(t, "<bezier-easing></bezier-easing>", {
    script: 'document.querySelector("bezier-easing").value = "linear";',
  });
  assert.equal(await value(page), "cubic-bezier(0, 0, 1, 1)", "written before it was defined");
  await on(page, "bezier-easing", (element) => element.setAttribute("value", "ease-in"));
  assert.deepEqual(await on(page, "bezier-easing", ({ value, defaultValue }) => [value, defaultValue]), [
    "cubic-bezier(0, 0, 1, 1)",
    "ease-in",
  ]);
});

test("the ball moves as the easing has it: at once after a change, or by the button", async (t) => {
  const page = await openCompanions(t, '<bezier-easing value="linear"></bezier-easing>', {
    reducedMotion: "no-preference",
  });
  const left = () =>
    on(page, "bezier-easing", ({ shadowRoot }) =>
      parseFloat(shadowRoot.querySelector(".ball").style.insetInlineStart || "20"),
    );
  assert.equal(await left(), 20);
  await page.getByLabel("Preset").selectOption("ease");
  await page.waitForFunction(
    () =>
      parseFloat(document.querySelector("bezier-easing").shadowRoot.querySelector(".ball").style.insetInlineStart) ===
      80,
  );
});

test("for those who want less motion nothing moves before they ask", async (t) => {
  const page = await openCompanions(t, "<bezier-easing></bezier-easing>");
  await page.evaluate(() => {
    globalThis.frameCount = 0;
    globalThis.original = requestAnimationFrame;
    globalThis.requestAnimationFrame = (act) => {
      globalThis.frameCount++;
      return original(act);
    };
  });
  await page.getByLabel("Preset").selectOption("linear");
  assert.equal(await page.evaluate(() => globalThis.frameCount), 0);
  await page.getByRole("button", { name: "Play" }).click();
  await page.waitForFunction(() => globalThis.frameCount > 2);
  const more = await on(
    page,
    "bezier-easing",
    async (element, quiet) => {
      element.remove();
      const before = globalThis.frameCount;
      for (let i = 0; i < quiet; i++) await new Promise((resolve) => original(resolve));
      return globalThis.frameCount - before;
    },
    QUIET_FRAMES,
  );
  assert.equal(more, 0);
});

test("far down the page, a field that is missing is found when the form is sent", async (t) => {
  const page = await openCompanions(t, "<p></p>", { viewport: { width: 600, height: 400 } });
  await page.evaluate(() =>
    document
      .querySelector("main")
      .insertAdjacentHTML(
        "beforeend",
        '<form><div style="height: 3000px"></div><bezier-easing name="far" required></bezier-easing></form>',
      ),
  );
  assert.deepEqual(await data(page), ["far="]);
  assert.equal(await page.evaluate(() => document.forms[0].reportValidity()), false);
  await shown(page);
  page.problems.length = 0; // Chromium says that it could not put the focus there yet
});

test("a form reads what was set at once, also far below what is seen", async (t) => {
  const page = await openCompanions(t, "<p>above</p>");
  const read = (top) =>
    page.evaluate(async (top) => {
      const form = document.createElement("form");
      form.innerHTML = `<fieldset style="margin-top: ${top}px"><bezier-easing></bezier-easing></fieldset>`;
      document.querySelector("main").append(form);
      const [easing] = /** @type {any} */ (form.querySelectorAll("bezier-easing"));
      const inForm = () => [...new FormData(form)].map(String);
      const answers = [inForm()];
      easing.name = "x";
      answers.push(inForm());
      easing.required = true;
      answers.push([form.checkValidity(), easing.getAttribute("required")]);
      easing.value = "linear";
      easing.disabled = true;
      answers.push(inForm(), [easing.matches(":disabled")]);
      easing.disabled = false;
      easing.name = "y";
      easing.label = "Way in";
      await easing.updateComplete;
      answers.push(inForm(), [easing.outerHTML]);
      form.remove();
      return answers;
    }, top);
  const expected = [
    [],
    [`x,${EASE}`],
    [false, ""],
    [],
    [true],
    ["y,cubic-bezier(0, 0, 1, 1)"],
    ['<bezier-easing name="y" required="" label="Way in"></bezier-easing>'],
  ];
  assert.deepEqual(await read(0), expected);
  assert.deepEqual(await read(20_000), expected);
});
