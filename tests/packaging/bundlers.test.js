// The installed tarball through the bundlers; what they make is run.
import assert from "node:assert/strict";
import { build as esbuild } from "esbuild";
import { createRequire } from "node:module";
import { join } from "node:path";
import { after, test } from "node:test";
import { rollup } from "rollup";
import { build as vite } from "vite";
import { openPage } from "../page/browser.js";
import * as curves from "../../js/glue/curves-bytes.js";
import * as surfaces from "../../js/glue/surfaces-bytes.js";
import { serve } from "../page/server.js";
import { PRINTED, PROGRAM, installed, run } from "./fixture.js";

/** All that a page has to allow. */
const CSP = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'";

const fixture = await installed();
after(fixture.remove);
const entry = await fixture.write("src/main.js", PROGRAM);
const node = (path) => run(process.execPath, [path], { cwd: fixture.folder });

for (const [format, name] of /** @type {const} */ ([
  ["esm", "esbuild.mjs"],
  ["iife", "esbuild.cjs"],
])) {
  test(`esbuild, ${format}, minified`, async () => {
    const outfile = join(fixture.folder, "out", name);
    const { warnings } = await esbuild({
      entryPoints: [entry],
      bundle: true,
      format,
      minify: true,
      outfile,
      logLevel: "silent",
    });
    assert.deepEqual(warnings, []);
    assert.equal(await node(outfile), PRINTED);
  });
}

for (const format of /** @type {const} */ (["es", "iife"])) {
  test(`Rollup, ${format}`, async () => {
    const resolve = createRequire(entry).resolve;
    const plugin = { name: "resolve", resolveId: (id) => (id.startsWith("casteljau") ? resolve(id) : null) };
    const onwarn = (warning) => assert.fail(warning.message);
    const bundle = await rollup({ input: entry, plugins: [plugin], onwarn });
    const file = join(fixture.folder, "out", format === "es" ? "rollup.mjs" : "rollup.cjs");
    await bundle.write({ file, format });
    assert.equal(await node(file), PRINTED);
  });
}

/** A run of characters that only the text of one wasm module has. */
const mark = (text) => text.slice(1000, 1060);
const marks = { curves: mark(curves.text), surfaces: mark(surfaces.text) };
const LINE = `import { Curve, init } from "casteljau";\nawait init();\nconsole.log(new Curve([[0, 0], [2, 4]]).eval(0.5).y);\n`;

test("a program of curves carries no surfaces", async () => {
  const program = await fixture.write("src/line.js", LINE);
  const resolve = createRequire(program).resolve;
  const plugin = { name: "resolve", resolveId: (id) => (id.startsWith("casteljau") ? resolve(id) : null) };
  const rolled = await (await rollup({ input: program, plugins: [plugin] })).generate({ format: "es" });
  const built = await esbuild({ entryPoints: [program], bundle: true, format: "esm", minify: true, write: false });
  for (const [bundler, code] of [
    ["Rollup", rolled.output[0].code],
    ["esbuild", built.outputFiles[0].text],
  ]) {
    assert.ok(code.includes(marks.curves), bundler);
    assert.ok(!code.includes(marks.surfaces), bundler);
    assert.equal(await node(await fixture.write(`out/line-${bundler}.mjs`, code)), "2", bundler);
  }
});

/** Serves a built folder under the policy and gives back what the page prints. */
async function printedBy(t, folder) {
  const server = await serve({ "/": folder }, { "Content-Security-Policy": CSP });
  t.after(server.close);
  const page = await openPage(t, "about:blank", { baseURL: server.url });
  const printed = page.waitForEvent("console", (message) => message.type() === "log"); // the graphics driver has remarks, too
  await page.goto("/index.html");
  return (await printed).text();
}

const html = (script) => `<!doctype html><html lang="en"><title>A page</title>${script}</html>`;

test("Vite, the built page in Chromium under a strict policy", async (t) => {
  await fixture.write("index.html", html('<script type="module" src="/src/main.js"></script>'));
  const outDir = join(fixture.folder, "out/vite");
  await vite({ root: fixture.folder, configFile: false, logLevel: "error", build: { outDir } });
  assert.equal(await printedBy(t, outDir), PRINTED);
});

test("no bundler, the package's own file in Chromium under a strict policy", async (t) => {
  const folder = join(fixture.installed, "dist");
  await fixture.write("node_modules/casteljau/dist/main.js", PROGRAM.replace('"casteljau"', '"./index.js"'));
  await fixture.write("node_modules/casteljau/dist/index.html", html('<script type="module" src="main.js"></script>'));
  assert.equal(await printedBy(t, folder), PRINTED);
});

test("the elements in Chromium under the same policy, on the same core as the page's own program", async (t) => {
  const program = `import { Surface } from "./index.js";
import { BezierSurface } from "./elements.js";
const element = new BezierSurface();
element.surface = Surface.teapot({ lid: false });
document.body.append(element);
const facts = () => element.shadowRoot.querySelector(".facts").textContent;
element.addEventListener("update", () => /triangles/.test(facts()) && console.log(facts().match(/[\\d\\u2009]+/)[0]));
`;
  await fixture.write("node_modules/casteljau/dist/main.js", program);
  await fixture.write(
    "node_modules/casteljau/dist/index.html",
    html('<body><script type="module" src="main.js"></script></body>'),
  );
  assert.equal(await printedBy(t, join(fixture.installed, "dist")), "6\u2009912"); // 24 patches of 2 · 12² triangles
});
