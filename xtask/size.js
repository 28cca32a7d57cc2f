// Prints the sizes of the parts of dist/, minified and with gzip -9. Called by `cargo xtask size`; fails above a limit.
import { build, transform } from "esbuild";
import { readFile, readdir } from "node:fs/promises";
import { gzip, IMPORTS, sizeOfImport } from "./sizes.js";

/**
 * The maximum gzip sizes in kB. A change that raises one gives the reason. The targets are 3 for { easing }, 138 for
 * { Curve }, 250 for { Surface } and everything, 45 for { Curve, Spline } of core, and 135 for { Surface } of surfaces.
 * Everything includes the module of regions, strokes and rounded corners, 109 kB, which came after its target was set.
 */
const LIMITS_KB = {
  "{ easing }": 5,
  "{ Curve }": 148,
  "{ Surface }": 255.5,
  everything: 381.5,
  "{ Curve, Spline } of core": 46.5,
  "{ Surface } of surfaces": 120,
  "only types": 0,
  "index.js + applet.js": 393.5,
  "elements, loaded at once": 31,
  "elements, when needed": 65,
  "bezier-app.js": 43,
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
  const limit = LIMITS_KB[name] ?? Infinity;
  if (gzip <= limit * KB) continue;
  console.error(`\n${name}: ${kB(gzip).trim()} is above the limit of ${limit} kB`);
  process.exitCode = 1;
}
