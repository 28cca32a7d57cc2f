// Prints the sizes of the parts of dist/, minified and with gzip -9. Called by `npm run size`; fails if one
// has grown by more than 2 %.
import { build, transform } from "esbuild";
import { readFile, readdir } from "node:fs/promises";
import { posix } from "node:path";
import { gzip, IMPORTS, MEASURED_LISTS, sizeOfImport, sizesOfLists, sizesOfPrograms } from "./sizes.js";

/**
 * The gzip sizes in kB to which the sizes are compared; a change that raises one gives the reason. Growth of more than 2 %
 * fails.
 */
const COMMITTED_KB = {
  "{ easing }": 6.5,
  "{ Curve }": 162.1,
  "{ Surface }": 273.7,
  "{ Path }": 336.8,
  everything: 446.5,
  "everything of core": 79.5,
  "{ Surface } of surfaces": 124.9,
  "nurbs: { RationalCurve }": 157.6,
  "nurbs: { NurbsSurface }": 300.3,
  "only types": 0,
  "bezier-app.js": 47.7,
  "elements.js alone": 2,
  "elements.js, easing": 27.6,
  "elements.js, applet": 222.6,
  "elements.js, surface": 178.9,
  "weights of an applet": 156.9,
  "weights of a surface": 167.3,
  "bezier-applet: kernel": 167.9,
  "bezier-easing: kernel": 7.3,
  "bezier-surface: kernel": 125.3,
  "custom: a length": 17.2,
  "custom: a point on a path": 28.9,
  "custom: as bezier-js": 84,
  "custom: Boolean operations": 90.3,
};
const MAX_GROWTH = 1.02;

/** Sizes above these are reported, but do not fail. */
const TARGETS_KB = {
  "{ easing }": 4,
  "{ Curve }": 140,
  everything: 365,
  "everything of core": 80,
  "{ Surface } of surfaces": 110,
  "nurbs: { RationalCurve }": 155,
  "bezier-app.js": 48,
  "elements.js alone": 12,
  "elements.js, easing": 45,
  "elements.js, applet": 240,
  "elements.js, surface": 190,
  "bezier-applet: kernel": 150,
  "bezier-easing: kernel": 10,
  "bezier-surface: kernel": 120,
  ...Object.fromEntries(MEASURED_LISTS.map(({ name, targetKb }) => [name, targetKb])),
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

/** A file of dist/ and all files that it imports statically. */
async function staticImports(name, known = new Set()) {
  if (known.has(name)) return known;
  known.add(name);
  const { metafile } = await build({
    entryPoints: [`dist/${name}`],
    bundle: true,
    external: ["./*", "../*"],
    format: "esm",
    metafile: true,
    write: false,
  });
  for (const { kind, path } of metafile.inputs[`dist/${name}`].imports)
    if (kind === "import-statement") await staticImports(posix.join(posix.dirname(name), path), known);
  return known;
}

/** Whether a file has code of the classes or of their modules, and none of the elements. */
async function isKernel(name) {
  const { sources } = JSON.parse(await readFile(`dist/${name}.map`, "utf8"));
  const [kernel, views] = [
    /^(\.\.\/)+js\/(geometry|wasm|io|glue)\//,
    /^(\.\.\/)+js\/(editor|layers|ui|elements|applet)\//,
  ];
  return sources.some((source) => kernel.test(source)) && !sources.some((source) => views.test(source));
}

const allNames = (await readdir("dist", { recursive: true })).filter((name) =>
  /^(elements.*|shared-.*|weights-.*|nurbs.*)\.js$/.test(name),
);
const ENTRIES = ["casteljau.wasm", "slim.js", "index.js", "core.js", "surfaces.js", "applet.js", "bezier-app.js"];
const parts = await Promise.all([...ENTRIES, ...allNames].map(sizeOf));
console.log(`${"".padEnd(28)} minified  gzip -9`);
parts.filter(({ name }) => ENTRIES.includes(name) || name === "shared-curves.js").forEach(row);
const imports = await Promise.all(IMPORTS.map(sizeOfImport));
imports.forEach(row);
const lists = await sizesOfLists();
lists.forEach(row);

const partsOf = (requested) => parts.filter(({ name }) => requested.has(name));
const filesOf = async (...names) =>
  new Set((await Promise.all(names.map((name) => staticImports(name)))).flatMap((set) => [...set]));
/** The files of a page, without what it takes of the classes; and those. */
async function page(title, ...names) {
  const files = [...(await filesOf(...names))];
  const kernel = new Set((await Promise.all(files.map(async (name) => ((await isKernel(name)) ? [name] : [])))).flat());
  return [
    sum(title, partsOf(new Set(files.filter((name) => !kernel.has(name))))),
    sum(`${title}: kernel`, partsOf(kernel)),
  ];
}
const KINDS = ["applet", "bernstein", "coordinates", "easing", "equation", "surface"];
const pages = [
  sum("applet, all files", partsOf(await filesOf("applet.js"))),
  sum("elements.js alone", partsOf(await filesOf("elements.js"))),
  ...(await Promise.all(
    ["easing", "applet", "surface"].map(async (kind) =>
      sum(`elements.js, ${kind}`, partsOf(await filesOf("elements.js", `elements/${kind}.js`, `elements-${kind}.js`))),
    ),
  )),
  sum("weights of an applet", partsOf(await filesOf("nurbs-rational-curve.js"))),
  sum("weights of a surface", partsOf(await filesOf("elements-surface-rational.js"))),
  ...(
    await Promise.all(KINDS.map((kind) => page(`bezier-${kind}`, `elements/${kind}.js`, `elements-${kind}.js`)))
  ).flat(),
];
pages.forEach(row);
console.log(`\n${"typical programs, gzip -9".padEnd(28)}casteljau  smaller   own module`);
for (const { name, sizes } of await sizesOfPrograms())
  console.log(name.padEnd(28) + sizes.map((size) => (size === null ? "–".padStart(9) : kB(size))).join(" "));
for (const { name, gzip } of [...parts, ...imports, ...lists, ...pages]) {
  const [committed, target] = [COMMITTED_KB[name] ?? Infinity, TARGETS_KB[name] ?? Infinity];
  if (gzip > target * KB) console.log(`\n${name}: ${kB(gzip).trim()} is above the target of ${target} kB`);
  if (gzip <= MAX_GROWTH * committed * KB) continue;
  console.error(`\n${name}: ${kB(gzip).trim()} is more than 2 % above ${committed} kB`);
  process.exitCode = 1;
}
