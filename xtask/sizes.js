// The sizes of bundles that import parts of dist/: for `npm run size` and the site's page of benchmarks.
import { build } from "esbuild";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

const root = fileURLToPath(new URL("..", import.meta.url));

/** The size after gzip -9. @param {Uint8Array | string} bytes */
export const gzip = (bytes) => gzipSync(bytes, { level: 9 }).length;

/** The imports that are measured: the name of the row, what is imported, and the entry point. */
export const IMPORTS = [
  ["{ easing }", "easing", "index"],
  ["{ Curve }", "Curve", "index"],
  ["{ Path }", "Path", "index"],
  ["{ Surface }", "Surface", "index"],
  ["everything", "Curve, Spline, Path, InkStroke, Patch, Surface, Mesh, easing, init", "index"],
  ["everything of core", "Curve, Spline, Path", "core"],
  ["{ Surface } of surfaces", "Surface", "surfaces"],
  ["only types", "type Curve, type Mesh", "index"],
];

/** The size in bytes of a bundle that imports some of the classes of an entry point. @param {string[]} row of IMPORTS */
export async function sizeOfImport([name, names, entry]) {
  const use = names.startsWith("type ") ? "" : `globalThis.used = [${names}];`;
  const contents = `import { ${names} } from "./dist/${entry}.js"; ${use}`;
  const { outputFiles } = await build({
    stdin: { contents, resolveDir: root, loader: "ts" },
    bundle: true,
    minify: true,
    format: "esm",
    charset: "utf8",
    legalComments: "none",
    write: false,
  });
  const bytes = outputFiles[0].contents;
  return { name, raw: bytes.length, gzip: bytes.length && gzip(bytes) }; // gzip of nothing has 20 bytes
}
