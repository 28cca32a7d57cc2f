// Weighs the parts of dist/: minified, then gzip -9. Called by `cargo xtask size`; fails above the limit.
import { build, transform } from "esbuild";
import { readFile } from "node:fs/promises";
import { gzipSync } from "node:zlib";

/** For everything but the elements: the package with the wasm inside, and the applet on it. */
const LIMIT_KB = 40;
/** For the elements with what they are made of, without the core. */
const ELEMENTS_LIMIT_KB = 45;
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

const parts = await Promise.all(["casteljau.wasm", "slim.js", "index.js", "applet.js", "elements.js", "bezier-app.js"].map(weigh));
console.log(`${"".padEnd(28)} minified  gzip -9`);
parts.forEach(row);
(await Promise.all(["Curve", "Curve, Spline", "Surface"].map(weighImport))).forEach(row);

const counted = parts.filter(({ name }) => name === "index.js" || name === "applet.js");
const total = { name: "index.js + applet.js", raw: 0, gzip: 0 };
for (const part of counted) (total.raw += part.raw), (total.gzip += part.gzip);
row(total);
const elements = parts.find(({ name }) => name === "elements.js");
for (const [{ name, gzip }, limit] of [[total, LIMIT_KB], [elements, ELEMENTS_LIMIT_KB]]) {
  if (gzip <= limit * KB) continue;
  console.error(`\n${name}: ${kB(gzip).trim()} is above the limit of ${limit} kB`);
  process.exitCode = 1;
}
