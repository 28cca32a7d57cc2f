// Bundles js/ into dist/ with esbuild. Called by `cargo xtask build`; runs from the repository's root.
import { build } from "esbuild";
import { mkdir, readFile, readdir, rm, writeFile } from "node:fs/promises";
import { basename, relative, resolve, sep } from "node:path";

const sources = resolve("js");
const { version, license } = JSON.parse(await readFile("package.json", "utf8"));
const banner = { js: `/*! casteljau ${version} | ${license} */` };

/** Replaces both modules by the complete one without bytes: in the slim bundle, `init` gets the bytes. */
const withoutBytes = {
  name: "without-bytes",
  setup(build) {
    const contents = {
      curves: `import { registerModule } from "./wasm-module.js"; import { initSync } from "../glue/casteljau.js";
        export const curvesModule = /* @__PURE__ */ registerModule(initSync, null);`,
      surfaces: `export { curvesModule as surfacesModule } from "./curves-module.js";`,
    };
    build.onLoad({ filter: /[\\/]js[\\/]wasm[\\/](curves|surfaces)-module\.js$/ }, ({ path }) => ({
      contents: contents[path.match(/(\w+)-module\.js$/)[1]],
      resolveDir: resolve(sources, "wasm"),
    }));
  },
};

/** Makes a bundle use other modules of js/glue: `{ curves: "core" }` uses the module core for curves. */
const useModules = (replacements) => ({
  name: "use-modules",
  setup(build) {
    build.onLoad({ filter: /[\\/]js[\\/]wasm[\\/](curves|surfaces)-module\.js$/ }, async ({ path }) => {
      const name = path.match(/(\w+)-module\.js$/)[1];
      if (!replacements[name]) return undefined;
      const contents = (await readFile(path, "utf8")).replaceAll(`../glue/${name}`, `../glue/${replacements[name]}`);
      return { contents, resolveDir: resolve(sources, "wasm") };
    });
  },
});

/** Makes the bundle of casteljau/surfaces use one module for surfaces and curves. */
const coreSurfaces = {
  name: "core-surfaces",
  setup(build) {
    build.onLoad({ filter: /[\\/]js[\\/]wasm[\\/]curves-module\.js$/ }, () => ({
      contents: `export { surfacesModule as curvesModule } from "./surfaces-module.js";`,
      resolveDir: resolve(sources, "wasm"),
    }));
    useModules({ surfaces: "core-surfaces" }).setup(build);
  },
};

/**
 * Makes index.js an external import of the bundles of the applet and the elements, so that a page which imports several
 * of them has one core and one wasm module. These bundles may therefore import only js/index.js and files of the given
 * folders.
 */
const indexExternal = (...folders) => ({
  name: "index-external",
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

/** Runs esbuild with the options that all bundles share. */
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

/** The entry points that are loaded on demand: the part of each kind of element that draws, by the name of its file. */
const ON_DEMAND = {
  "elements-applet": "elements/applet/drawing.js",
  "elements-companions": "elements/companions/views.js",
  "elements-surface": "elements/surface/drawing.js",
};

/** Tells other bundlers to leave an import to the browser; esbuild removes comments, so it is added afterwards. */
const IGNORE_COMMENTS = "/* webpackIgnore: true *//* @vite-ignore */";

/**
 * Bundles the elements in parts: elements.js, the parts that are loaded when an element of a kind is almost visible
 * (elements-applet.js …), and the parts that several of them import (elements-shared.js, elements-shared-2.js …). The
 * names are the same in each version.
 */
async function elements() {
  const entries = Object.entries({ elements: "elements/index.js", ...ON_DEMAND });
  const { outputFiles } = await bundleAs({
    entryPoints: Object.fromEntries(entries.map(([name, path]) => [name, resolve(sources, path)])),
    outdir: "dist",
    splitting: true,
    chunkNames: "elements-shared-[hash]",
    plugins: [indexExternal("elements", "applet")],
    inject: ["xtask/no-dom.js"],
    minify: true,
    write: false,
  });
  const sharedNames = outputFiles
    .map(({ path }) => basename(path))
    .filter((name) => name.startsWith("elements-shared-"));
  const withStableNames = (text) =>
    sharedNames.reduce((result, name, i) => result.replaceAll(name, `elements-shared${i ? `-${i + 1}` : ""}.js`), text);
  const finalText = (text) => withStableNames(text).replaceAll("import(`${", `import(${IGNORE_COMMENTS}\`\${`);
  await mkdir("dist", { recursive: true });
  await Promise.all(
    outputFiles.map(({ path, text }) => writeFile(`dist/${finalText(basename(path))}`, finalText(text))),
  );
}

// Remove the parts of earlier builds, so that they are not published.
const oldParts = (await readdir("dist").catch(() => [])).filter((name) => /^elements\b.*\.js$/.test(name));
await Promise.all(oldParts.map((name) => rm(`dist/${name}`)));
await Promise.all([
  bundle("index.js", "index.js"),
  bundle("core.js", "core.js", { plugins: [useModules({ curves: "core" })] }),
  bundle("surfaces.js", "surfaces.js", { plugins: [coreSurfaces] }),
  bundle("slim.js", "slim.js", { plugins: [withoutBytes] }),
  bundle("applet/index.js", "applet.js", { plugins: [indexExternal("applet")] }),
  elements(),
  bundle("applet/classic.js", "bezier-app.js", {
    format: "iife",
    minify: true,
    plugins: [useModules({ curves: "applet" })],
  }),
]);
