// Bundles js/ into dist/ with esbuild. Called by `cargo xtask build`; runs from the repository's root.
import { build } from "esbuild";
import { readFile, readdir, rm } from "node:fs/promises";
import { relative, resolve, sep } from "node:path";

const sources = resolve("js");
const { version, license } = JSON.parse(await readFile("package.json", "utf8"));
const banner = { js: `/*! casteljau ${version} | ${license} */` };

/** One gate to the whole module, without bytes: the slim bundle is told where they are by `init`. */
const withoutBytes = {
  name: "without-bytes",
  setup(build) {
    const contents = {
      curves: `import { gate } from "./gate.js"; import { initSync } from "./glue/casteljau.js";
        export const curves = /* @__PURE__ */ gate(initSync, null);`,
      surfaces: `export { curves as surfaces } from "./curves-gate.js";`,
    };
    build.onLoad({ filter: /[\\/]js[\\/](curves|surfaces)-gate\.js$/ }, ({ path }) => ({
      contents: contents[path.match(/(\w+)-gate\.js$/)[1]],
      resolveDir: sources,
    }));
  },
};

/** The gate to the module that has only what the applet calls: the classic script hands no curve out. */
const appletsPart = {
  name: "applets-part",
  setup(build) {
    build.onLoad({ filter: /[\\/]js[\\/]curves-gate\.js$/ }, async ({ path }) => {
      const contents = (await readFile(path, "utf8")).replaceAll("./glue/curves", "./glue/applet");
      return { contents, resolveDir: sources };
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
const bundle = (entry, name, options = {}) => bundleAs({ entryPoints: [resolve(sources, entry)], outfile: `dist/${name}`, ...options });

/**
 * The elements come in parts: elements.js, what is loaded only when a surface comes near (elements-surface.js), and what
 * both need (elements-shared.js). The names stay the same from version to version.
 */
const elements = () =>
  bundleAs({
    entryPoints: { elements: resolve(sources, "elements/index.js"), "elements-surface": resolve(sources, "elements/surface/stage.js") },
    outdir: "dist",
    splitting: true,
    chunkNames: "elements-shared",
    plugins: [facadeExternal("elements", "applet")],
    inject: ["xtask/no-dom.js"],
    minify: true,
  });

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
