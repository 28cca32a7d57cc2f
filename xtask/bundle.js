// Bundles js/ into dist/ with esbuild. Called by `cargo xtask build`; runs from the repository's root.
import { build } from "esbuild";
import { readFile } from "node:fs/promises";
import { dirname, relative, resolve, sep } from "node:path";

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
 * one core and one wasm module. They must therefore go through js/index.js and nothing else of js/.
 */
const facadeExternal = (folder) => ({
  name: "facade-external",
  setup(build) {
    build.onResolve({ filter: /^\.\.?\// }, ({ path, importer, resolveDir }) => {
      if (importer.includes("node_modules")) return undefined;
      const target = resolve(resolveDir, path);
      if (target === resolve(sources, "index.js")) return { path: "./index.js", external: true };
      const inside = dirname(target).startsWith(resolve(sources, folder));
      if (inside || !importer) return undefined;
      const from = relative(sources, importer).split(sep).join("/");
      return { errors: [{ text: `js/${from} imports ${path}: js/${folder} may import only ../index.js of the package` }] };
    });
  },
});

/** Bundles one entry of js/ into one file of dist/. */
const bundle = (entry, name, options = {}) =>
  build({
    entryPoints: [resolve(sources, entry)],
    outfile: `dist/${name}`,
    bundle: true,
    format: "esm",
    target: "es2022",
    charset: "utf8",
    legalComments: "none",
    logLevel: "warning",
    banner,
    ...options,
  });

await Promise.all([
  bundle("index.js", "index.js"),
  bundle("slim.js", "slim.js", { plugins: [withoutBytes] }),
  bundle("applet/index.js", "applet.js", { plugins: [facadeExternal("applet")] }),
  bundle("elements/index.js", "elements.js", { plugins: [facadeExternal("elements")], inject: ["xtask/no-dom.js"], minify: true }),
  bundle("applet/classic.js", "bezier-app.js", { format: "iife", minify: true, plugins: [appletsPart] }),
]);
