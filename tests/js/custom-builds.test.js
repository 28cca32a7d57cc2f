// Other tests of the package, each with a module of `casteljau custom` that has only what the test names: a member that the
// module lacks, a function or a constant that was cut too much, makes them fail.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join, posix } from "node:path";
import { after, test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import ts from "typescript-api";
import { customModule, sourceOf } from "../../custom/module.js";
import { namesIn } from "../../custom/suggest.js";

const root = fileURLToPath(new URL("../../", import.meta.url));
const skip = !existsSync(join(root, "dist/custom")) && "dist/custom is part of a release: npm run test:all";

/** Tests of the package, and names that they call on values without a type. @type {Record<string, string[]>} */
const FILES = {
  arc: [],
  curve: [],
  "curve-queries": [],
  "curves-parts": ["Curve.derivativeAt", "Curve.curvature"],
  dicing: [],
  easing: [],
  "golden-curves": [],
  "ink-stroke": [],
  intersections: [],
  "path-builder": ["Path.intersect", "Path.exclude"],
  "path-queries": [],
  "path-shapes": [],
  points: [],
  "ray-tracer": ["Surface.patch"],
  spline: [],
  "spline-queries": [],
  "spline-split": ["Spline.controlPoints", "Spline.eval"],
  surface: ["Patch.toJSON"],
  "surface-lines": [
    "Curve.controlPoints",
    "Curve.deCasteljau",
    "Curve.sample",
    "Patch.controlPoints",
    "Patch.isocurveAtU",
  ],
  "surface-network": [],
  "surface-text": [],
  teaset: ["Patch.controlPoints", "Surface.patch"],
  tessellate: [],
  "three-shapes": ["Curve.pointAtLength", "Spline.pointAtLength"],
  trace: [],
  wireframe: [],
};

/** A program with the tests, checked against dist/types. */
function programOf(files) {
  const config = ts.readConfigFile(join(root, "tests/tsconfig.json"), ts.sys.readFile).config;
  const { options } = ts.parseJsonConfigFileContent(config, ts.sys, join(root, "tests"));
  const paths = { casteljau: [join(root, "dist/types/index.d.ts")] };
  return ts.createProgram(files, { ...options, paths });
}

/** Makes `import "casteljau"` import another module. @param {string} url */
const hooks = (url) =>
  `export const resolve = (specifier, context, next) =>
    specifier === "casteljau" ? { url: ${JSON.stringify(url)}, shortCircuit: true } : next(specifier, context);`;

if (skip) test("custom builds", { skip }, () => {});
else {
  const folder = await mkdtemp(join(tmpdir(), "casteljau-custom-builds-"));
  after(() => rm(folder, { recursive: true, force: true }));
  const json = (name) => JSON.parse(readFileSync(join(root, "dist/custom", name), "utf8"));
  const source = sourceOf(json("pieces.json"), json("needs.json"), readFileSync(join(root, "dist/casteljau.wasm")));
  const pathOf = (name) => join(root, "tests/js", `${name}.test.js`).replaceAll("\\", "/");
  const program = programOf(Object.keys(FILES).map(pathOf));
  /** A test and the files that it imports by their places. @param {string} path */
  const used = (path) => {
    const imports = ts.preProcessFile(readFileSync(path, "utf8")).importedFiles.map(({ fileName }) => fileName);
    return [path, ...imports.filter((each) => each.startsWith(".")).map((each) => posix.join(path, "..", each))];
  };
  for (const [name, more] of Object.entries(FILES))
    test(`custom: ${name}.test.js with a module of what it names`, async () => {
      const files = program.getSourceFiles().filter(({ fileName }) => used(pathOf(name)).includes(fileName));
      const list = [...namesIn(source.pieces.names, ts, program, files), ...more];
      assert.ok(list.length > 0);
      const path = join(folder, `${name}.mjs`);
      await writeFile(path, customModule(source, list, `npx casteljau custom ${list.join(" ")}`).code);
      const hook = join(folder, `${name}-hook.mjs`);
      const register = `import { register } from "node:module"; register("data:text/javascript,${encodeURIComponent(hooks(pathToFileURL(path).href)).replaceAll("'", "%27")}");`;
      await writeFile(hook, register);
      assert.equal(await failures(["--import", pathToFileURL(hook).href, pathOf(name)]), "");
    });
}

/** Runs a test; what it prints if it fails. @param {string[]} args @returns {Promise<string>} */
function failures(args) {
  const { NODE_TEST_CONTEXT, ...env } = process.env;
  const child = spawn(process.execPath, ["--test-reporter=dot", ...args], {
    cwd: root,
    env: { ...env, CASTELJAU_FEW: "1" },
  });
  let printed = "";
  for (const stream of [child.stdout, child.stderr]) stream.on("data", (text) => (printed += text));
  return new Promise((done) => child.once("exit", (code) => done(code === 0 ? "" : printed || `exit code ${code}`)));
}
