// A plugin for Vite: renders the pages with Eleventy, and gives Vite their HTML as if it lay beside their scripts.
import { existsSync } from "node:fs";
import { readFile, writeFile } from "node:fs/promises";
import { dirname, relative, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { makeMathFont, MATH_FONT } from "./math-font.js";
import { pathToRoot } from "./layout.js";
import { searchDocuments } from "./search-documents.js";
import { siteBar } from "./site-bar.js";
import { types } from "../../scripts/build.js";
import { filesBelow, hashOf } from "../../scripts/stamp.js";

const www = fileURLToPath(new URL("..", import.meta.url));
const fromHere = relative(process.cwd(), www);

/** The file whose place a page takes, by its address: /curves/ is www/curves/index.html. @param {string} url */
const fileOf = (url) => `${www}${url.slice(1)}`.replace(/\/$/, "/index.html");

/** The index of the search, by its place in the site. */
const SEARCH = "search.json";

/** The pages that need the declarations and sizes of the package and take as long as all others: their templates and addresses. */
const SLOW_TEMPLATES = ["**/api/*.11ty.js", "**/benchmarks/*.11ty.js"];
const SLOW = /^\/(api|benchmarks)\/|^\/search\.json$/;

/** @typedef {{ url: string, content: string }} Rendered */

/** Renders templates. @param {"all" | "quick"} which "quick": without the slow pages, to which the others link all the same */
async function rendered(which) {
  const { default: Eleventy } = await import("@11ty/eleventy");
  const options = {
    configPath: `${fromHere}/eleventy.config.js`,
    quietMode: true,
    config(/** @type {any} */ config) {
      config.hasPackage = which === "all";
      if (which === "all") return;
      for (const template of SLOW_TEMPLATES) config.ignores.add(template);
      config.addTemplate("api/index.njk", "", { permalink: "/api/index.html" });
    },
  };
  /** @type {Rendered[]} */
  const all = await new Eleventy(fromHere, undefined, options).toJSON();
  const results = all
    .filter(({ url }) => which === "all" || !SLOW.test(url))
    .map(({ url, content }) => ({ url, content })); // they have more, with cycles
  await makeMathFont(results.map(({ content }) => content));
  return results;
}

/** The quick pages, which are kept for the next start of the server. */
const KEPT = new URL("../../target/site/pages.json", import.meta.url);

/** The quick pages: those of the last time if nothing has changed of which they are made. @returns {Promise<Rendered[]>} */
async function quickPages() {
  const key = hashOf([
    ...["www", "js", "docs"].flatMap(filesBelow),
    "README.md",
    "benches/results.json",
    "package.json",
    "package-lock.json",
  ]);
  const kept = JSON.parse(await readFile(KEPT, "utf8").catch(() => "{}"));
  if (kept.key === key && existsSync(MATH_FONT)) return kept.results;
  const results = await rendered("quick");
  await writeFile(KEPT, JSON.stringify({ key, results }));
  return results;
}

/**
 * The pages.
 *
 * @param {"all" | "quick"} which
 * @returns {Promise<{ pages: Map<string, string>, search: string }>} HTML by the file that it takes the place of
 */
async function renderPages(which) {
  const results = which === "all" ? await rendered("all") : await quickPages();
  const pages = new Map(results.map(({ url, content }) => [fileOf(url), content]));
  return { pages, search: JSON.stringify(searchDocuments(results)) };
}

/** @param {string[]} others pages that are HTML files already */
export function eleventyPages(others) {
  /** @type {Map<string, string>} */
  let pages = new Map();
  let search = "";
  /** In the server, the slow pages are rendered at the first request for one of them. @type {Promise<void> | undefined} */
  let rest;
  const renderAll = async () => {
    ({ pages, search } = await renderPages("all"));
  };
  return {
    name: "eleventy-pages",
    enforce: /** @type {const} */ ("pre"),
    async config(/** @type {unknown} */ _config, /** @type {{ command: string }} */ { command }) {
      ({ pages, search } = await renderPages(command === "serve" ? "quick" : "all"));
      return { build: { rolldownOptions: { input: [...pages.keys(), ...others] } } };
    },
    resolveId(/** @type {string} */ id, /** @type {string | undefined} */ importer) {
      if (pages.has(id)) return id;
      // Vite resolves relative to the root if the importing file is not on the disk.
      const file = importer && pages.has(importer) ? resolve(dirname(importer), id) : "";
      return existsSync(file) ? file : undefined;
    },
    load: (/** @type {string} */ id) => pages.get(id),
    /** The bar for pages that are HTML files; what they show to be copied remains as it is. */
    transformIndexHtml: {
      order: /** @type {const} */ ("pre"),
      handler(/** @type {string} */ html, /** @type {{ filename: string }} */ { filename }) {
        if (!others.includes(filename)) return html;
        const url = `/${relative(www, filename)}`.replace(/index\.html$/, "");
        const root = pathToRoot(url);
        const bar = `${siteBar(url)}\n    <script type="module" src="${root}parts/header.js"></script>`;
        return html
          .replace(/(?=<link rel="stylesheet")/, `<link rel="stylesheet" href="${root}base.css">\n    `)
          .replace("<body>", `<body>\n    ${bar}`)
          .replace("<main>", '<main id="main">');
      },
    },
    generateBundle() {
      /** @type {any} */ (this).emitFile({ type: "asset", fileName: SEARCH, source: search });
    },
    configureServer(/** @type {import("vite").ViteDevServer} */ server) {
      server.watcher.on("change", async (file) => {
        if (!/\.(md|njk)$/.test(file)) return;
        if (rest) await renderAll();
        else ({ pages, search } = await renderPages("quick"));
        server.ws.send({ type: "full-reload" });
      });
      server.middlewares.use(async (request, response, next) => {
        const path = new URL(request.originalUrl ?? "/", "http://localhost").pathname;
        if (SLOW.test(path)) {
          if (!rest) server.config.logger.info("rendering the API reference");
          rest ??= types().then(renderAll);
          try {
            await rest;
          } catch (error) {
            rest = undefined; // the next request tries again
            return next(error);
          }
        }
        if (path === `/${SEARCH}`) return void response.end(search);
        const html = pages.get(fileOf(path));
        if (html === undefined) return next();
        response.setHeader("Content-Type", "text/html; charset=utf-8");
        response.end(await server.transformIndexHtml(path, html));
      });
    },
  };
}
