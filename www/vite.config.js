// The site. Eleventy renders its pages (eleventy.config.js); Vite bundles their scripts, serves them while working, and builds
// site/ with relative URLs, so that it works in any folder.
import { build } from "esbuild";
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";
import { checkedList } from "../custom/list.js";
import { customModule, sourceOf } from "../custom/module.js";
import { developmentModule, MODULE_FILES, replacedModules } from "../xtask/complete-module.js";
import { referenceSamples } from "./api/build/vite-samples.js";
import { mathFontLicense } from "./build/math-font.js";
import { eleventyPages } from "./build/pages.js";
import { rustDocs } from "./build/rust-docs.js";
import { libraryLicenses, verbWithoutEval } from "./conformance/packages.js";

const www = fileURLToPath(new URL(".", import.meta.url));
const dist = (/** @type {string} */ name) => fileURLToPath(new URL(`../dist/${name}`, import.meta.url));
const js = (/** @type {string} */ name) => fileURLToPath(new URL(`../js/${name}`, import.meta.url));

/** The built site takes the package from dist/. */
const BUILT_PACKAGE = [
  { find: /^casteljau$/, replacement: dist("index.js") },
  { find: /^casteljau\/(core|easing|nurbs|slim|surfaces|applet|elements(?:\/\w+)?)$/, replacement: dist("$1.js") },
];

/** While working, the package is its sources in js/: a change there shows at once. */
const SOURCES = [
  { find: /^casteljau$/, replacement: js("index.ts") },
  { find: /^casteljau\/(applet|elements)$/, replacement: js("$1/index.ts") },
  { find: /^casteljau\/elements\/(\w+)$/, replacement: js("elements/define/$1.ts") },
  { find: /^casteljau\/(core|easing|nurbs|slim|surfaces)$/, replacement: js("$1.ts") },
  { find: /^#js\/(.*)\.js$/, replacement: js("$1.ts") },
];

/** The sources use the one wasm module that is compiled for development. @type {import("vite").Plugin} */
const oneModule = {
  name: "one-module",
  apply: "serve",
  load: (id) => developmentModule[MODULE_FILES.exec(id)?.[1] ?? ""],
};

const plainPages = readdirSync(www, { recursive: true, encoding: "utf8" })
  .filter((name) => name.endsWith(".html") && !name.startsWith("recipes")) // those are parts of a page
  .map((name) => www + name);

/** Bundles and serves the classic script as /bezier-app.js; Vite itself leaves scripts without type="module" alone. @type {import("vite").Plugin} */
const classicScript = {
  name: "classic-script",
  configureServer({ middlewares }) {
    middlewares.use("/bezier-app.js", async (_request, response, next) => {
      const plugins = [replacedModules("for-development", developmentModule)];
      const options = {
        entryPoints: [js("applet/classic.ts")],
        bundle: true,
        write: /** @type {const} */ (false),
        plugins,
      };
      try {
        const { outputFiles } = await build(options);
        response.setHeader("Content-Type", "text/javascript");
        response.end(outputFiles[0].text);
      } catch (error) {
        next(error);
      }
    });
  },
  async generateBundle() {
    this.emitFile({ type: "asset", fileName: "bezier-app.js", source: await readFile(dist("bezier-app.js")) });
  },
};

/** package.json lists the few modules of the package that have side effects; the modules of the pages all have. @type {import("vite").Plugin} */
const pageSideEffects = {
  name: "page-side-effects",
  transform: (/** @type {string} */ code, /** @type {string} */ id) =>
    id.startsWith(www) && /\.js$/.test(id) ? { code, map: null, moduleSideEffects: true } : null,
};

/**
 * What scripts use of `casteljau`: the built site gives each of them a module of its own, with these methods only.
 *
 * @type {Record<string, Record<string, string[]>>}
 */
const CUSTOM_MODULES = {
  "home/core.js": {
    Spline: ["setJoint", "movePoint", "continuity", "segments", "segmentCount", "sample", "controlPoints", "toSVG"],
    Curve: ["deCasteljau"],
  },
  "figures/modules/faces.js": {
    Path: ["area", "circle", "faces", "from", "fromSVG", "rect", "toSVG", "transform"],
  },
  "figures/modules/fitting.js": {
    Spline: ["eval", "fit", "nearest", "segmentCount", "toSVG", "transform"],
    Path: ["polygon", "simplify", "subpaths", "toSVG", "transform"],
  },
  "figures/modules/strokes.js": {
    Curve: ["eval", "length", "normal", "subsegment", "tangent"],
    Path: ["from", "fromSVG", "length", "stroke", "toSVG", "transform"],
  },
};

/** Makes these modules; a package that is built for development has no tables for them. @type {import("vite").Plugin} */
const customModules = {
  name: "custom-modules",
  apply: "build",
  load(id) {
    const methods = id.startsWith(www) ? CUSTOM_MODULES[id.slice(www.length)] : undefined;
    if (!methods || !existsSync(dist("custom/pieces.json"))) return;
    const [pieces, needs] = ["pieces", "needs"].map((name) =>
      JSON.parse(readFileSync(dist(`custom/${name}.json`), "utf8")),
    );
    const words = Object.entries(methods).flatMap(([name, members]) => [
      name,
      ...members.map((member) => `${name}.${member}`),
    ]);
    return customModule(
      sourceOf(pieces, needs, readFileSync(dist("casteljau.wasm"))),
      checkedList(pieces.names, words, pieces.nurbs),
      "custom module of this page",
    ).code;
  },
};

export default defineConfig(({ command }) => ({
  root: www,
  base: "./",
  appType: "mpa", // an unknown address is a 404, not the first page
  publicDir: "public",
  resolve: {
    // Lit as it is published, in the server too: its development build writes warnings to the console.
    conditions: ["module", "browser", "production"],
    alias: command === "serve" ? SOURCES : BUILT_PACKAGE,
  },
  plugins: [
    eleventyPages(plainPages),
    referenceSamples,
    mathFontLicense,
    libraryLicenses,
    verbWithoutEval,
    classicScript,
    oneModule,
    customModules,
    pageSideEffects,
    rustDocs(),
  ],
  worker: { format: "es", plugins: () => [verbWithoutEval] }, // the core is awaited when it is imported
  server: { fs: { allow: [fileURLToPath(new URL("..", import.meta.url))] } },
  build: {
    outDir: "../site",
    emptyOutDir: true,
    target: "es2022",
    modulePreload: { polyfill: false },
    chunkSizeWarningLimit: 1000, // a wasm module is text in one script
  },
}));
