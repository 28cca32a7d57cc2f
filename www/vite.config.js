// The site: every .html file below www/ is a page. Built into site/ with relative URLs, so that it works in any folder.
import { createReadStream, readdirSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";
import { siteFrame } from "./build/frame.js";
import { appletPosters } from "./build/posters.js";
import { lessonSamples } from "./build/samples.js";
import { surfacePosters } from "./build/surface-posters.js";

const www = fileURLToPath(new URL(".", import.meta.url));
const dist = (/** @type {string} */ name) => fileURLToPath(new URL(`../dist/${name}`, import.meta.url));

const pages = readdirSync(www, { recursive: true, encoding: "utf8" })
  .filter((name) => name.endsWith(".html"))
  .map((name) => www + name);

/** Serves the classic script as /bezier-app.js; Vite itself leaves scripts without type="module" alone. */
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

/** package.json says that importing a module of the package does nothing but a few; those of the pages are another matter. */
const pagesAct = {
  name: "pages-act",
  transform: (/** @type {string} */ code, /** @type {string} */ id) =>
    id.startsWith(www) && /\.js$/.test(id) ? { code, map: null, moduleSideEffects: true } : null,
};

export default defineConfig({
  root: www,
  base: "./",
  appType: "mpa", // what is not there is a 404, not the first page
  publicDir: "public",
  resolve: {
    alias: [
      { find: /^casteljau$/, replacement: dist("index.js") },
      { find: /^casteljau\/(slim|applet|elements)$/, replacement: dist("$1.js") },
    ],
  },
  plugins: [classicScript, pagesAct, siteFrame, lessonSamples, appletPosters, surfacePosters],
  server: { fs: { allow: [fileURLToPath(new URL("..", import.meta.url))] } },
  build: {
    outDir: "../site",
    emptyOutDir: true,
    target: "es2022",
    modulePreload: { polyfill: false },
    rollupOptions: { input: pages },
  },
});
