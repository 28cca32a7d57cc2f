// The elements of the installed tarball, as they are and as the guide says, in Chromium under a strict policy; bundlers.test.js has
// them through the bundlers.
import assert from "node:assert/strict";
import { build as esbuild } from "esbuild";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { after, test } from "node:test";
import { openPage, root } from "../page/browser.js";
import { serve } from "../page/server.js";
import { ELEMENTS_PRINTED, ELEMENTS_PROGRAM, installed } from "./fixture.js";

/** All that a page has to allow for the elements; their styles are sheets of their own, which no policy forbids. */
const CSP = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'";
const LATE = /surface/;

const fixture = await installed();
after(fixture.remove);

const page = (script) => `<!doctype html><html lang="en"><title>A page</title><body>${script}</body></html>`;
const entry = await fixture.write("src/main.js", ELEMENTS_PROGRAM);

/** Serves a folder under the policy; what the page prints, and the scripts it has fetched by then. */
async function visit(t, folder, path = "/index.html") {
  const server = await serve({ "/": folder }, { "Content-Security-Policy": CSP });
  t.after(server.close);
  const page = await openPage(t, "about:blank", { baseURL: server.url });
  const scripts = [];
  page.on("request", (request) => request.resourceType() === "script" && scripts.push(new URL(request.url()).pathname));
  const printed = page.waitForEvent("console", (message) => message.type() === "log");
  await page.goto(path);
  return { printed: (await printed).text(), scripts };
}

test("esbuild, one classic script", async (t) => {
  await fixture.write("out/iife/index.html", page('<script src="main.js"></script>'));
  await esbuild({
    entryPoints: [entry],
    bundle: true,
    format: "iife",
    minify: true,
    outfile: join(fixture.folder, "out/iife/main.js"),
    logLevel: "silent",
  });
  const { printed, scripts } = await visit(t, join(fixture.folder, "out/iife"));
  assert.deepEqual([printed, scripts], [ELEMENTS_PRINTED, ["/main.js"]]);
});

test("no bundler: one script tag, and tags of HTML", async (t) => {
  const folder = join(fixture.installed, "dist");
  await fixture.write(
    "node_modules/casteljau/dist/probe.js",
    `const element = document.querySelector("bezier-surface");
element.addEventListener("update", () => {
  const facts = element.shadowRoot.querySelector(".facts").textContent;
  if (/triangles/.test(facts)) console.log(facts.match(/[\\d,]+/)[0]);
});\n`,
  );
  const lines =
    '<script type="module" src="elements.js"></script><bezier-surface model="patch"></bezier-surface><script src="probe.js"></script>';
  await fixture.write("node_modules/casteljau/dist/tag.html", page(lines));
  const { printed, scripts } = await visit(t, folder, "/tag.html");
  assert.equal(printed, "288"); // 2 · 12²
  assert.deepEqual(
    scripts.filter((path) => LATE.test(path)),
    ["/elements/surface.js", "/surfaces.js", "/elements-surface.js"],
  );
});

/** The pieces of code that a section of the site's guide shows. */
async function documented(section) {
  const guide = await readFile(`${root}www/elements/index.md`, "utf8");
  const part = guide.split(/^## /m).find((text) => text.includes(`{#${section}}`)) ?? "";
  return [...part.matchAll(/^```(?:html|js)\n([\s\S]*?)^```/gm)].map(([, code]) => code);
}

test("the lines of the guide, from a copied folder and from npm", async (t) => {
  const [tags] = await documented("script");
  const [program] = await documented("npm");
  assert.match(tags, /<script type="module" src="casteljau\/dist\/elements\.js">/);
  const path = await fixture.write(
    "src/guide.js",
    `${program}\nglobalThis.ready = true; globalThis.save = (state) => (globalThis.saved = state);`,
  );
  const outdir = join(fixture.folder, "out/guide");
  await esbuild({
    entryPoints: [path],
    bundle: true,
    format: "esm",
    splitting: true,
    minify: true,
    outdir,
    logLevel: "silent",
  });
  const server = await serve(
    { "/casteljau/": fixture.installed, "/built/": outdir },
    { "Content-Security-Policy": CSP },
  );
  const site = await openPage(t, "about:blank", { baseURL: server.url, viewport: { width: 900, height: 1600 } });
  t.after(server.close);
  for (const script of ["", '<script type="module" src="built/guide.js"></script>']) {
    server.pages.set("/index.html", page(script ? tags.replace(/<script.*<\/script>/, script) : tags));
    await site.goto("/index.html");
    const slider = site.locator('bezier-bernstein input[type="range"]');
    await slider.focus();
    await slider.press("ArrowRight");
    await site.waitForFunction(() => {
      const applet = /** @type {any} */ (document.querySelector("bezier-applet"));
      return Math.abs(applet.t - 0.31) < 1e-9 && applet.points.length === 4;
    });
    if (script) assert.equal((await site.evaluate(() => /** @type {any} */ (globalThis).saved)).t, 0.31);
  }
});
