// Bundles js/ into dist/ with esbuild, for a release or for development. Called by scripts/build.js; runs from the repository's root.
import { build } from "esbuild";
import { mkdir, readFile, readdir, rm, writeFile } from "node:fs/promises";
import { basename, relative, resolve, sep } from "node:path";
import { completeModule, developmentModule, replacedModules } from "./complete-module.js";
import { noticesText } from "./notices.js";
import { replaceMapped, withoutContents } from "./source-map.js";

const [mode] = process.argv.slice(2);
if (mode !== "release" && mode !== "development") throw new Error(`expected release or development, got ${mode}`);
const sources = resolve("js");
const { version, license } = JSON.parse(await readFile("package.json", "utf8"));
const banner = { js: `/*! casteljau ${version} | ${license} */` };

/** Replaces the modules by the complete one without bytes: in the slim bundle, `init` gets the bytes. */
const withoutBytes = replacedModules("without-bytes", completeModule("null"));

/** Replaces the modules by the complete one, which is read from its file: in the bundles for Node. */
const fromFile = replacedModules(
  "from-file",
  completeModule(
    "bytes",
    `import { readFileSync } from "node:fs";
  function bytes() {
    const file = new URL("../casteljau.wasm", import.meta.url);
    try {
      return readFileSync(file);
    } catch (cause) {
      throw new Error(\`casteljau: \${file} cannot be read; bundlers need the condition "module"\`, { cause });
    }
  }`,
  ),
);

/** Replaces the modules by the one that is compiled for development. */
const forDevelopment = replacedModules("for-development", developmentModule);

/** Makes a bundle use other modules of js/glue: `{ curves: "core" }` uses the module core for curves. */
const useModules = (replacements) => ({
  name: "use-modules",
  setup(build) {
    build.onLoad({ filter: /[\\/]js[\\/]wasm[\\/](curves|surfaces)-module\.ts$/ }, async ({ path }) => {
      const name = path.match(/(\w+)-module\.ts$/)[1];
      if (!replacements[name]) return undefined;
      const contents = (await readFile(path, "utf8")).replaceAll(`../glue/${name}`, `../glue/${replacements[name]}`);
      return { contents, loader: "ts", resolveDir: resolve(sources, "wasm") };
    });
  },
});

/** Makes the bundle of casteljau/surfaces use one module for surfaces and curves. */
const coreSurfaces = {
  name: "core-surfaces",
  setup(build) {
    build.onLoad({ filter: /[\\/]js[\\/]wasm[\\/]curves-module\.ts$/ }, () => ({
      contents: `export { surfacesModule as curvesModule } from "./surfaces-module.js";`,
      resolveDir: resolve(sources, "wasm"),
    }));
    useModules({ surfaces: "core-surfaces" }).setup(build);
  },
};

/**
 * Makes casteljau/nurbs use one module for curves and one for surfaces. `setCurveBytes` of js/wasm/nurbs-module.ts sets the bytes of
 * the first; `<bezier-surface>` does not call it, because it calls no function of curves.
 */
const nurbsModules = {
  name: "nurbs-modules",
  setup(build) {
    build.onLoad({ filter: /[\\/]js[\\/]wasm[\\/]curves-module\.ts$/ }, () => ({
      contents: `import { registerModule } from "./wasm-module.js"; import { initSync } from "../glue/nurbs.js";
        export const curvesModule = /* @__PURE__ */ registerModule(initSync, () => {
          throw new Error("casteljau: functions of the curves of a <bezier-surface> need an import of casteljau/nurbs");
        });`,
      resolveDir: resolve(sources, "wasm"),
    }));
    useModules({ surfaces: "nurbs-surfaces" }).setup(build);
  },
};

/** Makes the bundle of the small applet, which exposes no curves, use the classes of casteljau/core. */
const coreClasses = {
  name: "core-classes",
  setup(build) {
    const replace = (folder, name) =>
      build.onLoad({ filter: new RegExp(`[\\\\/]js[\\\\/]geometry[\\\\/]${folder}[\\\\/]${folder}\\.ts$`) }, () => ({
        contents: `export { Core${name} as ${name} } from "./core-${folder}.js";`,
        resolveDir: resolve(sources, "geometry", folder),
      }));
    replace("curve", "Curve");
    replace("spline", "Spline");
  },
};

/** Sources that are not bundled with the elements, and the bundles that the elements import instead. */
const EXTERNAL_BUNDLES = {
  "surfaces.js": "surfaces.js",
  "nurbs.js": "nurbs-rational-curve.js",
  "elements/surface/rational.js": "elements-surface-rational.js",
};

/** Replaces imports of these sources by imports of the bundles. */
const externalBundles = {
  name: "external-bundles",
  setup(build) {
    build.onResolve({ filter: /[\\/](surfaces|nurbs|rational)\.js$/ }, ({ path, resolveDir }) =>
      Object.entries(EXTERNAL_BUNDLES)
        .filter(([source]) => resolve(resolveDir, path) === resolve(sources, source))
        .map(([, name]) => ({ path: `./${name}`, external: true, sideEffects: false }))
        .at(0),
    );
  },
};

/** Marks the exported classes with their names, because esbuild shortens them; `restoreClassNames` replaces the marks. */
const markClassNames = {
  name: "mark-class-names",
  setup(build) {
    build.onLoad({ filter: /[\\/]js[\\/]geometry[\\/]/ }, async ({ path }) => {
      const contents = await readFile(path, "utf8");
      const marked = contents.replace(
        /^(export class (?:Core)?(Curve|RationalCurve|NurbsCurve|RationalPatch|NurbsSurface|RationalSurface|Spline|Path|PathBuilder|InkStroke|Patch|Surface|Mesh)\b.*\{)$/m,
        '$1 static className = "$2";',
      );
      return { contents: marked, loader: "ts" };
    });
  },
};

/** Gives marked classes their own names: their property `name`, and errors of calls without `new`, show them. */
function restoreClassNames(files, name) {
  edit(files, name, /=class((?: extends [\w$]+)?)\{static className="(\w+)";/g, (found) =>
    found.replace(/=class((?: extends [\w$]+)?)\{static className="(\w+)";/, "=class $2$1{"),
  );
  if (files[name].includes("static className="))
    throw new Error(`${name}: expected classes without a name of their own`);
}

/** The files that went into the bundles. */
const inputs = new Set();

/** Options of scripts that run without a module: they are ASCII, since a page may not declare its encoding. */
const CLASSIC = { format: "iife", charset: "ascii" };

/** Runs esbuild with the options that all bundles share; the results are in memory. */
async function bundleAs({ plugins = [], ...options }) {
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
    plugins: [...plugins, markClassNames],
    ...options,
  });
  for (const path of Object.keys(metafile.inputs)) inputs.add(path);
  const nameOf = (path) => relative(resolve("dist"), resolve(path)).split(sep).join("/");
  const files = Object.fromEntries(outputFiles.map(({ path, text }) => [nameOf(path), text]));
  for (const name of namesOfScripts(files)) {
    markPureCalls(files, name);
    restoreClassNames(files, name);
  }
  const outputs = Object.fromEntries(Object.entries(metafile.outputs).map(([path, output]) => [nameOf(path), output]));
  return { files, outputs };
}

const namesOfScripts = (files) => Object.keys(files).filter((name) => name.endsWith(".js"));

/** Replaces text of a script and adapts its source map, if it has one. */
function edit(files, name, pattern, replacement) {
  if (!files[`${name}.map`]) {
    files[name] = files[name].replace(pattern, replacement);
    return;
  }
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
  await write((await bundleAs({ entryPoints, ...options })).files);
}

/** The entry points that share their files; the last ones are loaded when an element of a kind is almost visible. */
const SHARING = {
  index: "index.ts",
  easing: "easing.ts",
  applet: "applet/index.ts",
  elements: "elements/index.ts",
  "elements/applet": "elements/define/applet.ts",
  "elements/bernstein": "elements/define/bernstein.ts",
  "elements/coordinates": "elements/define/coordinates.ts",
  "elements/easing": "elements/define/easing.ts",
  "elements/equation": "elements/define/equation.ts",
  "elements/surface": "elements/define/surface.ts",
  "elements-applet": "elements/applet/drawing.ts",
  "elements-bernstein": "elements/companions/bernstein-view.ts",
  "elements-coordinates": "elements/companions/coordinates-view.ts",
  "elements-easing": "elements/companions/easing-view.ts",
  "elements-equation": "elements/companions/equation-view.ts",
  "elements-rational": "elements/applet/rational.ts",
  "elements-surface": "elements/surface/drawing.ts",
};

/** The entry points of casteljau/nurbs, which share files of their own; the elements load the last two for weights. */
const SHARING_WEIGHTS = {
  nurbs: "entries/nurbs.ts",
  "nurbs-rational-curve": "entries/rational-curve.ts",
  "elements-surface-rational": "elements/surface/rational.ts",
};

/** Tells other bundlers to leave an import to the browser; esbuild removes comments, so it is added afterwards. */
const IGNORE_COMMENTS = "/* webpackIgnore: true *//* @vite-ignore */";

/**
 * Bundles entry points so that each class and each wasm module is in one file, which the others import. The files that
 * several entry points import have the name of their longest source: it does not change with each version.
 */
async function sharing(entries, { folder = "", prefix = "shared", ...options }) {
  const { files, outputs } = await bundleAs({
    entryPoints: Object.fromEntries(
      Object.entries(entries).map(([name, path]) => [folder + name, resolve(sources, path)]),
    ),
    splitting: true,
    chunkNames: `${folder}chunk-[hash]`,
    ...options,
  });
  const stable = new Map();
  for (const name of Object.keys(outputs)
    .filter((path) => /chunk-\w+\.js$/.test(path))
    .sort()) {
    const contents = Object.entries(outputs[name].inputs).sort(([, a], [, b]) => b.bytesInOutput - a.bytesInOutput);
    const paths = contents.map(([path]) => path);
    const inElements = paths.some((path) => path.startsWith("js/elements/"));
    const longest = basename(paths[0] ?? "nothing").replace(/(-bytes)?\.[jt]s$/, "");
    const title = `${inElements ? "elements-shared" : prefix}-${longest}`;
    const taken = [...stable.values()].filter((each) => each.startsWith(title)).length;
    stable.set(basename(name, ".js"), `${title}${taken ? `-${taken + 1}` : ""}`);
  }
  const stableName = (text) => text.replace(/chunk-\w+(?=\.js)/g, (found) => stable.get(found) ?? found);
  const edited = (found) => {
    if (found.startsWith("import(")) return `import(${IGNORE_COMMENTS}\`\${`;
    const renamed = stableName(found);
    // Only files of the elements have side effects; other imports without names would make bundlers warn.
    return /^import"\.\.?\/shared-/.test(renamed) ? "" : renamed;
  };
  const pattern = /import"[./]+chunk-\w+\.js";|chunk-\w+\.js(?:\.map)?|import\(`\$\{/g;
  const external = new RegExp(`"\\./(?=(${Object.values(EXTERNAL_BUNDLES).join("|")})")`, "g");
  for (const name of namesOfScripts(files)) {
    edit(files, name, pattern, edited);
    // The imports of external bundles have the same text in every folder.
    if (name.startsWith("elements/")) edit(files, name, external, () => '"../');
  }
  await write(Object.fromEntries(Object.entries(files).map(([name, text]) => [stableName(name), text])));
}

/** Writes js/ as JavaScript to target/js/, a file for each file: tests and the build of the site import parts of it in Node. */
async function transpile() {
  const names = (await readdir(sources, { recursive: true })).filter((name) => /(?<!\.d)\.[jt]s$/.test(name));
  await rm("target/js", { recursive: true, force: true });
  const entryPoints = names.map((name) => resolve(sources, name));
  const plugins = mode === "development" ? [forDevelopment] : [];
  await build({ entryPoints, outbase: sources, outdir: "target/js", target: "es2022", charset: "utf8", plugins });
  // The module "curves" has no functions of rational curves: as in dist/, elements get these from the bundle that stands alone.
  await writeFile("target/js/nurbs.js", 'export * from "casteljau/nurbs";\n');
}

/** The plugins of a bundle: those of a release, or the one for development. @param {...any} release */
const modules = (...release) => (mode === "release" ? release : [forDevelopment]);

// Remove the files of earlier builds, so that they are not published.
for (const folder of ["dist/custom", "dist/elements", "dist/node"]) await rm(folder, { recursive: true, force: true });
await Promise.all(["dist/elements", "dist/node"].map((folder) => mkdir(folder, { recursive: true })));
const oldFiles = (await readdir("dist")).filter((name) => /\.js(\.map)?$/.test(name));
await Promise.all(oldFiles.map((name) => rm(`dist/${name}`)));
await Promise.all([
  sharing(SHARING, { plugins: [externalBundles, ...modules()], inject: ["xtask/no-dom.js"] }),
  sharing(
    { index: "index.ts" },
    {
      folder: "node/",
      plugins: [fromFile],
      platform: "node",
      sourcemap: false,
    },
  ),
  bundle("entries/core.ts", "core.js", { plugins: modules(useModules({ curves: "core" })) }),
  sharing(SHARING_WEIGHTS, { prefix: "weights", plugins: modules(nurbsModules) }),
  bundle("entries/surfaces.ts", "surfaces.js", { plugins: modules(coreSurfaces) }),
  bundle("slim.ts", "slim.js", { plugins: [withoutBytes] }),
  // What casteljau/react, casteljau/vue and casteljau/svelte are when a program runs: nothing.
  bundle("elements/react.ts", "types-only.js"),
  bundle("index.ts", "casteljau.global.js", { ...CLASSIC, globalName: "casteljau", plugins: modules() }),
  bundle("applet/classic.ts", "bezier-app.js", {
    ...CLASSIC,
    plugins: [coreClasses, ...modules(useModules({ curves: "applet" }))],
  }),
]);
await transpile();
await writeFile("dist/THIRD-PARTY-NOTICES.txt", await noticesText([...inputs]));
