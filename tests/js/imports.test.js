// The import graph of js/.
import assert from "node:assert/strict";
import { dirname, join, posix } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const root = join(dirname(fileURLToPath(import.meta.url)), "../..");
const ENTRIES = [
  "index",
  "paths",
  "core",
  "surfaces",
  "easing",
  "applet/index",
  "applet/classic",
  "elements/index",
].map((name) => `js/${name}.ts`);

/** For each file, the files that it imports, statically or on demand. */
async function importGraph() {
  const output = /** @type {const} */ ({ format: "esm", outdir: "unused", splitting: true, write: false });
  const input = /** @type {const} */ ({
    entryPoints: ENTRIES,
    absWorkingDir: root,
    bundle: true,
    packages: "external",
  });
  const { metafile } = await build({ ...input, ...output, metafile: true });
  const files = Object.entries(metafile.inputs);
  return new Map(files.map(([file, { imports }]) => [file, imports.filter((i) => !i.external).map((i) => i.path)]));
}

/** All files that a file imports, directly or indirectly. */
function reachable(graph, from, found = new Set()) {
  for (const file of graph.get(from) ?? []) {
    if (found.has(file)) continue;
    found.add(file);
    reachable(graph, file, found);
  }
  return found;
}

const graph = await importGraph();
const below = (folder) => [...graph.keys()].filter((file) => file.startsWith(`js/${folder}/`));

test("imports: curves and splines are the only files that import each other", () => {
  const inCycles = [...graph.keys()].filter((file) => reachable(graph, file).has(file));
  assert.deepEqual(inCycles.sort(), ["js/geometry/curve/curve.ts", "js/geometry/spline/spline.ts"]);
});

test("imports: wasm/ imports nothing from other folders, and only its modules import the bytes", () => {
  const allowed = /^js\/(wasm|glue)\//;
  for (const file of below("wasm")) {
    for (const path of /** @type {string[]} */ (graph.get(file)))
      assert.match(path, allowed, `${file} imports ${path}`);
  }
  const importers = [...graph].filter(([, paths]) => paths.some((path) => path.startsWith("js/glue/")));
  assert.ok(importers.length > 0);
  for (const [file] of importers) assert.match(file, /^js\/wasm\/\w+-module\.ts$/);
});

test("imports: editor, ui, layers, applet and elements depend on each other in one direction", () => {
  const views = ["editor", "ui", "layers", "applet", "elements"];
  const folderOf = (/** @type {string} */ file) => file.split("/")[1];
  /** What each may import besides itself and the package. @type {Record<string, string[]>} */
  const allowed = { editor: [], ui: ["editor"], layers: ["editor", "ui"], applet: ["editor", "ui"] };
  allowed.elements = ["editor", "ui", "layers", "applet"];
  for (const folder of views) {
    assert.ok(below(folder).length > 0, folder);
    for (const file of below(folder))
      for (const path of graph.get(file) ?? [])
        if (views.includes(folderOf(path)) && folderOf(path) !== folder)
          assert.ok(allowed[folder].includes(folderOf(path)), `${file} imports ${path}`);
  }
  for (const file of [...below("geometry"), ...below("io"), ...below("wasm")])
    for (const path of graph.get(file) ?? []) assert.ok(!views.includes(folderOf(path)), `${file} imports ${path}`);
});

test("imports: the classes that all entry points share import none of the complete classes", () => {
  for (const file of ["js/geometry/curve/core-curve.ts", "js/geometry/spline/core-spline.ts"]) {
    const names = [...reachable(graph, file)].map((path) => posix.basename(path));
    assert.ok(names.length > 5, `${names}`);
    for (const name of ["curve.ts", "spline.ts", "path.ts", "patch.ts"]) assert.ok(!names.includes(name), file + name);
  }
});
