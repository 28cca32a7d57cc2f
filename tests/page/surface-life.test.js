// <bezier-surface>: where it comes from and goes to; what it does when things are missing.
import assert from "node:assert/strict";
import { test } from "node:test";
import { assertAccessibleInBothThemes, frames, openPage, QUIET_FRAMES } from "./browser.js";
import { difference, facts, look, openSurface, ready, set, settled, surfacePage } from "./surface-page.js";

/** Everything that the page can show at once. */
const FULL = 'controls show="surface mesh isocurves net casteljau" patch="5" step="2"';

test("with everything switched on it is accessible, light and dark", async (t) => {
  await assertAccessibleInBothThemes(await openSurface(t, FULL), settled);
});

test("it fits a narrow phone, sharp", async (t) => {
  const page = await openSurface(t, FULL, {
    viewport: { width: 360, height: 740 },
    deviceScaleFactor: 3,
    hasTouch: true,
    isMobile: true,
  });
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 360);
  const [width, shown] = await page
    .locator("bezier-surface canvas")
    .evaluate((/** @type {any} */ canvas) => [canvas.width, canvas.clientWidth]);
  assert.equal(width, 3 * shown);
});

test("without WebGL2 it is drawn as lines, and says so", async (t) => {
  const page = await openPage(t, "about:blank", { reducedMotion: "reduce" });
  await page.addInitScript(() => {
    const original = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = /** @returns {any} */ function (kind, ...rest) {
      return kind === "webgl2" ? null : original.call(this, kind, ...rest);
    };
  });
  await page.route("**/fallback.html", (route) =>
    route.fulfill({ contentType: "text/html", body: surfacePage("controls") }),
  );
  await page.goto("/fallback.html");
  await ready(page);
  await page.getByText("no WebGL2").waitFor();
  const first = await look(page);
  assert.ok(first.inked > 3000, `${first.inked} pixels`);
  await set(page, { view: { turn: 60 } });
  assert.ok((await difference(page, first, await look(page))) > 2000);
});

test("a lost context comes back with its picture", async (t) => {
  const page = await openSurface(t, 'show="surface mesh"');
  const before = await look(page);
  await page.evaluate(() => {
    const gl = document.querySelector("bezier-surface").shadowRoot.querySelector("canvas").getContext("webgl2");
    globalThis.loss = gl.getExtension("WEBGL_lose_context");
    loss.loseContext();
  });
  await page.getByText("WebGL context was lost").waitFor();
  await set(page, { segments: 12, shading: "smooth" });
  await page.evaluate(() => loss.restoreContext());
  await page.getByText("WebGL context was lost").waitFor({ state: "detached" });
  await settled(page);
  assert.equal(await difference(page, before, await look(page)), 0);
});

test("custom properties may be colours of every colour space", async (t) => {
  const page = await openSurface(t, 'model="patch" shading="flat"');
  const withFront = async (colour) => {
    await page.evaluate((colour) => {
      const element = document.querySelector("bezier-surface");
      element.style.setProperty("--bz-front", colour);
      element.toggleAttribute("data-colour");
      element.theme = element.theme === "light" ? "auto" : "light"; // reads the colours again
    }, colour);
    await settled(page);
    return look(page);
  };
  const first = await withFront("rgb(200, 80, 40)");
  await withFront("rgb(0, 0, 255)");
  const same = [
    "lab(from rgb(200 80 40) l a b)",
    "oklch(from rgb(200 80 40) l c h)",
    "color(from rgb(200 80 40) display-p3 r g b)",
  ];
  for (const colour of same) {
    const count = await difference(page, first, await withFront(colour), 4);
    assert.equal(count, 0, colour);
  }
  const red = await withFront("rgb(255, 0, 0)");
  assert.ok((await difference(page, red, await withFront("color(display-p3 1 0 0)"), 4)) === 0, "clipped to sRGB");
});

test("numbers below the picture are those of the language of the page", async (t) => {
  const page = await openSurface(t, 'segments="40" lang="de"');
  assert.match((await facts(page)).text, /102\.400 triangles/);
  for (const [language, expected] of [
    ["", "102,400"],
    ["fr", "102\u202f400"],
    ["no_such-tag", "102,400"],
  ]) {
    await page.evaluate((language) => {
      const element = document.querySelector("bezier-surface");
      element.lang = language;
      element.requestUpdate();
    }, language);
    await settled(page);
    const { text } = await facts(page);
    assert.ok(text.includes(`${expected} triangles`), `${language}: ${text}`);
  }
});

test("an element that was never on the page has no picture", async (t) => {
  const page = await openSurface(t);
  assert.equal(await page.evaluate(() => /** @type {any} */ (document.createElement("bezier-surface")).toBlob()), null);
});

test("light, dark, as the page is: the theme", async (t) => {
  const page = await openSurface(t, 'theme="dark"');
  const paper = () =>
    page.evaluate(() => {
      const stage = document.querySelector("bezier-surface").renderRoot.querySelector(".stage");
      return getComputedStyle(stage).backgroundColor;
    });
  assert.equal(await paper(), "rgb(19, 26, 34)");
  const dark = await look(page);
  await set(page, { theme: "light" });
  assert.equal(await paper(), "rgb(243, 246, 250)");
  const light = await look(page);
  assert.ok((await difference(page, dark, light)) > 1000, "the surface has other colours");
  await page.evaluate(() => document.querySelector("bezier-surface").removeAttribute("theme"));
  await settled(page);
  assert.equal(await difference(page, light, await look(page)), 0);
});

test("moved to another place it shows the same; taken away it leaves nothing running", async (t) => {
  const page = await openSurface(t, 'model="patch" show="surface net"', {
    more: '<div id="elsewhere" style="width: 640px"></div>',
  });
  await set(page, { view: { turn: 20, zoom: 1.5 } });
  const before = await look(page);
  await page.evaluate(async () => {
    const element = document.querySelector("bezier-surface");
    document.querySelector("#elsewhere").append(element);
    await element.updateComplete; // its lines are shown until it is drawn again
  });
  await page.waitForFunction(() => !document.querySelector("bezier-surface").shadowRoot.querySelector(".poster"));
  await page.waitForFunction(() => document.querySelector("bezier-surface").toBlob().then(Boolean));
  await settled(page);
  const after = await look(page);
  assert.ok(after.inked > 3000);
  assert.equal(await difference(page, before, after), 0);
  const requested = await page.evaluate(async (quiet) => {
    const element = document.querySelector("bezier-surface");
    element.autoRotate = true;
    element.remove();
    let count = 0;
    const original = requestAnimationFrame;
    globalThis.requestAnimationFrame = (act) => {
      count++;
      return original(act);
    };
    element.segments = 5;
    for (let i = 0; i < quiet; i++) await new Promise((resolve) => original(resolve));
    globalThis.requestAnimationFrame = original;
    return count;
  }, QUIET_FRAMES);
  assert.equal(requested, 0);
});

test("it draws only when something changes, and turns only when asked", async (t) => {
  const page = await openSurface(t, "auto-rotate", { reducedMotion: "no-preference" });
  const turn = () => page.evaluate(() => document.querySelector("bezier-surface").view.turn);
  const first = await turn();
  await page.waitForFunction((was) => document.querySelector("bezier-surface").view.turn !== was, first);
  await page.getByRole("button", { name: "Stop rotating" }).click();
  await settled(page);
  const count = await page.evaluate(async (quiet) => {
    let draws = 0;
    const { prototype } = WebGL2RenderingContext;
    const original = prototype.clear;
    prototype.clear = function (...args) {
      draws++;
      return original.apply(this, args);
    };
    for (let i = 0; i < quiet; i++) await new Promise((resolve) => requestAnimationFrame(resolve));
    return draws;
  }, QUIET_FRAMES);
  assert.equal(count, 0);
});

test("it stands still for those who want less motion, until they ask", async (t) => {
  const page = await openSurface(t, "auto-rotate");
  const turn = () => page.evaluate(() => document.querySelector("bezier-surface").view.turn);
  const first = await turn();
  await frames(page, QUIET_FRAMES);
  assert.equal(await turn(), first);
  await page.getByRole("button", { name: "Rotate", exact: true }).click();
  await page.waitForFunction((was) => document.querySelector("bezier-surface").view.turn !== was, first);
});

test("surfaces of every kind are shown: none, a point, a high degree, very large, very small", async (t) => {
  const page = await openSurface(t, 'controls show="surface mesh isocurves tubes net casteljau" segments="4"');
  const show = async (make, properties = {}) => {
    await page.evaluate(
      ([make, properties]) => {
        const element = document.querySelector("bezier-surface");
        element.surface = new Function("Surface", `return ${make}`)(bezier.Surface);
        Object.assign(element, properties);
      },
      [make, properties],
    );
    await settled(page);
  };
  const grid = (n, size) => `(() => {
    const vertices = Array.from({ length: ${n * n} }, (_, k) => [(k % ${n}) * ${size}, Math.floor(k / ${n}) * ${size}, Math.sin(k) * ${size}]);
    return new Surface({ vertices, patches: [vertices.map((_, k) => k)] }, { degreeU: ${n - 1}, degreeV: ${n - 1} });
  })()`;
  for (const evaluation of ["cpu", "gpu"]) {
    await show("new Surface({ vertices: [], patches: [] })", { evaluation });
    assert.equal((await look(page)).inked, 0);
    await show("new Surface({ vertices: [[1, 2, 3]], patches: [Array(16).fill(0)] })");
    assert.match((await facts(page)).text, /triangles/);
    for (const size of [1, 1e6, 1e-6]) {
      await show(grid(4, size));
      assert.ok((await look(page)).inked > 5000, `${evaluation}, ${size}`);
    }
  }
  await show(grid(13, 1));
  assert.doesNotMatch((await facts(page)).text, /graphics card/, "degree 12 is left to the core");
  assert.ok((await look(page)).inked > 5000);
});

test("what was written before the element was defined counts, and no view is impossible", async (t) => {
  const html = surfacePage().replace(
    'import "./dist/elements.js"; import * as casteljau from "./dist/index.js"; globalThis.bezier = casteljau;',
    `
    import { Surface } from "./dist/index.js";
    const element = document.querySelector("bezier-surface");
    element.surface = new Surface({ vertices: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 1]], patches: [[0, 1, 2, 3]] }, { degreeU: 1, degreeV: 1 });
    element.view = { turn: 50, zoom: NaN };
    await import("./dist/elements.js");`,
  );
  const page = await openPage(t, { html });
  await ready(page);
  const [patches, { turn, zoom }] = await page.evaluate(() => {
    const { surface, view } = document.querySelector("bezier-surface");
    return [surface.patchCount, view];
  });
  assert.deepEqual([patches, turn, zoom], [1, 50, 1]);
  assert.ok((await look(page)).inked > 5000);
});

const BPT = `1
1 1
0 0 0
1 0 0
0 1 0
1 1 1
`;
const give = (page, name, text) =>
  page
    .locator('bezier-surface input[type="file"]')
    .setInputFiles({ name, mimeType: "text/plain", buffer: Buffer.from(text) });

test("a patch file is shown; one that is none is refused, and the picture stays", async (t) => {
  const page = await openSurface(t, 'controls segments="2"');
  await give(page, "saddle.bpt", BPT);
  await page.getByText("A surface of your own").waitFor();
  await settled(page);
  assert.equal((await facts(page)).triangles, 8);
  const before = await look(page);
  await give(page, "broken.bpt", BPT.replace("1 0 0", "1 zero 0"));
  await page.getByText(/broken\.bpt: .*line/).waitFor();
  assert.equal(await difference(page, before, await look(page)), 0);
  await give(page, "huge.bpt", " ".repeat(17e6));
  await page.getByText(/huge\.bpt: expected at most 16 MB, got 17/).waitFor();
  assert.equal((await facts(page)).triangles, 8);
  await page.getByRole("button", { name: "Back to the teapot" }).click();
  await settled(page);
  assert.equal((await facts(page)).triangles, 32 * 8);
});

test("a patch file is dropped on the picture", async (t) => {
  const page = await openSurface(t, 'segments="3"');
  const prevented = await page.evaluate((text) => {
    const data = new DataTransfer();
    data.items.add(new File([text], "saddle.bpt"));
    const event = new DragEvent("drop", { bubbles: true, composed: true, cancelable: true, dataTransfer: data });
    document.querySelector("bezier-surface").shadowRoot.querySelector("canvas").dispatchEvent(event);
    return event.defaultPrevented;
  }, BPT);
  assert.ok(prevented, "else the browser would go to the file");
  await page.waitForFunction(() => document.querySelector("bezier-surface").surface.patchCount === 1);
  await settled(page);
  assert.equal((await facts(page)).triangles, 18);
});

test("a tolerance that cannot be kept is refused in words, and the picture stays", async (t) => {
  const page = await openSurface(t, 'tolerance="0.01"');
  const before = await facts(page);
  await set(page, { tolerance: 1e-12 });
  await page.getByText(/tolerance/).waitFor();
  assert.equal((await facts(page)).triangles, before.triangles);
  await set(page, { tolerance: 0.02 });
  await page.getByText(/tolerance/).waitFor({ state: "detached" });
});
