// Bundles js/ into dist/ with esbuild. Called by `cargo xtask build`; runs from the repository's root.
import { build } from "esbuild";
import { mkdir, readFile, readdir, rm, writeFile } from "node:fs/promises";
import { basename, relative, resolve, sep } from "node:path";

const sources = resolve("js");
const { version, license } = JSON.parse(await readFile("package.json", "utf8"));
const banner = { js: `/*! casteljau ${version} | ${license} */` };

/** One gate to the whole module, without bytes: the slim bundle is told where they are by `init`. */
const withoutBytes = {
  name: "without-bytes",
  setup(build) {
    const contents = {
      curves: `import { gate } from "./wasm-module.js"; import { initSync } from "../glue/casteljau.js";
        export const curves = /* @__PURE__ */ gate(initSync, null);`,
      surfaces: `export { curves as surfaces } from "./curves-module.js";`,
    };
    build.onLoad({ filter: /[\\/]js[\\/]wasm[\\/](curves|surfaces)-module\.js$/ }, ({ path }) => ({
      contents: contents[path.match(/(\w+)-module\.js$/)[1]],
      resolveDir: resolve(sources, "wasm"),
    }));
  },
};

/** The gate to the module that has only what the applet calls: the classic script hands no curve out. */
const appletsPart = {
  name: "applets-part",
  setup(build) {
    build.onLoad({ filter: /[\\/]js[\\/]wasm[\\/]curves-module\.js$/ }, async ({ path }) => {
      const contents = (await readFile(path, "utf8")).replaceAll("../glue/curves", "../glue/applet");
      return { contents, resolveDir: resolve(sources, "wasm") };
    });
  },
};

/**
 * Keeps the facade out of the bundles of the applet and the elements, so that a page which imports several of them has
 * one core and one wasm module. They must therefore go through js/index.js, and to nothing else of js/ than the folders
 * named here.
 */
const facadeExternal = (...folders) => ({
  name: "facade-external",
  setup(build) {
    build.onResolve({ filter: /^\.\.?\// }, ({ path, importer, resolveDir }) => {
      if (importer.includes("node_modules")) return undefined;
      const target = resolve(resolveDir, path);
      if (target === resolve(sources, "index.js")) return { path: "./index.js", external: true };
      const inside = folders.some((folder) => target.startsWith(resolve(sources, folder) + sep));
      if (inside || !importer) return undefined;
      const from = relative(sources, importer).split(sep).join("/");
      const allowed = folders.map((folder) => `js/${folder}`).join(", ");
      return { errors: [{ text: `js/${from} imports ${path}: it may import only js/index.js and from ${allowed}` }] };
    });
  },
});

/** What all bundles have in common. */
const bundleAs = (options) =>
  build({
    bundle: true,
    format: "esm",
    target: "es2022",
    charset: "utf8",
    legalComments: "none",
    logLevel: "warning",
    banner,
    ...options,
  });

/** Bundles one entry of js/ into one file of dist/. */
const bundle = (entry, name, options = {}) =>
  bundleAs({ entryPoints: [resolve(sources, entry)], outfile: `dist/${name}`, ...options });

/** What comes late: the part of a kind of element that draws, by the name of its file. */
const LATE = {
  "elements-applet": "elements/applet/drawing.js",
  "elements-companions": "elements/companions/views.js",
  "elements-surface": "elements/surface/drawing.js",
};

/** For other bundlers: this import is for the browser; esbuild leaves the comment out. */
const KEPT = "/* webpackIgnore: true *//* @vite-ignore */";

/**
 * The elements come in parts: elements.js, what is loaded only when an element of a kind comes near
 * (elements-applet.js …), and what several of them need (elements-shared.js, elements-shared-2.js …). The names stay the
 * same from version to version.
 */
async function elements() {
  const entries = Object.entries({ elements: "elements/index.js", ...LATE });
  const { outputFiles } = await bundleAs({
    entryPoints: Object.fromEntries(entries.map(([name, path]) => [name, resolve(sources, path)])),
    outdir: "dist",
    splitting: true,
    chunkNames: "elements-shared-[hash]",
    plugins: [facadeExternal("elements", "applet")],
    inject: ["xtask/no-dom.js"],
    minify: true,
    write: false,
  });
  const hashed = outputFiles.map(({ path }) => basename(path)).filter((name) => name.startsWith("elements-shared-"));
  const named = (text) =>
    hashed.reduce((result, name, i) => result.replaceAll(name, `elements-shared${i ? `-${i + 1}` : ""}.js`), text);
  const plain = (text) => named(text).replaceAll("import(`${", `import(${KEPT}\`\${`);
  await mkdir("dist", { recursive: true });
  await Promise.all(outputFiles.map(({ path, text }) => writeFile(`dist/${plain(basename(path))}`, plain(text))));
}

/** No part of an earlier build stays, to be published. */
const parts = (await readdir("dist").catch(() => [])).filter((name) => /^elements\b.*\.js$/.test(name));
await Promise.all(parts.map((name) => rm(`dist/${name}`)));
await Promise.all([
  bundle("index.js", "index.js"),
  bundle("slim.js", "slim.js", { plugins: [withoutBytes] }),
  bundle("applet/index.js", "applet.js", { plugins: [facadeExternal("applet")] }),
  elements(),
  bundle("applet/classic.js", "bezier-app.js", { format: "iife", minify: true, plugins: [appletsPart] }),
]);
