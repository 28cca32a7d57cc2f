// Weighs the parts of dist/: minified, then gzip -9. Called by `cargo xtask size`; fails above a limit.
import { build, transform } from "esbuild";
import { readFile, readdir } from "node:fs/promises";
import { gzipSync } from "node:zlib";

/** The most that a row may weigh, in kB. A change that needs more says why. */
const LIMITS_KB = {
  "{ Curve }": 149,
  "{ Surface }": 260,
  "index.js + applet.js": 277,
  "elements, loaded at once": 31,
  "elements, when needed": 64,
  "bezier-app.js": 42,
};
const KB = 1000;

const gzip = (bytes) => gzipSync(bytes, { level: 9 }).length;

async function weigh(name) {
  const bytes = await readFile(`dist/${name}`);
  if (name.endsWith(".wasm")) return { name, raw: bytes.length, gzip: gzip(bytes) };
  const { code } = await transform(bytes.toString(), { minify: true, charset: "utf8", legalComments: "none" });
  return { name, raw: Buffer.byteLength(code), gzip: gzip(code) };
}

/** What a bundler makes of a page that imports some of the classes. */
async function weighImport(names) {
  const contents = `import { ${names} } from "./dist/index.js"; globalThis.kept = [${names}];`;
  const options = { bundle: true, minify: true, format: "esm", charset: "utf8", legalComments: "none", write: false };
  const { outputFiles } = await build({ stdin: { contents, resolveDir: process.cwd() }, ...options });
  const bytes = outputFiles[0].contents;
  return { name: `{ ${names} }`, raw: bytes.length, gzip: gzip(bytes) };
}

const kB = (bytes) => `${(bytes / KB).toFixed(1)} kB`.padStart(9);
const row = ({ name, raw, gzip }) => console.log(`${name.padEnd(28)}${kB(raw)}${kB(gzip)}`);

/** A sum of parts. */
const sum = (name, parts) =>
  parts.reduce((total, { raw, gzip }) => ({ name, raw: total.raw + raw, gzip: total.gzip + gzip }), {
    name,
    raw: 0,
    gzip: 0,
  });

/** The files that a file of dist/ imports as soon as it is loaded, itself first; the core is left out. */
async function loadedAtOnce(name, known = []) {
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
  for (const { path } of imports) all = await loadedAtOnce(path.replace("./", ""), all);
  return all;
}

const elementsFiles = (await readdir("dist")).filter((name) => /^elements\b.*\.js$/.test(name));
const names = ["casteljau.wasm", "slim.js", "index.js", "applet.js", ...elementsFiles, "bezier-app.js"];
const parts = await Promise.all(names.map(weigh));
console.log(`${"".padEnd(28)} minified  gzip -9`);
parts.forEach(row);
const imports = await Promise.all(["Curve", "Curve, Spline", "Surface"].map(weighImport));
imports.forEach(row);

const partsOf = (wanted) => parts.filter(({ name }) => wanted.includes(name));
const total = sum("index.js + applet.js", partsOf(["index.js", "applet.js"]));
const atOnce = await loadedAtOnce("elements.js");
const elements = sum("elements, loaded at once", partsOf(atOnce));
const later = sum("elements, when needed", partsOf(elementsFiles.filter((name) => !atOnce.includes(name))));
[total, elements, later].forEach(row);
// What a page fetches that shows one kind.
const lateFiles = elementsFiles.filter((name) => !atOnce.includes(name) && !name.includes("shared"));
for (const name of lateFiles)
  row(
    sum(
      `  at once + ${name.slice("elements-".length, -".js".length)}`,
      partsOf([...new Set([...atOnce, ...(await loadedAtOnce(name))])]),
    ),
  );
for (const { name, gzip } of [...parts, ...imports, total, elements, later]) {
  const limit = LIMITS_KB[name] ?? Infinity;
  if (gzip <= limit * KB) continue;
  console.error(`\n${name}: ${kB(gzip).trim()} is above the limit of ${limit} kB`);
  process.exitCode = 1;
}
