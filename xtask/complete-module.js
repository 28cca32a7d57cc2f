// The contents of js/wasm/*-module.ts where one wasm module has the functions of all: in some bundles, and for development.
import { dirname } from "node:path";

/** The files whose contents these are; the first group is their key. */
export const MODULE_FILES = /[\\/]js[\\/]wasm[\\/](curves|surfaces|regions|nurbs)-module\.ts$/;

/**
 * @param {string} bytes code for the bytes
 * @param {string} [imports] code before it
 * @returns {Record<string, string>}
 */
export const completeModule = (bytes, imports = "") => ({
  curves: `import { registerModule } from "./wasm-module.js"; import { initSync } from "../glue/casteljau.js"; ${imports}
    export const curvesModule = /* @__PURE__ */ registerModule(initSync, ${bytes});`,
  surfaces: `export { curvesModule as surfacesModule } from "./curves-module.js";`,
  regions: `export { curvesModule as regionsModule } from "./curves-module.js";`,
  nurbs: `export const setCurveBytes = () => {};`,
});

/**
 * A plugin for esbuild that gives the files these contents.
 *
 * @param {string} name
 * @param {Record<string, string>} contents
 * @returns {import("esbuild").Plugin}
 */
export const replacedModules = (name, contents) => ({
  name,
  setup: (build) =>
    build.onLoad({ filter: MODULE_FILES }, ({ path }) => ({
      contents: contents[MODULE_FILES.exec(path)?.[1] ?? ""],
      resolveDir: dirname(path),
    })),
});

/** With the module that is compiled for development. */
export const developmentModule = completeModule(
  "{ alphabet, frequent, length, text }",
  `import { alphabet, frequent, length, text } from "../glue/casteljau-bytes.js";`,
);
