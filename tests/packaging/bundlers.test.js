// The installed tarball through the bundlers: each with each entry point; what they make is run, in Node or in Chromium under a strict
// policy.
import assert from "node:assert/strict";
import { build as esbuild, transform } from "esbuild";
import { readdir, readFile } from "node:fs/promises";
import { join } from "node:path";
import { after, test } from "node:test";
import { gzipSync } from "node:zlib";
import { rollup } from "rollup";
import { build as vite } from "vite";
import webpack from "webpack";
import { openPage } from "../page/browser.js";
import * as coreSurfaces from "../../js/glue/core-surfaces-bytes.js";
import * as curves from "../../js/glue/curves-bytes.js";
import * as nurbsSurfaces from "../../js/glue/nurbs-surfaces-bytes.js";
import * as surfaces from "../../js/glue/surfaces-bytes.js";
import { serve } from "../page/server.js";
import { ELEMENTS_PRINTED, ELEMENTS_PROGRAM, PRINTED, PROGRAM, installed, run } from "./fixture.js";

/** All that a page has to allow; the styles of elements are sheets of their own, which no policy forbids. */
const CSP = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'";

const fixture = await installed();
after(fixture.remove);
const out = (name) => join(fixture.folder, "out", name);
const node = (path) => run(process.execPath, [path], { cwd: fixture.folder });

/** Bundles by webpack. @param {import("webpack").Configuration} options */
async function packed(options) {
  const stats = await new Promise((done, failed) =>
    webpack({ mode: "production", performance: false, ...options }, (error, result) =>
      error ? failed(error) : done(result),
    ),
  );
  assert.equal(stats.toString({ all: false, errors: true, warnings: true }), "");
}

/** Bundles by esbuild. @param {import("esbuild").BuildOptions} options */
async function bundled(options) {
  const { warnings } = await esbuild({ bundle: true, format: "esm", minify: true, logLevel: "silent", ...options });
  assert.deepEqual(warnings, []);
}

/** Bundles by Rollup. @param {import("rollup").OutputOptions} output */
async function rolled(input, output) {
  const onwarn = (warning) => assert.fail(warning.message);
  await (await rollup({ input, plugins: [fixture.resolvePlugin], onwarn })).write(output);
}

/** Bundles by Vite. @param {import("vite").InlineConfig} options */
const built = (options) => vite({ root: fixture.folder, configFile: false, logLevel: "error", ...options });

/** Writes main.js and what it needs into a folder. @type {Record<string, (program: string, folder: string) => Promise<unknown>>} */
const BUNDLERS = {
  esbuild: (main, outdir) => bundled({ entryPoints: { main }, splitting: true, outdir }),
  Rollup: (input, dir) => rolled(input, { dir, format: "es", entryFileNames: "main.js" }),
  webpack: (entry, path) => packed({ entry, output: { path, filename: "main.js", publicPath: "auto" } }),
  Vite: (input, outDir) =>
    built({
      build: {
        ...{ outDir, modulePreload: { polyfill: false } },
        rollupOptions: { input, output: { entryFileNames: "main.js" }, preserveEntrySignatures: "strict" },
      },
    }),
};

/** A run of characters that only the text of one wasm module has. */
const mark = (text) => text.slice(1000, 1060);
const marks = { curves: mark(curves.text), surfaces: mark(surfaces.text) };

/** A surface with weights, whose curves need another entry point: both have the same classes. */
const WEIGHTS_PROGRAM = `import "casteljau/elements/surface";
const element = document.createElement("bezier-surface");
Object.assign(element, { model: "sphere", show: "surface isocurves" });
document.body.append(element);
const drawn = async () => {
  if (element.surface.patchCount !== 8 || !element.figure.mesh.triangles) return;
  element.removeEventListener("update", drawn);
  const { RationalSurface } = await import("casteljau/nurbs");
  const meridian = element.surface.patch(0).isocurveAtU(0);
  console.log(element.surface instanceof RationalSurface, meridian.curvature(0.3).toFixed(6));
};
element.addEventListener("update", drawn);
`;

/** The gzip size of `{ easing }`, minified; `from` and `spring` take 1.1 kB of it, hints in messages 0.1, the hulls of `toLinear` 0.2. */
const MAX_EASING_KB = 6.5;

/**
 * A program for each entry point, and what it prints; which text the output has and has not, its largest size, and whether it
 * needs a page.
 *
 * @type {Record<string, { program: string, printed: string, has?: string, lacks?: string[], maxKb?: number, isPage?: boolean }>}
 */
const ENTRIES = {
  casteljau: { program: PROGRAM, printed: PRINTED, has: marks.curves, lacks: [marks.surfaces] },
  "casteljau/core": {
    program: 'import { Path } from "casteljau/core";\nconsole.log(Path.rect([0, 0], 2, 3).length());\n',
    printed: "10",
    lacks: Object.values(marks),
  },
  "casteljau/nurbs": {
    program:
      'import { RationalCurve } from "casteljau/nurbs";\nconsole.log(RationalCurve.conic([1, 0], [1, 1], [0, 1], Math.SQRT1_2).curvature(0.3).toFixed(6));\n',
    printed: "1.000000",
    lacks: [...Object.values(marks), mark(nurbsSurfaces.text)],
  },
  "casteljau/surfaces": {
    program:
      'import { Surface } from "casteljau/surfaces";\nconsole.log(Surface.teapot({ lid: false }).patch(9).degreeU);\n',
    printed: "3",
    lacks: Object.values(marks),
  },
  "casteljau/easing": {
    program: 'import { easing } from "casteljau/easing";\nconsole.log(easing("ease-in-out")(0.5));\n',
    printed: "0.5",
    lacks: Object.values(marks),
    maxKb: MAX_EASING_KB,
  },
  "casteljau/elements": { program: ELEMENTS_PROGRAM, printed: ELEMENTS_PRINTED, isPage: true },
  "casteljau/elements/surface": { program: WEIGHTS_PROGRAM, printed: "true 0.500000", isPage: true },
};

for (const [bundler, bundle] of Object.entries(BUNDLERS))
  for (const [entry, { program, printed, has = "", lacks = [], maxKb, isPage }] of Object.entries(ENTRIES))
    test(`${bundler}: ${entry}`, async (t) => {
      const name = `${bundler}-${entry.replaceAll("/", "-")}`;
      const folder = join(fixture.folder, "out", name);
      await bundle(await fixture.write(`src/${name}.js`, program), folder);
      const files = (await readdir(folder, { recursive: true })).filter((each) => each.endsWith(".js"));
      const code = (await Promise.all(files.map((each) => readFile(join(folder, each), "utf8")))).join("\n");
      assert.ok(code.includes(has));
      for (const text of lacks) assert.ok(!code.includes(text), "a wasm module that is not used");
      if (maxKb) {
        const { code: minified } = await transform(code, { minify: true, charset: "utf8" });
        const size = gzipSync(minified, { level: 9 }).length;
        assert.ok(size <= 1000 * maxKb, `${size} bytes`);
      }
      if (!isPage) return assert.equal(await node(join(folder, "main.js")), printed);
      await fixture.write(`out/${name}/index.html`, html('<script type="module" src="main.js"></script>'));
      assert.ok(files.length > 1, "what draws is a file of its own");
      assert.equal(await printedBy(t, folder), printed);
    });

/** A page with one easing editor; it prints when the editor is shown. */
const EASING_PROGRAM = `import "casteljau/elements";
document.body.innerHTML = "<bezier-easing></bezier-easing>";
const look = () => {
  const root = document.querySelector("bezier-easing").shadowRoot;
  if (root?.querySelector("[part=handle]")) console.log("shown");
  else requestAnimationFrame(look);
};
look();
`;
const MAX_EASING_EDITOR_KB = 45;

for (const [bundler, bundle] of Object.entries(BUNDLERS))
  test(`${bundler}: casteljau/elements loads nothing of curves and surfaces for an easing editor`, async (t) => {
    const name = `${bundler}-easing-editor`;
    const folder = out(name);
    await bundle(await fixture.write(`src/${name}.js`, EASING_PROGRAM), folder);
    await fixture.write(`out/${name}/index.html`, html('<script type="module" src="main.js"></script>'));
    /** @type {string[]} */
    const paths = [];
    assert.equal(await printedBy(t, folder, paths), "shown");
    const scripts = await Promise.all(paths.map((path) => readFile(join(folder, path), "utf8")));
    for (const text of [marks.curves, mark(coreSurfaces.text)])
      assert.ok(!scripts.some((script) => script.includes(text)), "a wasm module");
    let size = 0;
    for (const script of scripts) {
      const { code } = await transform(script, { minify: true, charset: "utf8", legalComments: "none" });
      size += gzipSync(code, { level: 9 }).length;
    }
    assert.ok(size <= 1000 * MAX_EASING_EDITOR_KB, `${size} bytes`);
  });

const main = await fixture.write("src/main.js", PROGRAM);
/** Other formats of a bundle: the file to run. @type {Record<string, () => Promise<string>>} */
const FORMATS = {
  "esbuild, a script": async () => {
    await bundled({ entryPoints: [main], format: "iife", outfile: out("script.cjs") });
    return out("script.cjs");
  },
  "esbuild for Node": async () => {
    await bundled({ entryPoints: [main], platform: "node", format: "cjs", minify: false, outfile: out("node.cjs") });
    return out("node.cjs");
  },
  "Rollup, a script": async () => {
    await rolled(main, { file: out("rollup.cjs"), format: "iife" });
    return out("rollup.cjs");
  },
  "webpack for Node": async () => {
    await packed({ entry: main, target: "node20", output: { path: out("webpack-node"), filename: "main.cjs" } });
    return out("webpack-node/main.cjs");
  },
  "Vite for a server, with the package outside": async () => {
    await built({ build: { ssr: main, outDir: out("ssr") } });
    return out("ssr/main.js");
  },
  "Vite for a server, with the package inside": async () => {
    await built({ build: { ssr: main, outDir: out("ssr-inside") }, ssr: { noExternal: true } });
    return out("ssr-inside/main.js");
  },
};
for (const [name, make] of Object.entries(FORMATS))
  test(name, async () => assert.equal(await node(await make()), PRINTED));

/**
 * Serves a built folder under the policy and gives back what the page prints.
 *
 * @param {import("node:test").TestContext} t
 * @param {string} folder
 * @param {string[]} [scripts] gets the paths of all scripts that the page loads
 */
async function printedBy(t, folder, scripts = []) {
  const server = await serve({ "/": folder }, { "Content-Security-Policy": CSP });
  t.after(server.close);
  const page = await openPage(t, "about:blank", { baseURL: server.url });
  page.on("request", (request) => {
    if (request.resourceType() === "script") scripts.push(new URL(request.url()).pathname);
  });
  const printed = page.waitForEvent("console", (message) => message.type() === "log"); // the graphics driver has remarks, too
  await page.goto("/index.html");
  return (await printed).text();
}

const html = (script) => `<!doctype html><html lang="en"><title>A page</title><body>${script}</body></html>`;

test("Vite, the built page", async (t) => {
  await fixture.write("index.html", html('<script type="module" src="/src/main.js"></script>'));
  await built({ build: { outDir: out("vite-page") } });
  assert.equal(await printedBy(t, out("vite-page")), PRINTED);
});

test("no bundler, the package's own file", async (t) => {
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
