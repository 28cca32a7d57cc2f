// The site. Eleventy renders its pages (eleventy.config.js); Vite bundles their scripts, serves them while working, and builds
// site/ with relative URLs, so that it works in any folder.
import { createReadStream, readdirSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";
import { referenceSamples } from "./api/build/vite-samples.js";
import { mathFontLicense } from "./build/math-font.js";
import { eleventyPages } from "./build/pages.js";
import { rustDocs } from "./build/rust-docs.js";

const www = fileURLToPath(new URL(".", import.meta.url));
const dist = (/** @type {string} */ name) => fileURLToPath(new URL(`../dist/${name}`, import.meta.url));

const plainPages = readdirSync(www, { recursive: true, encoding: "utf8" })
  .filter((name) => name.endsWith(".html") && !name.startsWith("recipes")) // those are parts of a page
  .map((name) => www + name);

/** Serves the classic script as /bezier-app.js; Vite itself leaves scripts without type="module" alone. @type {import("vite").Plugin} */
const classicScript = {
  name: "classic-script",
  configureServer({ middlewares }) {
    middlewares.use("/bezier-app.js", (_request, response) => {
      response.setHeader("Content-Type", "text/javascript");
      createReadStream(dist("bezier-app.js")).pipe(response);
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

export default defineConfig({
  root: www,
  base: "./",
  appType: "mpa", // an unknown address is a 404, not the first page
  publicDir: "public",
  resolve: {
    // Lit as it is published, in the server too: its development build writes warnings to the console.
    conditions: ["module", "browser", "production"],
    alias: [
      { find: /^casteljau$/, replacement: dist("index.js") },
      { find: /^casteljau\/(slim|surfaces|paths|applet|elements(?:\/\w+)?)$/, replacement: dist("$1.js") },
    ],
  },
  plugins: [eleventyPages(plainPages), referenceSamples, mathFontLicense, classicScript, pageSideEffects, rustDocs()],
  worker: { format: "es" }, // the core is awaited when it is imported
  server: { fs: { allow: [fileURLToPath(new URL("..", import.meta.url))] } },
  build: {
    outDir: "../site",
    emptyOutDir: true,
    target: "es2022",
    modulePreload: { polyfill: false },
  },
});
