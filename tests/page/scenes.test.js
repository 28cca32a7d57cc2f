// The sections as scenes: the question, the figure and what is said about the answer are on the screen at once, for every task.
import assert from "node:assert/strict";
import { test } from "node:test";
import { frames, openPage } from "./browser.js";
import { sectionsOf } from "./chapter-page.js";

const SECTIONS = [...sectionsOf("curves"), ...sectionsOf("surfaces")].filter(({ tasks }) => tasks.length > 0);

/** Makes a guess, if a task asks for one, and shows the answer: what is said then is the longest. */
async function reveal(page, name) {
  const task = page.locator(`lesson-task[name="${name}"]`);
  await task.scrollIntoViewIfNeeded();
  await task.getByRole("button").first().waitFor();
  if (await task.locator(".answers").count()) await task.locator(".answers button").first().click();
  if (await task.getByRole("button", { name: "Reveal" }).count())
    await task.getByRole("button", { name: "Reveal" }).click();
  await task.locator(".words:not(:empty)").waitFor();
  const id = await task.getAttribute("for");
  if (id) {
    // The places on the page are final only when the figure has started.
    await page.locator(`#${id}`).scrollIntoViewIfNeeded();
    await page.waitForFunction((id) => {
      const element = document.getElementById(id);
      const isApplet = element.localName === "bezier-applet";
      return element.matches(":defined") && (!isApplet || element.shadowRoot.querySelector("[data-index]"));
    }, id);
  }
  await frames(page);
}

/**
 * Runs in the page: the best of the places to which the page can be scrolled. With `whole`, all of the task and of the figure's sheet should be
 * in view; otherwise the picture of the element that the task is about, and below it the buttons and what is said.
 */
function bestPlace([name, whole]) {
  const task = document.querySelector(`lesson-task[name="${name}"]`);
  const target = document.getElementById(task.getAttribute("for") ?? "");
  const bar = document.querySelector(".chapter-bar").getBoundingClientRect().height;
  const pictures = target ? [...(target.shadowRoot ?? target).querySelectorAll("canvas, svg")] : [];
  const area = (/** @type {Element} */ each) =>
    each.getBoundingClientRect().width * each.getBoundingClientRect().height;
  const picture = pictures.sort((a, b) => area(b) - area(a))[0] ?? target;
  const figure = whole ? target?.closest("figure")?.querySelector(".sheet") : picture;
  const rows = [...task.children].filter((each) => each.getClientRects().length > 0);
  const said = whole ? [task] : rows.slice(1);
  let best = Infinity;
  const top = scrollY + task.getBoundingClientRect().top;
  for (let y = top - innerHeight; y < top + task.offsetHeight; y += 4) {
    scrollTo(0, y);
    const boxes = said.map((each) => each.getBoundingClientRect());
    const words = {
      top: Math.min(...boxes.map(({ top }) => top)),
      bottom: Math.max(...boxes.map(({ bottom }) => bottom)),
    };
    const box = figure?.getBoundingClientRect() ?? { top: bar, bottom: bar, left: 0, right: 0 };
    const isBelow = boxes.some(({ left, right }) => left < box.right && right > box.left);
    const above = isBelow ? box.bottom : bar;
    const own = picture?.getBoundingClientRect() ?? box; // of a tall sheet, the picture that the task is about
    const hidden = [
      own.bottom - box.bottom,
      box.top - own.top,
      bar - box.top,
      box.bottom - innerHeight,
      above - words.top,
      words.bottom - innerHeight,
    ];
    best = Math.min(best, Math.max(0, ...hidden));
  }
  return best;
}

for (const [width, height, whole] of /** @type {[number, number, boolean][]} */ ([
  [1280, 800, true],
  [360, 740, false],
])) {
  test(`question, figure and answer are together at ${width} × ${height}, for every task`, async (t) => {
    const isPhone = width < 500;
    const viewport = { width, height };
    const page = await openPage(t, "about:blank", {
      viewport,
      fresh: true,
      reducedMotion: "reduce",
      hasTouch: isPhone,
      isMobile: isPhone,
      messages: /^$/,
    });
    const hidden = [];
    for (const { path, tasks } of SECTIONS) {
      await page.goto(path);
      await page.waitForSelector("html[data-address]", { state: "attached" });
      for (const name of tasks) {
        await reveal(page, name);
        const pixels = await page.evaluate(bestPlace, /** @type {[string, boolean]} */ ([name, whole]));
        if (pixels > 0) hidden.push(`${path} ${name}: ${Math.round(pixels)} px`);
      }
    }
    assert.deepEqual(hidden, []);
  });
}
