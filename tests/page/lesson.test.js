// Samples and tasks: tabs by hand and by keyboard, code that runs, tasks that are predicted, judged live, revealed.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { assertAccessible, frames, openPage, root } from "./browser.js";
import { goTo, pageOf, sectionsOf } from "./chapter-page.js";
import { downloadBy } from "./gestures.js";

const read = (path) => readFileSync(`${root}www/${path}`, "utf8");
/** A page of the site that the parts are on, once for all tests; with `fresh`, once more with an empty storage. */
const open = (t, path, /** @type {import("./browser.js").PageOptions} */ { fresh = false, ...options } = {}) => {
  const viewport = { width: 1000, height: 900 };
  return openPage(t, path, { viewport, reducedMotion: "reduce", fresh, keep: !fresh, ...options });
};

test("a sample has two tabs: arrows, Home and End choose, and all samples follow", async (t) => {
  const page = await open(t, "/curves/parameter/");
  const sample = page.locator("lesson-sample").first();
  const [js, rust] = ["JavaScript", "Rust"].map((name) => sample.getByRole("tab", { name }));
  await js.focus();
  assert.match(await sample.getByRole("tabpanel", { name: "JavaScript" }).innerText(), /console\.log\(/);
  await page.keyboard.press("ArrowRight");
  assert.equal(await rust.getAttribute("aria-selected"), "true");
  assert.equal(await page.evaluate(() => /** @type {any} */ (document.activeElement).textContent), "Rust");
  assert.match(await sample.getByRole("tabpanel", { name: "Rust" }).innerText(), /println!\(/);
  assert.equal(await sample.getByRole("tabpanel").count(), 1);
  const others = page.locator("lesson-sample [role=tab][data-language=rs]");
  for (let i = 0; i < (await others.count()); i++)
    assert.equal(await others.nth(i).getAttribute("aria-selected"), "true");
  await page.keyboard.press("ArrowRight");
  assert.equal(await js.getAttribute("aria-selected"), "true", "around the end");
  await page.keyboard.press("End");
  assert.equal(await rust.getAttribute("aria-selected"), "true");
  await page.keyboard.press("Home");
  assert.equal(await js.getAttribute("aria-selected"), "true");
  await assertAccessible(page, { part: "lesson-sample" });
});

test("all samples of the chapters run in the browser as they do in Node", async (t) => {
  let count = 0;
  const page = await open(t, "/curves/parameter/");
  for (const { path } of [...sectionsOf("curves"), ...sectionsOf("surfaces")]) {
    await page.goto(path);
    await page.waitForFunction(() =>
      [...document.querySelectorAll("lesson-sample")].every((sample) => sample.querySelector(".bar")),
    );
    const outputs = await page.evaluate(() =>
      Promise.all(
        [...document.querySelectorAll("lesson-sample")].map(async (sample) => {
          await sample.run();
          return [sample.getAttribute("name"), sample.querySelector("output").textContent];
        }),
      ),
    );
    count += outputs.length;
    for (const [name, output] of outputs) assert.equal(output, read(`samples/${name}.txt`).trimEnd(), name);
  }
  assert.ok(count >= 36, `${count} samples`);
});

test("the code of a sample can be edited and run, what does not end is ended, and edits are undone", async (t) => {
  const page = await open(t, "/curves/de-casteljau/");
  const sample = page.locator("lesson-sample");
  const [code, output] = [sample.getByRole("textbox", { name: /JavaScript/ }), sample.locator("output")];
  const prints = (/** @type {string | RegExp} */ hasText) => output.filter({ hasText }).waitFor();
  const run = () => sample.getByRole("button", { name: "Run" }).click();
  const before = await code.innerText();
  const undo = sample.getByRole("button", { name: "Undo edits" });
  assert.equal(await undo.isVisible(), false);
  await code.focus();
  await page.keyboard.press("ControlOrMeta+End");
  await page.keyboard.type('\nconsole.log("starts at", new Curve(points).eval(0).x);');
  await run();
  await prints("starts at 0");
  const printed = read("samples/casteljau.txt").trimEnd();
  assert.equal(await output.textContent(), `${printed}\nstarts at 0`);
  await code.fill("nowhere();");
  await run();
  await prints("ReferenceError: nowhere is not defined");
  await code.fill("while (true);");
  await run();
  await prints("stopped after 5 seconds");
  await code.fill('import { Curve as C } from "casteljau/core";\nconsole.log(new C([[0, 0], [2, 0]]).length());');
  await run();
  await prints(/^2$/);
  await code.fill('import { readFile } from "fs";');
  await run();
  await prints(/expected casteljau, .* got fs/);
  await undo.click();
  assert.equal(await code.innerText(), before);
  await run();
  await prints(printed.split("\n")[0]);
  await assertAccessible(page, { part: "lesson-sample" });
});

/** A task with a prediction, about an applet. */
async function openTask(t, name) {
  const page = await open(t, "/curves/parameter/");
  await goTo(page, name);
  const task = page.locator(`lesson-task[name="${name}"]`);
  await task.scrollIntoViewIfNeeded();
  await task.locator("button").first().waitFor();
  const applet = page.locator(`#${await task.getAttribute("for")}`);
  return {
    page,
    task,
    applet,
    said: task.getByRole("status"),
    guess: (i) => task.locator(".answers").getByRole("button").nth(i).click(),
    press: (name) => task.getByRole("button", { name }).click(),
  };
}

test("a task is predicted, checked, and done as soon as the reader has it right", async (t) => {
  const { page, task, applet, said, press, guess } = await openTask(t, "time-ratio");
  assert.equal(await task.getByRole("button", { name: "Check" }).count(), 0, "first a prediction");
  await guess(0);
  assert.ok(await task.locator(".answers button").first().isDisabled());
  assert.equal(await task.locator(".answers [aria-pressed=true]").count(), 1);
  await press("Check");
  assert.match(await said.innerText(), /P4 is .* px from/);
  assert.equal(await task.getAttribute("data-state"), "open");
  await assertAccessible(page, { part: 'lesson-task[name="time-ratio"]' });

  const toSolution = (by, done = true) =>
    applet.evaluate(
      (/** @type {any} */ element, [by, done]) => {
        const [, , p2, p3] = element.points;
        element.edit({ index: 4, point: [3 * p3[0] - 2 * p2[0] + by, 3 * p3[1] - 2 * p2[1]] }, done);
      },
      /** @type {[number, boolean]} */ ([by, done]),
    );
  await toSolution(0, false);
  await frames(page);
  await toSolution(60);
  assert.equal(await task.getAttribute("data-state"), "open");
  await toSolution(0);
  await page.locator('lesson-task[name="time-ratio"][data-state="done"]').waitFor();
  assert.match(await said.innerText(), /You predicted: .*\. The answer is: /);
  assert.equal(await task.locator(".answers .right").count(), 1, "the answer is marked");
  await toSolution(60);
  await frames(page);
  assert.equal(await task.getAttribute("data-state"), "done", "done stays done");
  await press("Try again");
  assert.equal(await task.getAttribute("data-state"), "open");
  assert.equal(await task.locator(".words").textContent(), "");
  await guess(1);
  await toSolution(0);
  await said.getByText("You predicted it.").waitFor();
});

test("what was said before is replaced when something moves, also after the answer was shown", async (t) => {
  const { page, task, said, press, guess } = await openTask(t, "half-height");
  await guess(0);
  const slider = page.locator("#parabola input[type=range]").first();
  await press("Check");
  await slider.fill("0.3");
  await said.getByText("At t = 0.30 the height is 0.09.").waitFor();
  await press("Reveal");
  await slider.fill("0.4");
  await said.getByText("At t = 0.40 the height is 0.16.").waitFor();
  assert.equal(await task.getAttribute("data-state"), "revealed");
});

test("a refusal because something has moved has a button that puts it back, on a phone, too", async (t) => {
  const page = await open(t, "/curves/offsets/", {
    fresh: true,
    viewport: { width: 360, height: 740 },
    hasTouch: true,
    isMobile: true,
  });
  for (const [name, id, moved] of /** @type {const} */ ([
    ["offset-cusp", "offset", "80,400 250,60 420,20 590,400"],
    ["enough-pieces", "recursion", "60,300 60,60 620,20 600,300"],
  ])) {
    await goTo(page, name);
    const task = page.locator(`lesson-task[name="${name}"]`);
    await task.scrollIntoViewIfNeeded();
    await task.locator(".answers button").first().tap();
    const back = task.getByRole("button", { name: "Put it back" });
    assert.equal(await back.isVisible(), false);
    const applet = page.locator(`#${id}`);
    const before = await applet.evaluate((/** @type {any} */ element) => String(element.points));
    await applet.evaluate((/** @type {any} */ element, points) => {
      element.points = points;
      element.dispatchEvent(new Event("change", { bubbles: true }));
    }, moved);
    await task.getByText("these have moved").waitFor();
    await back.tap();
    assert.equal(await applet.evaluate((/** @type {any} */ element) => String(element.points)), before);
    await back.waitFor({ state: "hidden" });
  }
});

test("numbers are typed: a wrong one gets a hint, the right one counts", async (t) => {
  const page = await open(t, pageOf("surfaces", "vertices-16"), { fresh: true });
  const task = page.locator('lesson-task[name="vertices-16"]');
  await task.scrollIntoViewIfNeeded();
  const [field, said] = [task.getByRole("textbox", { name: "Your answer" }), task.getByRole("status")];
  await task.getByRole("button", { name: "Check" }).click();
  assert.equal(await said.innerText(), "Type a number first.");
  for (const [typed, words] of /** @type {const} */ ([
    ["8192", /has more than sixteen vertices/],
    ["7", /not the answer yet/],
    ["many", /Type a number/],
  ])) {
    await field.fill(typed);
    await field.press("Enter");
    assert.match(await said.innerText(), words);
    assert.equal(await task.getAttribute("data-state"), "open");
  }
  await assertAccessible(page, { part: 'lesson-task[name="vertices-16"]' });
  await field.fill("9,248");
  await field.press("Enter");
  assert.equal(await task.getAttribute("data-state"), "done");
  await goTo(page, "next-values");
  const three = page.locator('lesson-task[name="next-values"]');
  await three.getByRole("textbox", { name: "Your answer, 3 numbers" }).fill("4, 7, 10");
  await three.getByRole("button", { name: "Check" }).click();
  assert.match(await three.getByRole("status").innerText(), /first difference changes/);
  await three.getByRole("button", { name: "Reveal" }).click();
  assert.equal(await three.getByRole("textbox").inputValue(), "4, 11, 28");
  assert.equal(await three.getAttribute("data-state"), "revealed");
});

test("a question with a wrong answer is not done, says which answer is right, and can be tried again", async (t) => {
  const page = await open(t, pageOf("surfaces", "rows-on-surface"));
  for (const [guess, state, words] of /** @type {[number, string, RegExp][]} */ ([
    [0, "wrong", /You predicted: .*\. The answer is: two/],
    [1, "done", /^Right\. /], // the answer was shown: this is no prediction
  ])) {
    const task = page.locator('lesson-task[name="rows-on-surface"]');
    await task.scrollIntoViewIfNeeded();
    if (state === "done") await task.getByRole("button", { name: "Try again" }).click();
    await task.locator(".answers button").nth(guess).click();
    assert.equal(await task.getAttribute("data-state"), state);
    assert.match(await task.getByRole("status").innerText(), words);
  }
});

test("a solved task is solved on the next visit, too, until it is reset; progress can be exported", async (t) => {
  const path = pageOf("curves", "safe-powers");
  const page = await open(t, path, { fresh: true });
  const [task, progress] = [page.locator('lesson-task[name="safe-powers"]'), page.locator("lesson-progress")];
  const solved = (count) => progress.getByText(`${count} of`, { exact: false }).waitFor();
  await solved(0);
  await task.scrollIntoViewIfNeeded();
  await task.locator(".answers button").nth(1).click();
  await solved(1);

  await page.reload();
  await solved(1);
  assert.equal(await page.locator(".sections li.solved").count(), 1);
  assert.equal(await task.getAttribute("data-state"), "done");
  assert.match(await task.getByRole("status").innerText(), /solved this task before/);
  await page.goto("/curves/");
  await solved(1);
  assert.match(await progress.innerText(), /^About \d[\d½]* (minutes|hours?) with the tasks/);
  const { name, bytes } = await downloadBy(progress.getByRole("button", { name: "Export" }));
  assert.equal(name, "casteljau-progress.json");
  const { format, solved: days } = JSON.parse(bytes.toString());
  assert.equal(format, "casteljau-progress");
  assert.deepEqual(Object.keys(days), ["curves/safe-powers"]);

  page.once("dialog", (dialog) => dialog.dismiss());
  await progress.getByRole("button", { name: "Reset" }).click();
  await solved(1);
  page.once("dialog", (dialog) => dialog.accept());
  await progress.getByRole("button", { name: "Reset" }).click();
  await solved(0);
  await page.goto(path);
  await solved(0);
  await task.locator(".answers button:enabled").first().waitFor(); // the question is asked again
});

test("without storage tasks work, and progress lasts as long as the page", async (t) => {
  const page = await open(t, "about:blank", { fresh: true });
  await page.addInitScript(() =>
    Object.defineProperty(window, "localStorage", {
      get() {
        throw new DOMException("denied", "SecurityError");
      },
    }),
  );
  await page.goto(pageOf("curves", "safe-powers"));
  const task = page.locator('lesson-task[name="safe-powers"]');
  await task.scrollIntoViewIfNeeded();
  await task.locator(".answers button").nth(1).click();
  await page.locator("lesson-progress").getByText("1 of", { exact: false }).waitFor();
});

test("all tasks of a chapter are on one page, and their answers where one asks for them", async (t) => {
  for (const chapter of /** @type {const} */ (["curves", "surfaces"])) {
    const page = await open(t, `/${chapter}/tasks/`, { fresh: true });
    const names = sectionsOf(chapter).flatMap(({ tasks }) => tasks);
    await page.locator("#answers:enabled").waitFor();
    const questions = page.locator("[data-task]");
    assert.deepEqual(await questions.evaluateAll((all) => all.map(({ dataset }) => dataset.task)), names);
    assert.equal(await page.locator(".answer:visible").count(), 0);
    await page.getByRole("checkbox", { name: "Show the answers" }).check();
    assert.equal(await page.locator(".answer:visible").count(), names.length);
    const [first] = names;
    await questions
      .first()
      .getByRole("link", { name: /^Task \d\.1$/ })
      .click();
    await page.waitForURL((url) => url.pathname === pageOf(chapter, first) && url.hash === `#task-${first}`);
  }
});

test("a section leads to its neighbours, and a chapter to the next one", async (t) => {
  const page = await open(t, "/curves/parameter/");
  await page.goto("/curves/");
  await page.getByRole("link", { name: /^Begin:/ }).click();
  const sections = sectionsOf("curves").map(({ path }) => path);
  await page.waitForURL((url) => url.pathname === sections[0]);
  assert.equal(await page.locator("[rel=prev]").count(), 0);
  await page.locator(".turn [rel=next]").click();
  await page.waitForURL((url) => url.pathname === sections[1]);
  await page.locator(".turn [rel=prev]").click();
  await page.waitForURL((url) => url.pathname === sections[0]);
  await page.locator(".sections summary").click();
  await page.locator(".sections li").last().getByRole("link").click();
  await page.waitForURL((url) => url.pathname === sections.at(-1));
  assert.equal(await page.locator("[rel=next]").count(), 0);
  await page.getByRole("link", { name: /Next chapter: Bézier surfaces/ }).click();
  await page.waitForURL(/\/surfaces\/$/);
});
