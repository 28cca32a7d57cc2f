// What the tests of the two chapters share: the chapter on curves, and tasks.
import { openPage } from "./browser.js";

/**
 * The chapter on curves, once for the tests of a file.
 *
 * @param {import("node:test").TestContext} t
 * @param {import("./browser.js").PageOptions} [options]
 */
export async function openCurves(t, options = {}) {
  const page = await openPage(t, "/curves/", {
    viewport: { width: 1100, height: 800 },
    reducedMotion: "reduce",
    keep: true,
    ...options,
  });
  await page.waitForFunction(() => customElements.get("bezier-applet") && customElements.get("lesson-task"));
  return page;
}

/** Scrolls an applet to where it starts, and waits until it has. @param {import("playwright-core").Page} page @param {string} id */
export async function nearApplet(page, id) {
  const element = page.locator(`#${id}`);
  await element.scrollIntoViewIfNeeded();
  await page.waitForFunction((id) => document.getElementById(id).shadowRoot.querySelector("[data-index]"), id);
  return element;
}

/** A task, opened: the guess made. */
export async function task(page, name, guess) {
  const found = page.locator(`lesson-task[name="${name}"]`);
  await found.scrollIntoViewIfNeeded();
  await found.getByRole("button").first().waitFor();
  if (guess !== undefined) {
    await found.getByRole("radio").nth(guess).check();
    await found.getByRole("button", { name: "That is my guess" }).click();
  }
  return found;
}

/** Waits until a task is done; what it says then. */
export async function done(page, name) {
  await page.waitForFunction(
    (name) => document.querySelector(`lesson-task[name="${name}"]`)?.dataset.state === "done",
    name,
  );
  return page.locator(`lesson-task[name="${name}"] .words`).innerText();
}

/** Brings every figure near the window, one after the other, until the scripts of all are there. @param {import("playwright-core").Page} page */
export async function loadFigures(page) {
  await page.evaluate(async () => {
    for (const figure of document.querySelectorAll("main :not(:defined)")) {
      figure.scrollIntoView();
      await customElements.whenDefined(figure.localName);
    }
    scrollTo(0, 0);
  });
}
