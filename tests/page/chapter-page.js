// What the tests of the two chapters share: their pages, and tasks.
import { readFileSync } from "node:fs";
import { openPage, root } from "./browser.js";

/** @typedef {"curves" | "surfaces"} Chapter */

/**
 * The sections of a chapter, from its contents: the address of each, all ids in it, and the names of its tasks.
 *
 * @param {Chapter} chapter
 * @returns {{ id: string, path: string, ids: string[], tasks: string[] }[]}
 */
export function sectionsOf(chapter) {
  const html = readFileSync(`${root}site/${chapter}/index.html`, "utf8");
  const entries = html.matchAll(
    /<li id="([^"]+)" data-page="([^"]+)" data-tasks="([^"]*)">(.*?)(?=<li id="|<nav class="next")/gs,
  );
  return Array.from(entries, ([, id, page, tasks, content]) => ({
    id,
    path: `/${chapter}/${page}`,
    ids: [id, ...Array.from(content.matchAll(/<span id="([^"]+)"/g), ([, each]) => each)],
    tasks: tasks.split(" ").filter(Boolean),
  }));
}

/** The address of the section with an id or a task. @param {Chapter} chapter @param {string} place */
export function pageOf(chapter, place) {
  const section = sectionsOf(chapter).find(({ ids, tasks }) => ids.includes(place) || tasks.includes(place));
  if (!section) throw new Error(`expected an id or a task of /${chapter}/, got ${place}`);
  return section.path;
}

/** Goes to the section with an id or a task, if the page shows another one. @param {import("playwright-core").Page} page @param {string} place */
export async function goTo(page, place) {
  const { pathname } = new URL(page.url());
  const chapters = /** @type {Chapter[]} */ (
    pathname.startsWith("/surfaces/") ? ["surfaces", "curves"] : ["curves", "surfaces"]
  );
  const chapter = chapters.find((each) =>
    sectionsOf(each).some(({ ids, tasks }) => [...ids, ...tasks].includes(place)),
  );
  const path = pageOf(chapter ?? "curves", place);
  if (pathname !== path) await page.goto(path);
  await page.waitForSelector("html[data-address]", { state: "attached" });
}

/**
 * A section of the chapter on curves, once for the tests of a file; the functions below go to others.
 *
 * @param {import("node:test").TestContext} t
 * @param {import("./browser.js").PageOptions} [options]
 */
export async function openCurves(t, options = {}) {
  const page = await openPage(t, "/curves/parameter/", {
    viewport: { width: 1100, height: 800 },
    reducedMotion: "reduce",
    keep: true,
    ...options,
  });
  await page.waitForSelector("html[data-address]", { state: "attached" });
  return page;
}

/** Scrolls an applet to where it starts, and waits until it has. @param {import("playwright-core").Page} page @param {string} id */
export async function nearApplet(page, id) {
  await goTo(page, id);
  const element = page.locator(`#${id}`);
  await element.scrollIntoViewIfNeeded();
  await page.waitForFunction((id) => document.getElementById(id).shadowRoot.querySelector("[data-index]"), id);
  return element;
}

/** A task, opened: the guess made, by one click. */
export async function task(page, name, guess) {
  await goTo(page, name);
  const found = page.locator(`lesson-task[name="${name}"]`);
  await found.scrollIntoViewIfNeeded();
  await found.getByRole("button").first().waitFor();
  if (guess !== undefined) await found.locator(".answers").getByRole("button").nth(guess).click();
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
