// Prints the sizes of the parts of dist/, minified and with gzip -9. Called by `cargo xtask size`; fails if one
// has grown by more than 2 %.
import { build, transform } from "esbuild";
import { readFile, readdir } from "node:fs/promises";
import { gzip, IMPORTS, sizeOfImport } from "./sizes.js";

/**
 * The gzip sizes in kB to which the sizes are compared; a change that raises one gives the reason. Growth of more than 2 %
 * fails.
 */
const COMMITTED_KB = {
  "{ easing }": 6.3,
  "{ Curve }": 151.1,
  "{ Surface }": 260.1,
  everything: 391.1,
  "{ Curve, Spline } of core": 48.4,
  "{ Surface } of surfaces": 122.2,
  "only types": 0,
  "index.js + applet.js": 403.3,
  "elements, loaded at once": 30.9,
  "elements, when needed": 64.8,
  "bezier-app.js": 45,
};
const MAX_GROWTH = 1.02;

/** Sizes above these are reported, but do not fail. */
const TARGETS_KB = {
  "{ easing }": 4,
  "{ Curve }": 140,
  everything: 365,
  "{ Curve, Spline } of core": 45,
  "{ Surface } of surfaces": 110,
  "bezier-app.js": 48,
};
const KB = 1000;

async function sizeOf(name) {
  const bytes = await readFile(`dist/${name}`);
  if (name.endsWith(".wasm")) return { name, raw: bytes.length, gzip: gzip(bytes) };
  const { code } = await transform(bytes.toString(), { minify: true, charset: "utf8", legalComments: "none" });
  return { name, raw: Buffer.byteLength(code), gzip: gzip(code) };
}

const kB = (bytes) => `${(bytes / KB).toFixed(1)} kB`.padStart(9);
const row = ({ name, raw, gzip }) => console.log(`${name.padEnd(28)}${kB(raw)}${kB(gzip)}`);

/** The sum of some parts as a row. */
const sum = (name, parts) =>
  parts.reduce((total, { raw, gzip }) => ({ name, raw: total.raw + raw, gzip: total.gzip + gzip }), {
    name,
    raw: 0,
    gzip: 0,
  });

/** A file of dist/ and all files that it imports statically, without the core. */
async function staticImports(name, known = []) {
  if (known.includes(name)) return known;
  const { metafile } = await build({
    entryPoints: [`dist/${name}`],
    bundle: true,
    external: ["./*"],
    format: "esm",
    metafile: true,
    write: false,
  });
  const imports = metafile.inputs[`dist/${name}`].imports.filter(
    ({ kind, path }) => kind === "import-statement" && path !== "./index.js",
  );
  let all = [...known, name];
  for (const { path } of imports) all = await staticImports(path.replace("./", ""), all);
  return all;
}

const elementsFiles = (await readdir("dist")).filter((name) => /^elements\b.*\.js$/.test(name));
const names = [
  "casteljau.wasm",
  "slim.js",
  "index.js",
  "core.js",
  "surfaces.js",
  "applet.js",
  ...elementsFiles,
  "bezier-app.js",
];
const parts = await Promise.all(names.map(sizeOf));
console.log(`${"".padEnd(28)} minified  gzip -9`);
parts.forEach(row);
const imports = await Promise.all(IMPORTS.map(sizeOfImport));
imports.forEach(row);

const partsOf = (requested) => parts.filter(({ name }) => requested.includes(name));
const total = sum("index.js + applet.js", partsOf(["index.js", "applet.js"]));
const initialFiles = await staticImports("elements.js");
const elements = sum("elements, loaded at once", partsOf(initialFiles));
const onDemand = sum("elements, when needed", partsOf(elementsFiles.filter((name) => !initialFiles.includes(name))));
[total, elements, onDemand].forEach(row);
// The download of a page with one kind of element.
const onDemandFiles = elementsFiles.filter((name) => !initialFiles.includes(name) && !name.includes("shared"));
for (const name of onDemandFiles)
  row(
    sum(
      `  at once + ${name.slice("elements-".length, -".js".length)}`,
      partsOf([...new Set([...initialFiles, ...(await staticImports(name))])]),
    ),
  );
for (const { name, gzip } of [...parts, ...imports, total, elements, onDemand]) {
  const [committed, target] = [COMMITTED_KB[name] ?? Infinity, TARGETS_KB[name] ?? Infinity];
  if (gzip > target * KB) console.log(`\n${name}: ${kB(gzip).trim()} is above the target of ${target} kB`);
  if (gzip <= MAX_GROWTH * committed * KB) continue;
  console.error(`\n${name}: ${kB(gzip).trim()} is more than 2 % above ${committed} kB`);
  process.exitCode = 1;
}
