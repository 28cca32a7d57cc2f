// Builds the npm package, the site and what they need. As a program:
//
//     node scripts/build.js package | site | size | bench [OPTION …]
import { copyFile, cp, mkdir, readdir, rm } from "node:fs/promises";
import { homedir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { alone, cargo, node, root, run, target } from "./run.js";
import { checkNode, packages, rust } from "./setup.js";
import { filesBelow, unlessCurrent } from "./stamp.js";

/**
 * A release is what npm ships: several wasm modules, optimised for size. For development there is one module, compiled without
 * link-time optimisation.
 *
 * @typedef {"development" | "release"} Mode
 */

/** The scripts that write dist/ and target/js. */
const BUNDLERS = ["bundle", "complete-module", "manifest", "no-dom", "notices", "source-map", "texts"].map(
  (name) => `xtask/${name}.js`,
);
/** The bundles that a build makes, besides the files that these share. */
const BUNDLES =
  "index core easing applet nurbs nurbs-rational-curve surfaces slim bezier-app casteljau.global elements elements-applet elements-rational elements-surface elements-surface-rational"
    .split(" ")
    .map((name) => `dist/${name}.js`);

/** The program with wasm-bindgen's libraries. */
export const driver = join(target, "debug", process.platform === "win32" ? "xtask.exe" : "xtask");

/**
 * An act that a program does once, however often it is called: cargo, which compiles one thing at a time, would keep others waiting.
 *
 * @template {readonly unknown[]} A
 * @param {(...args: A) => Promise<void>} act
 */
function once(act) {
  /** @type {Map<string, Promise<void>>} */
  const done = new Map();
  return (/** @type {A} */ ...args) => {
    const key = JSON.stringify(args);
    const result = done.get(key) ?? act(...args);
    done.set(key, result);
    return result;
  };
}

export const buildDriver = once(() => cargo("build", "--quiet", "--package", "xtask"));

/** The program that makes the cases of generated calls. */
export const buildGenerator = once(() => cargo("build", "--quiet", "--package", "casteljau-generator"));

/** Compiles the bindings. @param {Mode} mode */
async function compile(mode) {
  const bindings = ["build", "--quiet", "--lib", "--package", "casteljau-wasm", "--target", "wasm32-unknown-unknown"];
  // RUSTFLAGS would replace the flags of .cargo/config.toml.
  const env = { RUSTFLAGS: undefined, CARGO_ENCODED_RUSTFLAGS: undefined };
  if (mode === "development") return run("cargo", bindings, { env });
  // Messages of panics contain paths of sources; the remapping removes the folders of this machine.
  const home = process.env.CARGO_HOME ?? join(homedir(), ".cargo");
  const flags = JSON.stringify([`--remap-path-prefix=${home}=cargo`, "-Clink-arg=--emit-relocs"]);
  const config = `target.wasm32-unknown-unknown.rustflags=${flags}`;
  return run("cargo", [...bindings, "--profile", "wasm", "--config", config], { env });
}

/** Builds js/glue: the bindings and the modules. */
export const glue = once(async (/** @type {Mode} */ mode) => {
  await buildDriver();
  await compile(mode);
  const folder = mode === "development" ? "debug" : "wasm";
  const compiled = join(target, "wasm32-unknown-unknown", folder, "casteljau.wasm");
  const modules = ["curves", "surfaces", "regions", "core", "core-surfaces", "nurbs", "nurbs-surfaces", "applet"];
  const files =
    mode === "development" ? ["casteljau-bytes.js"] : ["needs.json", ...modules.map((name) => `${name}-bytes.js`)];
  const outputs = ["casteljau.js", "casteljau.wasm", "functions.d.ts", ...files].map((name) => `js/glue/${name}`);
  const inputs = [compiled, driver];
  await alone("glue", () =>
    unlessCurrent({ name: "glue", inputs, texts: [mode], outputs }, () =>
      run(driver, [mode === "development" ? "development-glue" : "glue", compiled]),
    ),
  );
});

/** Builds the bundles in dist/ and the scripts in target/js, from js/ with the glue. @param {Mode} mode */
export const bundles = (mode) =>
  unlessCurrent(
    {
      name: "bundles",
      texts: [mode],
      inputs: [...filesBelow("js"), ...BUNDLERS, "package.json", "package-lock.json", "Cargo.lock"],
      outputs: [
        ...BUNDLES,
        ...["casteljau.wasm", "custom-elements.json", "texts.json"].map((name) => `dist/${name}`),
        "dist/THIRD-PARTY-NOTICES.txt",
        "target/js/index.js",
      ],
    },
    async () => {
      await mkdir(join(root, "dist"), { recursive: true });
      await node("xtask/bundle.js", mode);
      await node("xtask/manifest.js");
      await node("xtask/texts.js");
      await copyFile(join(root, "js/glue/casteljau.wasm"), join(root, "dist/casteljau.wasm"));
    },
  );

/** Builds dist/types from js/; a type error fails. */
export const types = () =>
  unlessCurrent(
    {
      name: "types",
      inputs: [
        ...filesBelow("js").filter((name) => !/(-bytes\.js|\.wasm)$/.test(name)), // these have no types
        ...["tsconfig.json", "package-lock.json"],
      ],
      outputs: ["index", "core", "surfaces", "nurbs", "easing", "applet/classic"].map(
        (name) => `dist/types/${name}.d.ts`,
      ),
    },
    async () => {
      await rm(join(root, "dist/types"), { recursive: true, force: true }); // declarations of deleted files
      await node("node_modules/typescript/bin/tsc", "--project", "tsconfig.json");
    },
  );

/** Builds dist/custom, the command that makes modules with some of the methods; from a release. */
const custom = () =>
  unlessCurrent(
    {
      name: "custom",
      inputs: [
        ...filesBelow("js").filter((name) => !/(-bytes\.js|\.wasm)$/.test(name)),
        ...filesBelow("custom"),
        ...["xtask/pieces.js", "tsconfig.json", "package.json", "package-lock.json"],
      ],
      outputs: ["command.js", "needs.json", "pieces.json"].map((name) => `dist/custom/${name}`),
    },
    () => node("xtask/pieces.js"),
  );

/** Builds all of dist/. @param {Mode} mode */
export async function packageFiles(mode) {
  await glue(mode);
  await alone("dist", async () => {
    await bundles(mode);
    await types();
    if (mode === "release") await custom();
  });
}

const RUST_DOCS = ["doc", "--quiet", "--no-deps", "--package", "casteljau", "--features", "serde,kurbo"];

/** Builds the Rust documentation in target/doc; a warning fails. */
export const rustDocs = () => run("cargo", RUST_DOCS, { env: { RUSTDOCFLAGS: "--deny warnings" } });

/** Builds the site, with relative URLs, in site/, and the Rust documentation in site/rust/. */
export const site = () =>
  alone("dist", () =>
    unlessCurrent(
      {
        name: "site",
        inputs: [
          ...filesBelow("www"),
          ...filesBelow("custom"),
          ...filesBelow("src"),
          ...filesBelow("kernels/src"),
          ...filesBelow("dist").filter((name) => /\.js(on)?$/.test(name)), // classes and modules are in files of their own
          ...["README.md", "benches/results.json", "package-lock.json"],
        ],
        outputs: ["site/index.html"],
      },
      async () => {
        await node("node_modules/vite/bin/vite.js", "build", "--config", "www/vite.config.js");
        await rustDocs();
        // target/doc may have other packages as well.
        const shared = ["casteljau", "src", "static.files", "search.index", "trait.impl", "type.impl"];
        for (const item of await readdir(join(target, "doc"), { withFileTypes: true }))
          if (item.isFile() || shared.includes(item.name))
            await cp(join(target, "doc", item.name), join(root, "site/rust", item.name), { recursive: true });
      },
    ),
  );

const COMMANDS = {
  package: () => packageFiles("release"),
  site: async () => {
    await packageFiles("release");
    await site();
  },
  size: async () => {
    await packageFiles("release");
    await node("xtask/size.js");
  },
  // The benchmarks in JavaScript run last, because their table has the native results, too.
  bench: async (/** @type {string[]} */ ...options) => {
    await packageFiles("release");
    const isFlag = (/** @type {string} */ option) => option.startsWith("--");
    const words = options.filter((option) => !isFlag(option)).join("|"); // criterion takes one regular expression
    const filter = [...options.filter(isFlag), ...(words ? [words] : [])];
    await cargo("bench", "--package", "casteljau-benches", "--benches", "--", ...filter);
    await node("benches/js/run.js", ...options);
  },
};

if (import.meta.url === pathToFileURL(process.argv[1] ?? "").href) {
  const [name, ...options] = process.argv.slice(2);
  const act = Object.hasOwn(COMMANDS, name) ? COMMANDS[/** @type {keyof typeof COMMANDS} */ (name)] : undefined;
  try {
    if (!act) throw new Error(`expected one of ${Object.keys(COMMANDS).join(", ")}, got ${name ?? "nothing"}`);
    checkNode();
    await Promise.all([rust(), packages("all")]);
    await act(...options);
  } catch (error) {
    console.error(`\nerror: ${/** @type {Error} */ (error).message}`);
    process.exitCode = 1;
  }
}
