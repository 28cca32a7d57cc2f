// casteljau/elements loads the code of an element when one is close to the visible part of the page. What an element is before.
import assert from "node:assert/strict";
import { test } from "node:test";
import { intersectionsReported, openPage } from "./browser.js";

const FAR = '<div style="height: 6000px">Text</div>';
/** Only elements that fill their space. */
const SIZED = ["bezier-applet", "bezier-surface"];

/**
 * Opens a page with these elements; `script` runs before the elements are loaded. `requests` are the scripts that the page asks for.
 *
 * @param {import("node:test").TestContext} t
 * @param {string} body
 */
async function open(t, body, script = "") {
  const page = await openPage(t, "about:blank", { viewport: { width: 800, height: 600 }, fresh: true });
  /** @type {string[]} */
  const requests = [];
  page.on("request", (request) => {
    if (request.resourceType() === "script") requests.push(new URL(request.url()).pathname.replace("/dist/", ""));
  });
  const html = `<!doctype html><html lang="en"><meta charset="utf-8"><title>On demand</title><body style="margin: 8px"><main>${body}</main>
<script>${script}</script><script type="module" src="dist/elements.js"></script></body></html>`;
  await page.route("**/on-demand.html", (route) => route.fulfill({ contentType: "text/html", body: html }));
  await page.goto("/on-demand.html");
  await intersectionsReported(page);
  return { page, requests };
}

/** The elements whose code the page has asked for. @param {string[]} requests */
const loaded = (requests) => requests.flatMap((path) => /^elements\/(\w+)\.js$/.exec(path)?.[1] ?? []).sort();
const defined = (page, name) => page.waitForFunction((name) => customElements.get(name), name);
const load = (page, name) => page.evaluate(async (name) => (await import("/dist/elements.js")).loadElement(name), name);

test("a page without elements loads none of their code; an element that is added later is found", async (t) => {
  const { page, requests } = await open(t, "<h1>Text</h1>");
  assert.deepEqual(
    requests.filter((path) => !/^elements(-shared-load\w+)?\.js$|^shared-(translations|no-dom)\.js$/.test(path)),
    [],
  );
  await page.evaluate(() => {
    const section = document.createElement("section");
    section.innerHTML = '<p><bezier-coordinates points="1,2 3,4"></bezier-coordinates></p>';
    document.querySelector("main").append(section);
  });
  await defined(page, "bezier-coordinates");
  assert.deepEqual(loaded(requests), ["coordinates"]);
});

test("the code of an element is loaded when it is near, and takes the same space before", async (t) => {
  const { page, requests } = await open(
    t,
    `${SIZED.map((name) => `${FAR}<${name}></${name}>`).join("")}<bezier-surface hidden></bezier-surface>`,
  );
  assert.deepEqual(loaded(requests), []);
  for (const [i, name] of SIZED.entries()) {
    const element = page.locator(`${name}:not([hidden])`);
    const size = () =>
      element.evaluate((each) => {
        const { width, height } = each.getBoundingClientRect();
        return [Math.round(width), Math.round(height)];
      });
    const before = await size();
    await page.route("**/elements-*.js", (route) =>
      /shared/.test(route.request().url()) ? route.continue() : new Promise(() => {}),
    );
    await element.scrollIntoViewIfNeeded();
    await defined(page, name);
    const [width, height] = await size();
    assert.equal(width, before[0], name);
    assert.ok(Math.abs(height - before[1]) < 60, `${name}: ${before} and ${[width, height]}`); // a line of text below surfaces
    assert.deepEqual(
      loaded(requests),
      SIZED.slice(0, i + 1).map((each) => each.replace("bezier-", "")),
    );
  }
  assert.equal(await page.locator("bezier-surface[hidden]").isVisible(), false);
});

test("properties that were set before count; methods and `figure` are undefined before, and no event is fired", async (t) => {
  const { page } = await open(
    t,
    `${FAR}<bezier-applet t="0.1"></bezier-applet><bezier-bernstein></bezier-bernstein><bezier-coordinates></bezier-coordinates><bezier-surface model="patch"></bezier-surface>`,
    `globalThis.events = [];
    for (const type of ["input", "change", "update"]) addEventListener(type, (event) => events.push(type + " " + event.target.localName), true);
    const [applet, weights, table, surface] = document.querySelectorAll(":not(:defined)");
    Object.assign(applet, { t: 0.25, points: [[0, 0], [1, 1], [2, 0]], degree: 2, controls: true });
    Object.assign(weights, { degree: 5, t: 0.75 });
    table.points = [[1, 2], [3, 4]];
    Object.assign(surface, { segments: 3, view: { turn: 12 } });`,
  );
  const before = await page.evaluate(() => {
    const applet = document.querySelector("bezier-applet");
    return [typeof applet.figure, typeof applet.toJSON, applet.t, globalThis.events.length];
  });
  assert.deepEqual(before, ["undefined", "undefined", 0.25, 0]);
  for (const kind of ["applet", "bernstein", "coordinates", "surface"]) await load(page, `bezier-${kind}`);
  const after = await page.evaluate(() => {
    const [applet, weights, table, surface] = document.querySelectorAll(
      "bezier-applet, bezier-bernstein, bezier-coordinates, bezier-surface",
    );
    return [
      [applet.t, applet.points, applet.degree, applet.hasAttribute("controls"), applet.figure.pieces.length],
      [weights.degree, weights.t, table.points],
      [surface.segments, surface.view.turn, surface.figure.triangles ?? null],
    ];
  });
  assert.deepEqual(after.slice(0, 2), [
    [0.25, [[0, 0], [1, 1], [2, 0]], 2, true, 1], // biome-ignore format: points
    [
      5,
      0.75,
      [
        [1, 2],
        [3, 4],
      ],
    ],
  ]);
  assert.deepEqual(after[2].slice(0, 2), [3, 12]);
  const events = await page.evaluate(() => globalThis.events);
  assert.deepEqual(
    events.filter((event) => !event.startsWith("update ")),
    [],
  );
});

test("a form has the value of an easing far below, as soon as its code has come", async (t) => {
  const { page, requests } = await open(
    t,
    `<form>${FAR}<bezier-easing name="a" value="ease-in"></bezier-easing><bezier-easing name="b"></bezier-easing><bezier-easing name="c" required></bezier-easing></form>`,
    `globalThis.send = () => String(new URLSearchParams(new FormData(document.querySelector("form"))));
    globalThis.early = [send(), document.querySelector("form").checkValidity()];
    document.querySelector("[name=b]").value = "linear";
    customElements.whenDefined("bezier-easing").then(() => (globalThis.late = [send(), document.querySelector("form").checkValidity()]));`,
  );
  await defined(page, "bezier-easing");
  assert.deepEqual(await page.evaluate(() => globalThis.early), ["", true]);
  const sent = "a=cubic-bezier%280.42%2C+0%2C+1%2C+1%29&b=cubic-bezier%280%2C+0%2C+1%2C+1%29&c=";
  assert.deepEqual(await page.evaluate(() => globalThis.late), [sent, false]);
  assert.deepEqual(loaded(requests), ["easing"]);
});

test("a companion that is near has the code of its applet loaded, which is far away", async (t) => {
  const { page, requests } = await open(
    t,
    `<bezier-bernstein></bezier-bernstein>${FAR}<bezier-applet id="figure" t="0.2"></bezier-applet>`,
  );
  await page.waitForFunction(() => document.querySelector("bezier-bernstein").shadowRoot?.querySelector("svg"));
  assert.deepEqual(loaded(requests), ["bernstein"]);
  await page.evaluate(() => {
    globalThis.messages = [];
    const { shadowRoot } = document.querySelector("bezier-bernstein");
    const read = () => globalThis.messages.push(shadowRoot.querySelector(".message").textContent);
    new MutationObserver(read).observe(shadowRoot, { subtree: true, childList: true, characterData: true });
    document.querySelector("bezier-bernstein").htmlFor = "figure";
  });
  await page.waitForFunction(() => document.querySelector("bezier-bernstein").target?.id === "figure");
  assert.deepEqual(loaded(requests), ["applet", "bernstein"]);
  assert.deepEqual(await page.evaluate(() => globalThis.messages.filter(Boolean)), []);
});

test("elements in shadow trees and others by `loadElement`", async (t) => {
  const { page } = await open(t, "<div></div>");
  const made = await page.evaluate(async () => {
    const { loadElement } = await import("/dist/elements.js");
    const root = document.querySelector("div").attachShadow({ mode: "open" });
    root.innerHTML = '<bezier-equation points="0,0 1,1"></bezier-equation>';
    await loadElement("bezier-equation");
    await loadElement("bezier-equation");
    const wrong = await loadElement(/** @type {any} */ ("bezier-sphere")).catch(String);
    return [root.firstElementChild?.matches(":defined"), wrong];
  });
  assert.equal(made[0], true);
  assert.match(String(made[1]), /^TypeError: name: expected one of bezier-applet, .*, got bezier-sphere$/);
});

test("code that cannot be fetched is asked for again", async (t) => {
  const { page } = await open(t, `<p>Text</p>${FAR}<bezier-equation points="0,0 1,1">Poster</bezier-equation>`);
  let broken = true;
  /** @type {string[]} */
  const warnings = [];
  page.on("console", (message) => message.type() === "warning" && warnings.push(message.text()));
  await page.route(/\/elements\/equation\.js/, (route) => (broken ? route.abort() : route.continue()));
  const error = await load(page, "bezier-equation").catch(String);
  assert.match(String(error), /fetch/);
  const failed = page.waitForEvent("requestfailed");
  const warned = page.waitForEvent("console", (message) => message.type() === "warning");
  await page.locator("bezier-equation").scrollIntoViewIfNeeded();
  await failed;
  await warned;
  assert.match(warnings[0], /^<bezier-equation> could not be loaded: TypeError/);
  assert.ok(await page.getByText("Poster").isVisible());
  broken = false;
  await page.evaluate(() => scrollTo(0, 0));
  await intersectionsReported(page);
  await page.locator("bezier-equation").scrollIntoViewIfNeeded();
  await defined(page, "bezier-equation");
  page.problems.length = 0;
});
