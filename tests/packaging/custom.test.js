// Modules that the installed command `casteljau custom` makes, in Node, through the bundlers and in a page.
import assert from "node:assert/strict";
import { build as esbuild } from "esbuild";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { rollup } from "rollup";
import { build as vite } from "vite";
import webpack from "webpack";
import { openPage } from "../page/browser.js";
import { serve } from "../page/server.js";
import { installed, run } from "./fixture.js";

const fixture = await installed();
after(fixture.remove);

const PROGRAM = `import { Curve, Path } from "./bezier.js";
const corner = Path.fromSVG("M0 0H3V4").pointAtLength(5).point;
const length = new Curve([[0, 0], [1, 2], [2, 0]]).length();
let message = "";
try { new Curve([[0, 0], [1, 1]]).bounds(); } catch (error) { message = error.message; }
console.log(JSON.stringify([corner, Math.abs(length - 2.9578857150891947) < 1e-12, message]));
`;
const WORDS = "npx casteljau custom Curve.length Path.fromSVG Path.pointAtLength --out src/bezier.js";
/** y = 2x − x² from 0 to 2 has the length √5 + ½ asinh 2. */
const PRINTED = JSON.stringify([{ x: 3, y: 2 }, true, `Curve.bounds is not in this build; add it: ${WORDS}`]);

let entry = "";
before(async () => {
  entry = await fixture.write("src/main.js", PROGRAM);
  const [, ...args] = WORDS.split(" ");
  await run("npx", ["--no-install", ...args], { cwd: fixture.folder });
});
const node = (path) => run(process.execPath, [path], { cwd: fixture.folder });

test("custom, as a plain file in Node", async () => assert.equal(await node(entry), PRINTED));

for (const [format, name] of /** @type {const} */ ([
  ["esm", "custom-esbuild.mjs"],
  ["iife", "custom-esbuild.cjs"],
]))
  test(`custom, esbuild, ${format}, minified`, async () => {
    const outfile = join(fixture.folder, "out", name);
    const { warnings } = await esbuild({ entryPoints: [entry], bundle: true, format, minify: true, outfile });
    assert.deepEqual(warnings, []);
    assert.equal(await node(outfile), PRINTED);
  });

test("custom, Rollup", async () => {
  const bundle = await rollup({ input: entry, onwarn: (warning) => assert.fail(warning.message) });
  const file = join(fixture.folder, "out/custom-rollup.mjs");
  await bundle.write({ file, format: "es" });
  assert.equal(await node(file), PRINTED);
});

test("custom, webpack", async () => {
  const path = join(fixture.folder, "out/custom-webpack");
  /** @type {import("webpack").Configuration} */
  const options = { entry, mode: "production", output: { path, filename: "main.cjs" } };
  const stats = await new Promise((done, failed) =>
    webpack(options, (error, result) => (error ? failed(error) : done(result))),
  );
  assert.equal(stats.toString({ all: false, errors: true, warnings: true }), "");
  assert.equal(await node(join(path, "main.cjs")), PRINTED);
});

const POLICY = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'";
/** Serves a folder under the policy and gives back what the page prints. */
async function printedBy(t, folder) {
  const server = await serve({ "/": folder }, { "Content-Security-Policy": POLICY });
  t.after(server.close);
  const page = await openPage(t, "about:blank", { baseURL: server.url });
  const printed = page.waitForEvent("console", (message) => message.type() === "log");
  await page.goto("/index.html");
  return (await printed).text();
}
const html = (src) =>
  `<!doctype html><html lang="en"><title>A page</title><script type="module" src="${src}"></script></html>`;

test("custom, no bundler, in Chromium under a strict policy", async (t) => {
  await fixture.write("src/index.html", html("main.js"));
  assert.equal(await printedBy(t, join(fixture.folder, "src")), PRINTED);
});

test("custom, Vite, the built page in Chromium under a strict policy", async (t) => {
  await fixture.write("index.html", html("/src/main.js"));
  const outDir = join(fixture.folder, "out/custom-vite");
  await vite({ root: fixture.folder, configFile: false, logLevel: "error", build: { outDir } });
  assert.equal(await printedBy(t, outDir), PRINTED);
});

test("custom, the types are found beside the module", async () => {
  const types = await readFile(join(fixture.folder, "src/bezier.d.ts"), "utf8");
  assert.ok(types.startsWith(`/*! ${WORDS} |`));
  assert.match(types, /^export \{ .*\bCurve\b.*\bPath\b.* \};$/m);
});
