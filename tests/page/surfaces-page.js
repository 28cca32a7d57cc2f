// What the tests of the chapter on surfaces share.
import { openPage } from "./browser.js";

/** @param {import("node:test").TestContext} t */
export async function open(t, options = {}) {
  const page = await openPage(t, "/surfaces/", {
    viewport: { width: 1100, height: 800 },
    reducedMotion: "reduce",
    ...options,
  });
  page.on(
    "console",
    (message) => message.type() === "warning" && /context/i.test(message.text()) && page.problems.push(message.text()),
  );
  await page.waitForFunction(
    () =>
      customElements.get("bezier-surface") &&
      customElements.get("lesson-task") &&
      customElements.get("surface-controls"),
  );
  return page;
}

/** Scrolls a figure to where it starts, and waits until it has been drawn. @param {import("playwright-core").Page} page @param {string} id */
export async function near(page, id) {
  const element = page.locator(`#${id}`);
  await element.scrollIntoViewIfNeeded();
  await page.waitForFunction((id) => {
    const element = /** @type {any} */ (document.getElementById(id));
    return element.figure.mesh.triangles > 0 && element.shadowRoot.querySelector("canvas").width > 1;
  }, id);
  return element;
}

/** The task, opened: the guess made. */
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

/** The controls of a figure. */
export const controls = (page, id) => page.locator(`surface-controls[for="${id}"]`);
