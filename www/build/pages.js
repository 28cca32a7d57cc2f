// A plugin for Vite: renders the pages with Eleventy, and gives Vite their HTML as if it lay beside their scripts.
import Eleventy from "@11ty/eleventy";
import { existsSync } from "node:fs";
import { dirname, relative, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { makeMathFont } from "./math-font.js";

const www = fileURLToPath(new URL("..", import.meta.url));
const fromHere = relative(process.cwd(), www);

/** The file whose place a page takes, by its address: /curves/ is www/curves/index.html. @param {string} url */
const fileOf = (url) => `${www}${url.slice(1)}`.replace(/\/$/, "/index.html");

/** Renders all pages. @returns {Promise<Map<string, string>>} HTML by the file that it takes the place of */
async function renderPages() {
  const eleventy = new Eleventy(fromHere, undefined, {
    configPath: `${fromHere}/eleventy.config.js`,
    quietMode: true,
  });
  /** @type {{ url: string, content: string }[]} */
  const results = await eleventy.toJSON();
  await makeMathFont(results.map(({ content }) => content));
  return new Map(results.map(({ url, content }) => [fileOf(url), content]));
}

/** @param {string[]} others pages that are HTML files already */
export function eleventyPages(others) {
  /** @type {Map<string, string>} */
  let pages = new Map();
  return {
    name: "eleventy-pages",
    enforce: /** @type {const} */ ("pre"),
    async config() {
      pages = await renderPages();
      return { build: { rolldownOptions: { input: [...pages.keys(), ...others] } } };
    },
    resolveId(/** @type {string} */ id, /** @type {string | undefined} */ importer) {
      if (pages.has(id)) return id;
      // Vite resolves relative to the root if the importing file is not on the disk.
      const file = importer && pages.has(importer) ? resolve(dirname(importer), id) : "";
      return existsSync(file) ? file : undefined;
    },
    load: (/** @type {string} */ id) => pages.get(id),
    configureServer(/** @type {import("vite").ViteDevServer} */ server) {
      server.watcher.on("change", async (file) => {
        if (!/\.(md|njk)$/.test(file)) return;
        pages = await renderPages();
        server.ws.send({ type: "full-reload" });
      });
      server.middlewares.use(async (request, response, next) => {
        const path = new URL(request.originalUrl ?? "/", "http://localhost").pathname;
        const html = pages.get(fileOf(path));
        if (html === undefined) return next();
        response.setHeader("Content-Type", "text/html; charset=utf-8");
        response.end(await server.transformIndexHtml(path, html));
      });
    },
  };
}
