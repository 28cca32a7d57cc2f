// What the tarball holds, and what the judges of packages say about it.
import assert from "node:assert/strict";
import { readdir, readFile, stat } from "node:fs/promises";
import { SourceMap } from "node:module";
import { join } from "node:path";
import { after, test } from "node:test";
import { fileURLToPath } from "node:url";
import { transform } from "esbuild";
import { publint } from "publint";
import { formatMessage } from "publint/utils";
import { installed, run } from "./fixture.js";

const root = fileURLToPath(new URL("../../", import.meta.url));
const fixture = await installed();
after(fixture.remove);

test("the tarball holds dist and the texts, nothing else", async () => {
  const names = (await run("tar", ["-tzf", fixture.tarball])).split("\n").map((name) => name.replace("package/", ""));
  const expected = [
    /^dist\/(index|core|surfaces|nurbs(-rational-curve)?|weights-[a-z-]+|easing|slim|casteljau\.global|types-only|applet|bezier-app|shared-[a-z-]+(-\d)?)\.js(\.map)?$/,
    /^dist\/custom\/(command\.js|needs\.json|pieces\.json)$/,
    /^dist\/elements(-(shared-[a-z-]+(-\d)?|surface(-rational)?|applet|bernstein|coordinates|easing|equation|rational))?\.js(\.map)?$/,
    /^dist\/elements\/(applet|bernstein|coordinates|easing|equation|surface)\.js(\.map)?$/,
    /^dist\/node\/(index|shared-[a-z-]+)\.js$/,
    /^dist\/(casteljau\.wasm|custom-elements\.json|texts\.json|THIRD-PARTY-NOTICES\.txt|types\/[\w/-]+\.d\.ts)$/,
    /^(package\.json|README\.md|docs\/(applet\.png|migration\.md)|CHANGELOG\.md|LICENSE-(MIT|APACHE))$/,
  ];
  assert.deepEqual(
    names.filter((name) => !expected.some((pattern) => pattern.test(name))),
    [],
  );
});

test("no file of the tarball names a folder of the machine that built it", async () => {
  const names = (await readdir(join(fixture.installed, "dist"))).filter((name) => /\.(js|map|wasm|txt)$/.test(name));
  assert.ok(names.length > 20);
  for (const name of names) {
    const text = await readFile(join(fixture.installed, "dist", name), "latin1");
    assert.doesNotMatch(text, /\/(home|root|Users|work)\/|\.cargo\/registry|\.rustup/, name);
  }
});

/**
 * The largest tarball; a change that raises it gives the reason. Half of it are the seven wasm modules, each in the bundles that use it.
 * The builder, path data, texts of transforms, three.js shapes and springs added 40 kB, most of it in source maps.
 * Boolean operations and strokes added 100 kB of wasm to each of two bundles and to casteljau.wasm, and their sources to the source maps.
 * The files for Node and the entry points of single elements added 30 kB.
 * The grid of Boolean operations, rates of chords and `simplify` of paths added 30 kB.
 * Strokes of varying width added 40 kB: 13 kB of wasm in each of two bundles and in casteljau.wasm.
 * Hints in messages, arcs of many cubics, and the search for discs in thin contours added 20 kB.
 * Trees of boxes for many subpaths and `Path.index` added 10 kB, in each bundle with paths and its source map.
 * The command `casteljau custom` added 110 kB: the package as pieces, and the command.
 * Paths and measures in casteljau/core added 80 kB: its module, and their sources in its source map. Strokes with two widths, a
 * radius for each corner and lists of parameters added 20 kB, colours and full screen of the elements 20 kB.
 * casteljau/nurbs added 300 kB: its bundle with its module, its source map, and the weights of the applet; its surfaces 230 kB: a
 * second module and their sources in the source map.
 */
const MAX_TARBALL_KB = 4150;

test("the tarball stays within its budget", async () => {
  const { size } = await stat(fixture.tarball);
  assert.ok(size <= 1000 * MAX_TARBALL_KB, `${size} bytes`);
});

const dist = (name) => readFile(join(fixture.installed, "dist", name), "utf8");

/** Scripts for <script src> without type="module", which take the encoding of the page. */
const CLASSIC_SCRIPTS = ["bezier-app.js", "casteljau.global.js"];

for (const name of CLASSIC_SCRIPTS) {
  test(`${name} is ASCII: it means the same on a page of any encoding`, async () => {
    const text = await readFile(join(fixture.installed, "dist", name), "latin1");
    assert.deepEqual([...new Set(text.match(/[^\0-\x7f]/g))], []);
  });
}

test("scripts are minified, and have a source map without the wasm text", async () => {
  const names = (await readdir(join(fixture.installed, "dist"))).filter((name) => name.endsWith(".js"));
  for (const name of names) {
    const code = await dist(name);
    const charset = CLASSIC_SCRIPTS.includes(name) ? "ascii" : "utf8";
    const { code: minified } = await transform(code, { minify: true, charset });
    assert.ok(code.length <= 1.02 * minified.length + 200, `${name}: ${code.length}, could be ${minified.length}`);
    assert.equal(code.match(/\/\/# sourceMappingURL=(\S+)/)?.[1], `${name}.map`);
    const { sources, sourcesContent } = JSON.parse(await dist(`${name}.map`));
    sources.forEach((source, k) => {
      assert.match(source, /^\.\.\/(js|node_modules|xtask)\//);
      assert.equal(sourcesContent[k] === null, source.endsWith("-bytes.js"), source);
    });
  }
});

test("source maps lead to the places in the sources, behind edits of the built file as well", async () => {
  // A text that minification does not change; in the last file it follows imports that were edited.
  for (const [name, text] of [
    ["shared-curves.js", '"expected a number from 0 to 1, got "'],
    ["shared-curves.js", "casteljau/slim carries no wasm"],
    ["elements-shared-loading.js", "import("],
  ]) {
    const lines = (await dist(name)).split("\n");
    const needle = text.replace(/^"expected/, "expected").replace(/ got "$/, "");
    const [line, column] = lines.map((each, k) => [k, each.lastIndexOf(needle)]).find(([, at]) => at >= 0) ?? [-1, -1];
    assert.ok(line >= 0, `${name}: ${needle}`);
    const map = JSON.parse(await dist(`${name}.map`));
    const entry = /** @type {any} */ (new SourceMap(map).findEntry(line, column));
    const source = map.sourcesContent[map.sources.indexOf(entry.originalSource)].split("\n");
    const nearby = source.slice(entry.originalLine, entry.originalLine + 2).join("\n");
    assert.ok(nearby.includes(needle), `${name}: ${needle} leads to ${nearby}`);
  }
});

test("the notices of everything that is built in are there", async () => {
  const notices = await dist("THIRD-PARTY-NOTICES.txt");
  const names = (await readdir(join(fixture.installed, "dist"))).filter((name) => name.endsWith(".map"));
  const sources = (await Promise.all(names.map(async (name) => JSON.parse(await dist(name)).sources))).flat();
  const folders = sources.flatMap((source) => source.match(/node_modules\/((?:@[^/]+\/)?[^/]+)/)?.[1] ?? []);
  assert.ok(folders.includes("lit-html"));
  for (const folder of new Set(folders)) {
    const license = (await readFile(join(root, "node_modules", folder, "package.json"), "utf8")).match(
      /"version": "(.*?)"/,
    );
    assert.ok(notices.includes(`\n${folder} ${license?.[1]}\n`), folder);
  }
  for (const text of ["Copyright (c) 2017 Google LLC", "glam", "wasm-bindgen", "wide", "talc"])
    assert.ok(notices.includes(text), text);
  assert.doesNotMatch(notices, /\nserde_json /, "only what is in the wasm modules");
});

test("publint has nothing to say", async () => {
  const { messages, pkg } = await publint({ pkgDir: fixture.installed, strict: true });
  assert.deepEqual(
    messages.map((message) => formatMessage(message, pkg, { color: false })),
    [],
  );
});

test("attw has nothing to say", async () => {
  const attw = join(root, "node_modules/@arethetypeswrong/cli/dist/index.js");
  const options = ["--profile", "esm-only", "--exclude-entrypoints", "./casteljau.wasm"]; // a file, no module
  await run(process.execPath, [attw, fixture.tarball, "--no-emoji", "--no-color", ...options]);
});

for (const resolution of ["nodenext", "bundler"]) {
  test(`a strict TypeScript program finds the types (${resolution})`, async () => {
    const program = `import { Curve, init } from "casteljau";
import { easing, type Easing } from "casteljau/easing";
import * as slim from "casteljau/slim";
import { bezierApp } from "casteljau/applet";
import { loadElement } from "casteljau/elements";
import { BezierSurface } from "casteljau/elements/surface";
export const x: number = new Curve([[0, 0], [1, 2], [2, 0]]).eval(0.5).x;
export const ease: Easing = easing("ease-in-out");
export const text: string = easing(0, 0, 1, 1).toLinear(0.01) + ease.css;
// @ts-expect-error: three numbers
easing(0, 0, 1);
export const both: Promise<void>[] = [init(), slim.init(fetch("casteljau.wasm"))];
export const app: Function = bezierApp;
export const isRotating: boolean = new BezierSurface().autoRotate;
export const loaded: Promise<void> = loadElement("bezier-surface");
// @ts-expect-error: a curve is made of points
new Curve(7);
`;
    const path = await fixture.write(`types-${resolution}.ts`, program);
    const module = resolution === "nodenext" ? "nodenext" : "esnext";
    const options = ["--strict", "--noEmit", "--target", "es2022", "--lib", "es2022,dom", "--types", ""];
    const tsc = join(root, "node_modules/typescript/bin/tsc");
    const all = [tsc, ...options, "--module", module, "--moduleResolution", resolution, "--ignoreConfig", path];
    await run(process.execPath, all, { cwd: fixture.folder });
  });
}
