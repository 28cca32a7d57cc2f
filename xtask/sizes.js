// The sizes of bundles that import parts of dist/: for `npm run size` and the site's page of benchmarks.
import { build } from "esbuild";
import { readFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { customModule, sourceOf } from "../custom/module.js";

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
  ["nurbs: { RationalCurve }", "RationalCurve", "nurbs"],
  ["nurbs: { NurbsSurface }", "NurbsSurface", "nurbs"],
  ["only types", "type Curve, type Mesh", "index"],
];

/** The modules of `npx casteljau custom` that are measured, and how many kB they may take with gzip. */
export const MEASURED_LISTS = [
  { name: "custom: a length", list: ["Curve.length"], targetKb: 30 },
  { name: "custom: a point on a path", list: ["Path.fromSVG", "Path.pointAtLength"], targetKb: 45 },
  {
    name: "custom: as bezier-js",
    list: [
      ...["eval", "sample", "derivativeAt", "normal", "curvature", "length", "split", "subsegment", "bounds", "hull"],
      ...["extrema", "inflections", "nearest", "intersections", "selfIntersections", "elevate", "offset", "toSVG"],
    ]
      .map((name) => `Curve.${name}`)
      .concat("Spline.segments"),
    targetKb: 85,
  },
  {
    name: "custom: Boolean operations",
    list: ["fromSVG", "union", "intersect", "subtract", "exclude", "toSVG"].map((name) => `Path.${name}`),
    targetKb: 120,
  },
];

/**
 * Typical programs: what they import from `casteljau`, the smallest entry point that has it (if there is one), and what they name
 * for a module of their own.
 *
 * @type {{ name: string, imports: string, entry?: string, list: string[] }[]}
 */
export const PROGRAMS = [
  { name: "length of a curve", imports: "Curve", entry: "core", list: ["Curve.length"] },
  { name: "point at a length", imports: "Path", entry: "core", list: ["Path.fromSVG", "Path.pointAtLength"] },
  { name: "easing", imports: "easing", entry: "easing", list: ["easing"] },
  { name: "d3, simplified paths", imports: "Path", list: ["Path.fromSVG", "Path.simplify", "Path.toSVG"] },
  { name: "React, a line", imports: "Spline", list: ["Spline.interpolate", "Spline.toSVG"] },
  {
    name: "three.js, the teapot",
    imports: "Surface",
    entry: "surfaces",
    list: ["Surface.teapot", "Surface.tessellate", "Mesh.toThree"],
  },
];

/** Makes modules of one's own. @param {{ name: string, list: string[] }[]} lists */
export async function sizesOfLists(lists = MEASURED_LISTS) {
  const json = async (/** @type {string} */ name) => JSON.parse(await readFile(`${root}/dist/custom/${name}`, "utf8"));
  const wasm = await readFile(`${root}/dist/casteljau.wasm`);
  const source = sourceOf(await json("pieces.json"), await json("needs.json"), wasm);
  return lists.map(({ name, list }) => {
    const { code } = customModule(source, list, `npx casteljau custom ${list.join(" ")} --out bezier.js`);
    return { name, raw: Buffer.byteLength(code), gzip: gzip(code) };
  });
}

/** The gzip sizes of the typical programs with `casteljau`, with a smaller entry point and with a module of their own. */
export async function sizesOfPrograms() {
  const own = await sizesOfLists(PROGRAMS);
  const size = async (/** @type {string[]} */ row) => (await sizeOfImport(row)).gzip;
  return Promise.all(
    PROGRAMS.map(async ({ name, imports, entry }, i) => ({
      name,
      sizes: [
        await size([name, imports, "index"]),
        entry === undefined ? null : await size([name, imports, entry]),
        own[i].gzip,
      ],
    })),
  );
}

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
