// The installed tarball through the bundlers; what they make is run.
import assert from "node:assert/strict";
import { build as esbuild, transform } from "esbuild";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { after, test } from "node:test";
import { gzipSync } from "node:zlib";
import { rollup } from "rollup";
import { build as vite } from "vite";
import webpack from "webpack";
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

test("esbuild for Node, a CommonJS file", async () => {
  const outfile = join(fixture.folder, "out/esbuild-node.cjs");
  const { warnings } = await esbuild({
    entryPoints: [entry],
    bundle: true,
    platform: "node",
    format: "cjs",
    outfile,
    logLevel: "silent",
  });
  assert.deepEqual(warnings, []);
  assert.equal(await node(outfile), PRINTED);
});

test("webpack for Node", async () => {
  const path = join(fixture.folder, "out/webpack-node");
  /** @type {import("webpack").Configuration} */
  const options = { entry, target: "node20", mode: "production", output: { path, filename: "main.cjs" } };
  const stats = await new Promise((done, failed) =>
    webpack(options, (error, result) => (error ? failed(error) : done(result))),
  );
  assert.equal(stats.toString({ all: false, errors: true, warnings: true }), "");
  assert.equal(await node(join(path, "main.cjs")), PRINTED);
});

for (const noExternal of [false, true]) {
  test(`Vite for a server, ${noExternal ? "with the package inside" : "with the package outside"}`, async () => {
    const outDir = join(fixture.folder, `out/vite-ssr-${noExternal}`);
    const build = { ssr: entry, outDir };
    const ssr = noExternal ? { noExternal } : {};
    await vite({ root: fixture.folder, configFile: false, logLevel: "error", build, ssr });
    assert.equal(await node(join(outDir, "main.js")), PRINTED);
  });
}

for (const format of /** @type {const} */ (["es", "iife"])) {
  test(`Rollup, ${format}`, async () => {
    const onwarn = (warning) => assert.fail(warning.message);
    const bundle = await rollup({ input: entry, plugins: [fixture.resolvePlugin], onwarn });
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
  const rolled = await (await rollup({ input: program, plugins: [fixture.resolvePlugin] })).generate({ format: "es" });
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

/** The gzip size of `{ easing }` from casteljau/easing, bundled and minified; `from` and `spring` take 1.1 kB of it, hints in messages 0.1, the hulls of `toLinear` 0.2. */
const MAX_EASING_KB = 6.5;
const EASING = `import { easing } from "casteljau/easing";\nconsole.log(easing("ease-in-out")(0.5));\n`;

/** The code that each bundler makes of a program, minified by esbuild afterwards. */
const bundlers = {
  async esbuild(input) {
    const options = { entryPoints: [input], bundle: true, format: /** @type {const} */ ("esm"), write: false };
    return (await esbuild(options)).outputFiles?.[0].text;
  },
  async Rollup(input) {
    return (await (await rollup({ input, plugins: [fixture.resolvePlugin] })).generate({ format: "es" })).output[0]
      .code;
  },
  async Vite(input) {
    const build = { write: false, rollupOptions: { input, preserveEntrySignatures: /** @type {const} */ ("strict") } };
    const built = await vite({ root: fixture.folder, configFile: false, logLevel: "error", build });
    return /** @type {any} */ (built).output[0].code;
  },
  async webpack(entry) {
    const path = join(fixture.folder, "out/webpack-easing");
    /** @type {import("webpack").Configuration} */
    const options = { entry, mode: "production", output: { path, filename: "main.js" } };
    const stats = await new Promise((done, failed) =>
      webpack(options, (error, result) => (error ? failed(error) : done(result))),
    );
    assert.equal(stats.toString({ all: false, errors: true, warnings: true }), "");
    return readFile(join(path, "main.js"), "utf8");
  },
};

for (const [bundler, code] of Object.entries(bundlers)) {
  test(`${bundler}: a small import stays small`, async () => {
    const program = await fixture.write(`src/easing-${bundler}.js`, EASING);
    const text = (await code(program)) ?? "";
    const { code: minified } = await transform(text, { minify: true, charset: "utf8" });
    const size = gzipSync(minified, { level: 9 }).length;
    assert.ok(size <= 1000 * MAX_EASING_KB, `${size} bytes`);
    assert.equal(await node(await fixture.write(`out/easing-${bundler}.mjs`, text)), "0.5");
  });
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

test("the first example of the README draws on a canvas", async (t) => {
  const readme = await readFile(join(fixture.installed, "README.md"), "utf8");
  const example = readme.match(/^```js canvas\n([\s\S]*?)^```$/m)?.[1] ?? "";
  const check = "console.log(context.getImageData(0, 0, 300, 150).data.filter((byte) => byte > 0).length > 300);\n";
  const program = await fixture.write("src/canvas.js", example + check);
  const outdir = join(fixture.folder, "out/canvas");
  await esbuild({ entryPoints: { main: program }, bundle: true, format: "esm", minify: true, outdir });
  await fixture.write("out/canvas/index.html", html('<canvas></canvas><script type="module" src="main.js"></script>'));
  assert.equal(await printedBy(t, outdir), "true");
});

/** The program as a classic script that uses the global variable. */
const CLASSIC = PROGRAM.replace(/^import (.*) from .*$/m, "const $1 = casteljau;");

test("a script tag defines casteljau", async (t) => {
  const folder = join(fixture.installed, "dist");
  await fixture.write("node_modules/casteljau/dist/main.js", CLASSIC);
  const scripts = '<script src="casteljau.global.js"></script><script src="main.js"></script>';
  await fixture.write("node_modules/casteljau/dist/index.html", html(scripts));
  assert.equal(await printedBy(t, folder), PRINTED);
});

for (const [kind, worker, options] of [
  ["classic", `importScripts("casteljau.global.js");\n${CLASSIC}`, "{}"],
  ["module", PROGRAM.replace('"casteljau"', '"./index.js"'), '{ type: "module" }'],
]) {
  test(`a ${kind} worker`, async (t) => {
    const folder = join(fixture.installed, "dist");
    await fixture.write("node_modules/casteljau/dist/worker.js", worker.replace("console.log", "postMessage"));
    const main = `new Worker("worker.js", ${options}).onmessage = ({ data }) => console.log(data);\n`;
    await fixture.write("node_modules/casteljau/dist/main.js", main);
    await fixture.write("node_modules/casteljau/dist/index.html", html('<script src="main.js"></script>'));
    assert.equal(await printedBy(t, folder), PRINTED);
  });
}

test("the elements in Chromium under the same policy, with a value of the page's own program", async (t) => {
  const program = `import { Surface } from "./index.js";
import { BezierSurface } from "./elements.js";
const element = new BezierSurface();
element.surface = Surface.teapot({ lid: false });
document.body.append(element);
const facts = () => element.shadowRoot.querySelector(".facts").textContent;
element.addEventListener("update", () => /triangles/.test(facts()) && console.log(facts().match(/[\\d,]+/)[0]));
`;
  await fixture.write("node_modules/casteljau/dist/main.js", program);
  await fixture.write(
    "node_modules/casteljau/dist/index.html",
    html('<body><script type="module" src="main.js"></script></body>'),
  );
  assert.equal(await printedBy(t, join(fixture.installed, "dist")), "6,912"); // 24 patches of 2 · 12² triangles
});
