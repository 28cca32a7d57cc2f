// Companions come and go: before and after the applet, without it, moved, removed, far away, on paper.
import assert from "node:assert/strict";
import { test } from "node:test";
import { intersectionsReported, openPage, QUIET_FRAMES } from "./browser.js";
import { companionsPage, load, on, openCompanions, settled, shown, text } from "./companions-page.js";
import { ledgerScript } from "./ledger.js";

const t = (page, selector = "bezier-bernstein") =>
  on(page, selector, ({ shadowRoot }) => Number(shadowRoot.querySelector('input[type="range"]').value));
const linked = (page) => page.waitForFunction(() => document.querySelector("bezier-bernstein").target?.id === "figure");

test("the companion may stand before the applet, and be there before it is", async (test) => {
  const page = await openCompanions(test, '<bezier-bernstein for="figure"></bezier-bernstein><div id="place"></div>');
  assert.match(
    await text(page, "bezier-bernstein .message"),
    /^for: expected the id of a bezier-applet, got “figure”, which is nowhere\.$/,
  );
  assert.equal(await t(page), 0.5, "until then its own attributes count");
  await page.evaluate(
    () => (document.querySelector("#place").innerHTML = '<p><bezier-applet id="figure" t="0.2"></bezier-applet></p>'),
  );
  await linked(page);
  await settled(page);
  assert.equal(await t(page), 0.2);
  assert.equal(await text(page, "bezier-bernstein .message"), "");
});

test("either of the two may be defined first", async (test) => {
  const body = '<bezier-bernstein for="late"></bezier-bernstein><late-figure id="late"></late-figure>';
  const page = await openCompanions(test, body);
  assert.match(await text(page, "bezier-bernstein .message"), /a late-figure that is not defined/);
  await page.evaluate(() =>
    customElements.define(
      "late-figure",
      class extends HTMLElement {
        figure = JSON.parse(
          '{"points":[[0,0],[1,1]],"names":["A","B"],"basis":"bezier","matrix":null,"t":0.75,"segment":0,"pieces":[]}',
        );
        edit() {}
      },
    ),
  );
  await page.waitForFunction(() => document.querySelector("bezier-bernstein").target?.id === "late");
  assert.equal(await text(page, "bezier-bernstein .message"), "");
});

test("ids that change are followed, and so are applets that are taken away and put back", async (test) => {
  const page = await openCompanions(
    test,
    '<bezier-applet id="figure" t="0.2"></bezier-applet><bezier-bernstein for="figure"></bezier-bernstein>',
  );
  await linked(page);
  await page.evaluate(() => (document.querySelector("bezier-applet").id = "other"));
  await page.waitForFunction(() =>
    /nowhere/.test(document.querySelector("bezier-bernstein").shadowRoot.querySelector(".message").textContent),
  );
  await page.evaluate(() => (document.querySelector("bezier-bernstein").htmlFor = "other"));
  await page.waitForFunction(() => document.querySelector("bezier-bernstein").target?.id === "other");
  await page.evaluate(() => {
    globalThis.applet = document.querySelector("bezier-applet");
    applet.remove();
  });
  await page.waitForFunction(() => document.querySelector("bezier-bernstein").target === null);
  await page.evaluate(() => {
    applet.t = 0.9;
    document.querySelector("main").prepend(applet);
  });
  await page.waitForFunction(() => document.querySelector("bezier-bernstein").target === applet);
  await settled(page);
  assert.equal(await t(page), 0.9);
});

test("an id of something else, none, and every text: a message, nothing breaks", async (test) => {
  const page = await openCompanions(
    test,
    '<p id="text">text</p><bezier-bernstein for="text"></bezier-bernstein><bezier-equation></bezier-equation>',
  );
  assert.match(await text(page, "bezier-bernstein .message"), /got “text”, a p\.$/);
  for (const word of ["", " ", "#", "<b>", "a b", "\\", '"', "x".repeat(1e5), "0"]) {
    for (const name of ["for", "degree", "t", "basis", "points", "matrix", "form", "label", "theme"]) {
      await page.evaluate(
        ([name, word]) =>
          document
            .querySelectorAll("bezier-bernstein, bezier-equation")
            .forEach((each) => each.setAttribute(name, word)),
        [name, word],
      );
    }
    await settled(page);
    assert.ok((await text(page, "bezier-equation .message")).length < 1000);
  }
  await page.evaluate(() =>
    document
      .querySelectorAll("bezier-bernstein, bezier-equation")
      .forEach((each) => [...each.attributes].forEach(({ name }) => each.removeAttribute(name))),
  );
  await settled(page);
  assert.deepEqual(
    [await text(page, "bezier-bernstein .message"), await text(page, "bezier-equation .message"), await t(page)],
    ["", "", 0.5],
  );
});

test("inside of a shadow root the link goes to the applet there", async (test) => {
  const page = await openCompanions(test, '<bezier-applet id="figure" t="0.1"></bezier-applet><div id="host"></div>');
  await load(page, "bezier-bernstein");
  await page.evaluate(() => {
    document.querySelector("#host").attachShadow({ mode: "open" }).innerHTML =
      '<bezier-bernstein for="figure"></bezier-bernstein><bezier-applet id="figure" t="0.7"></bezier-applet>';
  });
  await page.waitForFunction(
    () => document.querySelector("#host").shadowRoot.querySelector("bezier-bernstein").target?.figure.t === 0.7,
  );
});

test("inside of a shadow root an applet of the page is found, too, when it comes later", async (test) => {
  const page = await openCompanions(test, '<div id="host"></div><div id="place"></div>');
  await load(page, "bezier-bernstein");
  await page.evaluate(() => {
    document.querySelector("#host").attachShadow({ mode: "open" }).innerHTML =
      '<bezier-bernstein for="figure"></bezier-bernstein>';
  });
  const companion = page.locator("#host bezier-bernstein");
  await companion.locator(".message", { hasText: "which is nowhere" }).waitFor();
  await page.evaluate(
    () => (document.querySelector("#place").innerHTML = '<bezier-applet id="figure" t="0.7"></bezier-applet>'),
  );
  await page.waitForFunction(
    () => document.querySelector("#host").shadowRoot.querySelector("bezier-bernstein").target?.figure.t === 0.7,
  );
});

test("a message about an attribute is shown once, however often it is read", async (test) => {
  const page = await openCompanions(
    test,
    '<bezier-coordinates points="bad"></bezier-coordinates><bezier-equation form="matrix" editable t="abc"></bezier-equation>',
  );
  const first = "points: expected at least two points x,y x,y …, got “bad”; 70,330 110,90 235,120 325,230 is used.";
  assert.equal(await text(page, "bezier-coordinates .message"), first);
  assert.equal(await text(page, "bezier-equation .message"), "t: expected a number, got “abc”; 0.5 is used.");
});

/** embedding.deep.test.js does it a thousand times, with every kind of element. */
const TIMES = 40;

test("linked to an applet, removed and put back many times they leave nothing", async (test) => {
  const page = await openCompanions(test, '<bezier-applet id="figure"></bezier-applet><div id="place"></div>', {
    script: ledgerScript("bezier-applet"),
  });
  const count = () => page.evaluate(() => ({ ...ledger.count(), frames: 0 }));
  const alone = await count();
  await page.evaluate(() => {
    const linked = ["bernstein", "equation", "coordinates"].map(
      (kind) => `<bezier-${kind} for="figure"></bezier-${kind}>`,
    );
    document.querySelector("#place").innerHTML = `${linked.join("")}<bezier-easing></bezier-easing>`;
  });
  await shown(page);
  await linked(page);
  await settled(page);
  const before = await count();
  const away = await page.evaluate(async (times) => {
    const place = document.querySelector("#place");
    const all = [...place.children];
    const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
    for (let i = 0; i < times; i++) {
      for (const each of all) each.remove();
      if (i === times - 1) break;
      place.append(...all);
      if (i % 5 === 0) await frame();
    }
    for (let i = 0; i < 3; i++) await frame();
    const away = ledger.count();
    place.append(...all);
    return { ...away, frames: 0 };
  }, TIMES);
  await linked(page);
  await settled(page);
  assert.deepEqual(await count(), before);
  assert.deepEqual(away, alone);
  const frames = await page.evaluate(async (quiet) => {
    document.querySelector("#place").remove();
    let frames = 0;
    const original = requestAnimationFrame;
    globalThis.requestAnimationFrame = (act) => {
      frames++;
      return original(act);
    };
    document.querySelector("bezier-applet").edit({ t: 0.11 }, true);
    for (let i = 0; i < quiet; i++) await new Promise((resolve) => original(resolve));
    return frames;
  }, QUIET_FRAMES);
  assert.ok(frames <= 1, `the applet's own frame, and no companion's: ${frames}`);
});

test("far down the page nothing is fetched or drawn until it comes near", async (test) => {
  const html = companionsPage('<div style="height: 4000px"></div><bezier-bernstein></bezier-bernstein>');
  const page = await openPage(test, { html }, { viewport: { width: 800, height: 600 } });
  await load(page, "bezier-bernstein");
  await intersectionsReported(page);
  const fetched = () =>
    page.evaluate(() =>
      performance.getEntriesByType("resource").some(({ name }) => name.endsWith("elements-bernstein.js")),
    );
  assert.equal(await fetched(), false);
  assert.equal(await on(page, "bezier-bernstein", ({ shadowRoot }) => shadowRoot.querySelector("svg")), null);
  await page.locator("bezier-bernstein").scrollIntoViewIfNeeded();
  await shown(page);
  assert.equal(await fetched(), true);
});

test("what could not be fetched is said, and asked for again", async (test) => {
  const page = await openPage(test, "about:blank", { viewport: { width: 800, height: 600 } });
  let broken = true;
  await page.route("**/elements-easing.js", (route) => (broken ? route.abort() : route.continue()));
  await page.route("**/lost.html", (route) =>
    route.fulfill({
      contentType: "text/html",
      body: companionsPage('<bezier-easing></bezier-easing><div style="height: 3000px"></div>'),
    }),
  );
  await page.goto("/lost.html");
  await page.getByText("could not be loaded").waitFor();
  broken = false;
  // Away and near again, until it has seen both.
  await page.waitForFunction(
    () => {
      if (document.querySelector("bezier-easing").shadowRoot.querySelector(".frame")) return true;
      scrollTo(0, scrollY > 1000 ? 0 : 2500);
      return false;
    },
    null,
    { polling: "raf" },
  );
  page.problems.length = 0;
});

test("the theme may be other than the page's", async (test) => {
  const themes = ["", "dark", "light", "pink"].map((theme) => `<bezier-bernstein theme="${theme}"></bezier-bernstein>`);
  const page = await openCompanions(test, themes.join(""));
  const grounds = () =>
    page
      .locator("bezier-bernstein [part=plot]")
      .evaluateAll((all) => all.map((plot) => getComputedStyle(plot).backgroundColor));
  const [light, dark] = ["rgb(243, 246, 250)", "rgb(19, 26, 34)"];
  assert.deepEqual(await grounds(), [light, dark, light, light]);
  await page.emulateMedia({ colorScheme: "dark" });
  assert.deepEqual((await grounds()).slice(0, 3), [dark, dark, light]);
});

test("paper shows what no one has scrolled to", async (test) => {
  const html = companionsPage(
    '<bezier-applet id="figure" t="0.25"></bezier-applet><bezier-bernstein></bezier-bernstein><div style="height: 4000px"></div><bezier-bernstein id="far" for="figure"></bezier-bernstein>',
  );
  const page = await openPage(test, { html }, { viewport: { width: 800, height: 900 } });
  await page.waitForFunction(() => document.querySelector("bezier-bernstein").shadowRoot?.querySelector("svg"));
  await page.waitForFunction(() => document.querySelector("bezier-applet").shadowRoot?.querySelector(".handle"));
  assert.equal(await on(page, "#far", ({ shadowRoot }) => shadowRoot.querySelector("svg")), null);
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  assert.match(await text(page, "#far li >> nth=0"), /P0\s+0\.4219/);
});

test("on paper there are pictures and numbers, no controls", async (test) => {
  const page = await openCompanions(test, "<bezier-bernstein></bezier-bernstein><bezier-equation></bezier-equation>");
  await page.emulateMedia({ media: "print" });
  assert.equal(await page.locator('bezier-bernstein input[type="range"]').isVisible(), false);
  assert.ok(await page.locator("bezier-bernstein [part=plot]").isVisible());
  assert.ok(await page.locator("bezier-bernstein li").first().isVisible());
});
