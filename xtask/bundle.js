// Bundles js/ into dist/ with esbuild. Called by `cargo xtask build`; runs from the repository's root.
import { build } from "esbuild";
import { mkdir, readFile, readdir, rm, writeFile } from "node:fs/promises";
import { basename, relative, resolve, sep } from "node:path";
import { noticesText } from "./notices.js";
import { replaceMapped, withoutContents } from "./source-map.js";

const sources = resolve("js");
const { version, license } = JSON.parse(await readFile("package.json", "utf8"));
const banner = { js: `/*! casteljau ${version} | ${license} */` };

/** Replaces the modules by the complete one without bytes: in the slim bundle, `init` gets the bytes. */
const withoutBytes = {
  name: "without-bytes",
  setup(build) {
    const contents = {
      curves: `import { registerModule } from "./wasm-module.js"; import { initSync } from "../glue/casteljau.js";
        export const curvesModule = /* @__PURE__ */ registerModule(initSync, null);`,
      surfaces: `export { curvesModule as surfacesModule } from "./curves-module.js";`,
      regions: `export { curvesModule as regionsModule } from "./curves-module.js";`,
    };
    build.onLoad({ filter: /[\\/]js[\\/]wasm[\\/](curves|surfaces|regions)-module\.js$/ }, ({ path }) => ({
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

/** The files that went into the bundles. */
const inputs = new Set();

/** Options of scripts that run without a module: they are ASCII, since a page may not declare its encoding. */
const CLASSIC = { format: "iife", charset: "ascii" };

/** Runs esbuild with the options that all bundles share; the results are in memory. */
async function bundleAs(options) {
  const { outputFiles, metafile } = await build({
    bundle: true,
    format: "esm",
    target: "es2022",
    charset: "utf8",
    minify: true,
    lineLimit: 500, // Node prints the line of an error that nothing catches: without a limit, all of the script
    sourcemap: "linked",
    legalComments: "none", // THIRD-PARTY-NOTICES.txt has them
    logLevel: "warning",
    outdir: "dist",
    metafile: true,
    write: false,
    banner,
    ...options,
  });
  for (const path of Object.keys(metafile.inputs)) inputs.add(path);
  const files = Object.fromEntries(outputFiles.map(({ path, text }) => [basename(path), text]));
  for (const name of namesOfScripts(files)) markPureCalls(files, name);
  return files;
}

const namesOfScripts = (files) => Object.keys(files).filter((name) => name.endsWith(".js"));

/** Replaces text of a script and adapts its source map. */
function edit(files, name, pattern, replacement) {
  const { mappings, ...map } = JSON.parse(files[`${name}.map`]);
  const result = replaceMapped(files[name], mappings, pattern, replacement);
  files[name] = result.code;
  files[`${name}.map`] = JSON.stringify({ ...map, mappings: result.mappings });
}

/**
 * Marks the registration of wasm modules and the definition of `easing` as free of side effects, so that bundlers can
 * drop them where they are not used: esbuild removes these marks with the other comments.
 */
function markPureCalls(files, name) {
  edit(files, name, /(?<==)Object\.assign\(\(\.\.\.[\w$]+\)=>/g, (found) => `/* @__PURE__ */${found}`);
  let count = 0;
  edit(files, name, /(?<==)[\w$]+\([\w$]+,\{alphabet:/g, (found) => {
    count++;
    return `/* @__PURE__ */${found}`;
  });
  const expected = new Set(files[name].match(/(?<=[,{]alphabet:)[\w$]+/g)).size;
  if (count !== expected) throw new Error(`${name}: expected ${expected} registrations of wasm modules, got ${count}`);
}

/** Keeps the names of the exported classes, which esbuild shortens. */
function keepClassNames(files, name) {
  const list = files[name].match(/export\{([^}]*)\}/)?.[1].split(",") ?? [];
  for (const [short, long] of list.map((item) => item.split(" as "))) {
    if (!/^[A-Z]/.test(long ?? "")) continue;
    const id = short.replaceAll("$", "\\$");
    const start = new RegExp(`(?:(?<![\\w$])${id}=class(?: [\\w$]+)?|class ${id})(?: extends [\\w$]+)?\\{`, "g");
    let count = 0;
    edit(files, name, start, (found) => `${found}${count++ ? "" : `static name="${long}";`}`);
    if (count !== 1) throw new Error(`${name}: expected one class ${long}, got ${count}`);
  }
}

/** Whether a source holds a wasm module as text: source maps do not repeat it. */
const isWasmText = (source) => source.endsWith("-bytes.js");

/** Writes built files to dist/. */
const write = (files) =>
  Promise.all(
    Object.entries(files).map(([name, text]) =>
      writeFile(`dist/${name}`, name.endsWith(".map") ? withoutContents(text, isWasmText) : text),
    ),
  );

/** Bundles one entry of js/ into one file of dist/. */
async function bundle(entry, name, options = {}) {
  const entryPoints = { [name.replace(/\.js$/, "")]: resolve(sources, entry) };
  const files = await bundleAs({ entryPoints, ...options });
  keepClassNames(files, name);
  await write(files);
}

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
  const files = await bundleAs({
    entryPoints: Object.fromEntries(entries.map(([name, path]) => [name, resolve(sources, path)])),
    splitting: true,
    chunkNames: "elements-shared-[hash]",
    plugins: [indexExternal("elements", "applet")],
    inject: ["xtask/no-dom.js"],
  });
  const hashes = Object.keys(files).flatMap((name) => name.match(/^elements-shared-(\w+)\.js$/)?.[1] ?? []);
  const stableName = (name) => {
    const index = hashes.findIndex((hash) => name.includes(`-${hash}`));
    return index < 0 ? name : name.replace(`-${hashes[index]}`, index ? `-${index + 1}` : "");
  };
  const edited = (found) => (found.startsWith("import(") ? `import(${IGNORE_COMMENTS}\`\${` : stableName(found));
  for (const name of namesOfScripts(files))
    edit(files, name, /elements-shared-\w+\.js(?:\.map)?|import\(`\$\{/g, edited);
  await write(Object.fromEntries(Object.entries(files).map(([name, text]) => [stableName(name), text])));
}

// Remove the files of earlier builds, so that they are not published.
await mkdir("dist", { recursive: true });
const oldFiles = (await readdir("dist")).filter((name) => /\.js(\.map)?$/.test(name));
await Promise.all(oldFiles.map((name) => rm(`dist/${name}`)));
await Promise.all([
  bundle("index.js", "index.js"),
  bundle("easing.js", "easing.js"),
  bundle("core.js", "core.js", { plugins: [useModules({ curves: "core" })] }),
  bundle("surfaces.js", "surfaces.js", { plugins: [coreSurfaces] }),
  bundle("slim.js", "slim.js", { plugins: [withoutBytes] }),
  bundle("index.js", "casteljau.global.js", { ...CLASSIC, globalName: "casteljau" }),
  bundle("applet/index.js", "applet.js", { plugins: [indexExternal("applet")] }),
  elements(),
  bundle("applet/classic.js", "bezier-app.js", {
    ...CLASSIC,
    plugins: [useModules({ curves: "applet" })],
  }),
]);
await writeFile("dist/THIRD-PARTY-NOTICES.txt", await noticesText([...inputs]));
