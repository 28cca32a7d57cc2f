// The steps of `npm test`, `npm run test:all` and `npm run test:deep`.
import { existsSync } from "node:fs";
import { mkdir, readFile, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { browser, Skipped } from "./browsers.js";
import { buildDriver, buildGenerator, bundles, driver, glue, packageFiles, rustDocs, site, types } from "./build.js";
import { chooseRustTests, testBinaries } from "./choose.js";
import { alone, cargo, node, outputOf, root, run, runAll, target } from "./run.js";
import { hasRust } from "./setup.js";
import { filesBelow } from "./stamp.js";

/** @typedef {import("./lanes.js").Step} Step @typedef {import("./lanes.js").Context} Context */

/** Tests are silent for so long only if they hang: those of `npm test`, and the others, of which some take minutes. */
const SILENCE_MS = { few: 120_000, usual: 600_000, many: 3_600_000 };

/** The variables by which tests know how many cases are wanted, and where they report that they are skipped. @param {Context} context */
const variables = ({ amount, cases, skipped }) => ({
  CASTELJAU_FEW: amount === "few" ? "1" : undefined,
  CASTELJAU_DEEP: amount === "many" ? "1" : undefined,
  CASTELJAU_CASES: cases === undefined ? process.env.CASTELJAU_CASES : String(cases),
  CASTELJAU_SKIPPED: skipped,
});

// Formats and lints

/** The samples of the site are modules that a macro declares, where `cargo fmt` does not find them. */
const fmt = () =>
  runAll([
    () => cargo("fmt", "--all", "--check"),
    () => {
      const samples = filesBelow("www/samples").filter((name) => name.endsWith(".rs"));
      return run("rustfmt", ["--check", "--edition", "2024", ...samples]);
    },
  ]);

const lintJs = () => node("node_modules/@biomejs/biome/bin/biome", "check", "--error-on-warnings");

const structure = async () => {
  await buildDriver();
  await run(driver, ["structure"]);
};

const DENY = ["--", "--deny", "warnings"];
const BINDINGS = ["--package", "casteljau-wasm", "--target", "wasm32-unknown-unknown"];

/** Curves, splines and paths alone, each feature alone, and pairs of which one has code for the other. */
const FEATURE_SETS = [
  ...["", "count-work", "easing", "fast", "fit", "io", "kurbo", "nurbs", "rayon", "regions", "serde", "surfaces"],
  ...["count-work,regions", "io,surfaces", "serde,easing", "serde,regions", "serde,surfaces"],
];

const clippy = () => {
  const all = ["casteljau", "casteljau-benches", "casteljau-kernels"].flatMap((name) => ["--package", name]);
  return runAll([
    () => cargo("clippy", "--quiet", "--all-targets", ...all, "--all-features", ...DENY),
    // The library only, because the tests need all subjects.
    ...FEATURE_SETS.map((features) => () => {
      const words = ["--package", "casteljau", "--lib", "--no-default-features", "--features", features];
      return cargo("clippy", "--quiet", ...words, ...DENY);
    }),
    () => cargo("clippy", "--quiet", "--all-targets", "--package", "xtask", ...DENY),
    // The bindings, with the sources of the crate.
    () => cargo("clippy", "--quiet", ...BINDINGS, ...DENY),
  ]);
};

// Rust tests

const FEATURES = ["--features", "casteljau/serde,casteljau/kurbo"];

/**
 * `cargo test`: compiles, then runs, and fails if no test has run.
 *
 * @param {Context} context
 * @param {readonly string[]} words
 * @param {readonly string[]} tests parts of test names
 */
async function cargoTest(context, words, tests) {
  await cargo("test", "--quiet", "--no-run", ...words);
  const options = { env: variables(context), silence: SILENCE_MS[context.amount] };
  if (tests.length > 0) {
    const listed = ["test", "--quiet", ...words, "--", "--list", ...tests];
    const known = await outputOf("cargo", listed);
    if (known !== undefined && !/: test$/m.test(known))
      throw new Error(`expected a part of a test's name, got ${tests.join(", ")}`);
  }
  await run("cargo", ["test", "--no-fail-fast", ...words, "--", ...tests], options);
}

/** @param {Context} context @param {readonly string[]} [features] */
function native(context, features = FEATURES) {
  const binaries = testBinaries();
  const { targets, tests } = chooseRustTests(context.filters, binaries);
  // The crates' own unit tests compile them once more: `npm test` does without.
  const own = context.amount === "few" || targets.length > 0 ? [] : ["--package", "casteljau-kernels", "--lib"];
  const named = (targets.length > 0 ? targets : binaries.map(({ name }) => name)).flatMap((name) => ["--test", name]);
  return cargoTest(context, ["--package", "casteljau", ...features, ...own, ...named], tests);
}

/** What the wasm modules contain: the crate without its feature `fast`. @param {Context} context */
const nativeSmall = (context) => native({ ...context, amount: "few" }, ["--no-default-features"]);

/** The Rust tests as wasm, in Node. @param {Context} context */
async function wasmNode(context) {
  await buildDriver();
  const binaries = testBinaries().filter(({ runsInWasm }) => runsInWasm);
  const { tests } = chooseRustTests(context.filters, binaries);
  const targets = binaries.flatMap(({ name }) => ["--test", name]);
  const words = ["test", "--package", "casteljau", "--target", "wasm32-unknown-unknown", ...targets];
  await run("cargo", [...words, "--quiet", "--no-run"], { env: { RUSTFLAGS: undefined } });
  // Cargo splits the setting at blanks and resolves a relative path from the root, so the root may contain blanks.
  const path = driver.startsWith(root) ? driver.slice(root.length + 1) : driver;
  const env = { RUSTFLAGS: undefined, CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUNNER: `${path} wasm-tests` };
  await run("cargo", [...words, "--", ...tests], { env, silence: SILENCE_MS.usual });
}

const docTests = () =>
  runAll([
    // The same features as for the native tests, so that their compiled crate is reused.
    () => cargo("test", "--quiet", "--doc", "--package", "casteljau", "--features", "serde,kurbo"),
    rustDocs,
  ]);

const reference = () =>
  // With the crate's own unit tests, and so with the features of its test dependencies: its compiled crates are reused.
  cargo("test", "--quiet", "--lib", "--package", "casteljau-reference", "--package", "casteljau", ...FEATURES);

/** Compiles the crate with the version that Cargo.toml names as `rust-version`. */
async function oldestRust() {
  const [, version] = /^rust-version = "(.*)"$/m.exec(await readFile(join(root, "Cargo.toml"), "utf8")) ?? [];
  if (!(await hasRust(version))) throw new Skipped(`Rust ${version} is absent and cannot be installed`);
  const words = ["check", "--quiet", "--package", "casteljau", "--features", "serde,kurbo,rayon"];
  const env = { RUSTUP_TOOLCHAIN: version };
  await run("cargo", [...words, "--target-dir", join(target, "msrv")], { env });
}

// JavaScript

const TSC = "node_modules/typescript/bin/tsc";
const CHECK_ONLY = ["--emitDeclarationOnly", "false", "--declaration", "false", "--noEmit"];

/** The types of the package, the site, the scripts, the tests, the benchmarks, and of a program that uses the declarations. */
async function checkTypes() {
  await types();
  await runAll([
    () => node(TSC, ...CHECK_ONLY),
    ...["www", "scripts", "custom", "tests", "benches", "tests/types"].map(
      (folder) => () => node(TSC, "--project", folder),
    ),
  ]);
}

/** Which package is tested: `npm test` takes the one for development. @param {Context} context */
const mode = ({ amount }) => (amount === "few" ? "development" : "release");

/** Of tests/js, what only `npm run test:all` runs: these take longer than all others together, or test what a release has. */
const LONG = [
  "benchmarks",
  "custom",
  "custom-builds",
  "decode",
  "easing-fit",
  "entries",
  "init",
  "inspected",
  "large-drawings",
  "manifest",
  "memory",
];

/**
 * Runs test files in Node.
 *
 * @param {Context} context
 * @param {string} runner
 * @param {readonly string[]} words
 * @param {Record<string, string | undefined>} [env]
 */
const nodeTests = (context, runner, words, env = {}) =>
  run(process.execPath, [runner, ...words, ...context.filters], {
    env: {
      CHROME_PATH: undefined,
      FIREFOX_PATH: undefined,
      WEBKIT_DRIVER: undefined,
      CASTELJAU_GENERATOR: join(target, "debug", "casteljau-generator"),
      ...variables(context),
      ...env,
    },
    silence: SILENCE_MS.usual,
  });

/** @param {Context} context */
async function js(context) {
  await packageFiles(mode(context));
  await buildGenerator();
  const without =
    context.amount === "few" && context.filters.length === 0 ? LONG.map((name) => `--without=${name}`) : [];
  await nodeTests(context, "tests/js/run.js", without);
}

/** Page tests of `npm test`, which need no site: the applet, the elements, one file for each. */
const MAIN_PAGES = ["applet", "bezier-applet", "surface", "surface-undo", "companions", "easing-element"];

/** @param {Context} context */
async function page(context) {
  await packageFiles(mode(context));
  const chrome = await browser("chromium");
  const few = context.amount === "few" && context.filters.length === 0;
  if (!few) await site();
  const words = few ? MAIN_PAGES : context.amount === "many" ? ["--deep"] : [];
  await nodeTests(context, "tests/page/run.js", words, { ...chrome, CASTELJAU_SITE: few ? "dist" : "site" });
}

/** @param {"firefox" | "webkit"} name @returns {(context: Context) => Promise<void>} */
const otherBrowser = (name) => async (context) => {
  const found = await browser(name);
  await packageFiles("release");
  await nodeTests(context, "tests/browsers/run.js", [], found);
};

/** @param {Context} context */
async function packaging(context) {
  await packageFiles("release");
  await nodeTests(context, "tests/packaging/run.js", [], await browser("chromium"));
}

/** The other versions of Node that are supported: npm has their programs. */
const NODE_VERSIONS = ["22.23.5", "24.22.3"];

/** The package's tests in other versions of Node. @param {Context} context */
async function nodeVersions(context) {
  await packageFiles("release");
  await buildGenerator();
  await runAll(
    NODE_VERSIONS.map((version) => async () => {
      const program = await nodeProgram(version);
      const without = LONG.map((name) => `--without=${name}`);
      await run(program, ["tests/js/run.js", ...without, ...context.filters], {
        env: {
          ...variables({ ...context, amount: "few" }),
          CASTELJAU_GENERATOR: join(target, "debug", "casteljau-generator"),
        },
        silence: SILENCE_MS.usual,
      });
    }),
  );
}

/** @param {string} version @returns {Promise<string>} the path of a program that npm has as a package for each platform */
async function nodeProgram(version) {
  const name = `node-${process.platform === "win32" ? "win" : process.platform}-${process.arch}`;
  const folder = join(target, "scripts", `node-${version}`);
  const program = join(folder, "node_modules", name, "bin", process.platform === "win32" ? "node.exe" : "node");
  await alone("node", async () => {
    if (existsSync(program)) return;
    await mkdir(folder, { recursive: true });
    await writeFile(join(folder, "package.json"), "{}");
    await run("npm", ["install", "--prefix", folder, "--no-audit", "--no-fund", `${name}@${version}`]);
  });
  return program;
}

// Deep tests

/** @param {Context} context @param {readonly string[]} modules of the test binaries */
function sweep(context, modules) {
  const { targets, tests } = chooseRustTests(modules, testBinaries());
  return deep(context, targets, tests);
}

/** @param {Context} context @param {readonly string[]} groups of generated calls */
const generated = (context, groups) => deep(context, ["generated"], groups);

/** @param {Context} context @param {readonly string[]} targets @param {readonly string[]} tests */
function deep(context, targets, tests) {
  const chosen = chooseRustTests(context.filters, testBinaries()).tests;
  const words = ["--profile", "deep", "--package", "casteljau", ...targets.flatMap((name) => ["--test", name])];
  return cargoTest(context, words, chosen.length > 0 ? chosen : tests);
}

/** @param {Context} context */
async function deepPackage(context) {
  await packageFiles("release");
  await buildGenerator();
  await nodeTests({ ...context, filters: [] }, "tests/js/run.js", ["generated", "large-drawings", "memory"]);
}

/** The Rust tests as wasm in Chromium, through chromedriver. @param {Context} context */
async function wasmChromium(context) {
  const { CHROMEDRIVER } = await browser("chromedriver");
  const { CHROME_PATH } = await browser("chromium");
  const settings = join(target, "scripts", "webdriver.json");
  const { FLAGS } = await import("../tests/page/chrome.js");
  const options = { binary: CHROME_PATH, args: ["--headless", ...FLAGS] };
  await writeFile(settings, JSON.stringify({ "goog:chromeOptions": options }));
  await cargo("build", "--quiet", "--package", "wasm-test-runner");
  const binaries = testBinaries().filter(({ runsInWasm }) => runsInWasm);
  const { tests } = chooseRustTests(context.filters, binaries);
  const targets = binaries.flatMap(({ name }) => ["--test", name]);
  const env = {
    RUSTFLAGS: undefined,
    CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUNNER: join(target, "debug", "wasm-test-runner"),
    WASM_BINDGEN_TEST_TIMEOUT: "120",
    WASM_BINDGEN_USE_BROWSER: "1",
    WASM_BINDGEN_TEST_WEBDRIVER_JSON: settings,
    CHROMEDRIVER,
  };
  const words = ["test", "--package", "casteljau", "--target", "wasm32-unknown-unknown", ...targets, "--", ...tests];
  await run("cargo", words, { env });
}

/** @type {readonly Step[]} */
export const STEPS = [
  {
    name: "wasm",
    title: "The core for the development package",
    lane: "rust",
    act: async () => {
      await glue("development");
      await buildGenerator();
    },
  },
  { name: "fmt", title: "Rust is formatted", lane: "rust", once: true, act: fmt },
  { name: "structure", title: "No files of the crate import each other", lane: "rust", once: true, act: structure },
  { name: "native", title: "Rust tests, native", lane: "rust", selects: true, act: native },
  { name: "wasm-node", title: "Rust tests as wasm, in Node", lane: "rust", once: true, selects: true, act: wasmNode },
  { name: "lint-js", title: "JavaScript is formatted; lints", lane: "js", once: true, act: lintJs },
  {
    name: "package",
    title: "The development package",
    lane: "js",
    needs: ["wasm"],
    act: async () => {
      await bundles("development");
      await types();
    },
  },
  {
    name: "types",
    title: "Types of the package, the site, scripts, tests and benchmarks, and of a program that uses the package",
    lane: "js",
    needs: ["package"],
    once: true,
    act: checkTypes,
  },
  { name: "js", title: "Tests of the npm package", lane: "js", needs: ["package", "build"], selects: true, act: js },
  { name: "page", title: "Page tests, in Chromium", lane: "js", needs: ["package", "build"], selects: true, act: page },

  { name: "build", title: "The npm package", lane: "rust", act: () => packageFiles("release") },
  { name: "clippy", title: "Lints", lane: "rust", act: clippy },
  {
    name: "native-small",
    title: "Rust tests without the feature fast, as in the wasm modules",
    lane: "rust",
    selects: true,
    act: nativeSmall,
  },
  { name: "doc", title: "Examples in the Rust documentation", lane: "rust", act: docTests },
  { name: "reference", title: "Rust samples of the API reference", lane: "rust", act: reference },
  {
    name: "xtask",
    title: "Tests of the driver",
    lane: "rust",
    act: () => cargo("test", "--quiet", "--package", "xtask"),
  },
  { name: "msrv", title: "The oldest version of Rust that the crate supports", lane: "rust", act: oldestRust },
  {
    name: "size",
    title: "Sizes of the package's parts",
    lane: "js",
    needs: ["build"],
    act: async () => {
      await packageFiles("release");
      await node("xtask/size.js");
    },
  },
  { name: "site", title: "The static site", lane: "js", needs: ["build"], act: site },
  {
    name: "node-versions",
    title: `Tests of the npm package in Node ${NODE_VERSIONS.join(" and ")}`,
    lane: "js",
    needs: ["build"],
    selects: true,
    act: nodeVersions,
  },
  {
    name: "page-firefox",
    title: "The main page tests, in Firefox",
    lane: "js",
    needs: ["build"],
    selects: true,
    act: otherBrowser("firefox"),
  },
  {
    name: "page-webkit",
    title: "The main page tests, in WebKitGTK",
    lane: "js",
    needs: ["build"],
    selects: true,
    act: otherBrowser("webkit"),
  },
  {
    name: "packaging",
    title: "The packed tarball in Node, bundlers and a browser",
    lane: "js",
    needs: ["build"],
    selects: true,
    act: packaging,
  },
];

/** The steps that `npm test` runs. */
export const USUAL = ["wasm", "fmt", "structure", "native", "wasm-node", "lint-js", "package", "types", "js", "page"];

/** The steps that `npm run test:all` runs, in this order. */
export const ALL = [
  ...[
    "build",
    "fmt",
    "structure",
    "native",
    "native-small",
    "wasm-node",
    "clippy",
    "doc",
    "reference",
    "xtask",
    "msrv",
  ],
  ...["lint-js", "size", "types", "site", "js", "node-versions", "page", "page-firefox", "page-webkit", "packaging"],
];

/** Those that may be skipped in CI as well. */
export const MAY_SKIP = ["msrv"];

/** @param {string} name @param {string} title @param {Step["act"]} act @returns {Step} */
const part = (name, title, act) => ({ name, title, lane: "rust", selects: true, act });

/** Each part of `npm run test:deep` runs alone, so that a change runs only those that it can affect. @type {readonly Step[]} */
export const DEEP = [
  part("curves", "Many more curves: flattening, points, timing functions", (context) =>
    sweep(context, ["curve", "easing", "flatten", "points"]),
  ),
  part("splines", "Many more splines: length, area, frames, joints, interpolation", (context) =>
    sweep(context, ["arc", "spline"]),
  ),
  part("intersections", "Many more intersections and offset curves", (context) =>
    sweep(context, ["intersect", "offset"]),
  ),
  part("paths", "Many more Boolean operations, strokes, large paths", (context) =>
    sweep(context, ["path", "path_boolean", "stroke"]),
  ),
  part("composition", "What a million strokes, offsets, unions and simplifications are made of", (context) =>
    sweep(context, ["composition"]),
  ),
  part("surfaces", "Many more patches, meshes and queries of surfaces", (context) =>
    sweep(context, ["patch_work", "queries", "surface", "watertight", "wires"]),
  ),
  part("generated-curves", "Generated calls of curves and splines, and of parsers", (context) =>
    generated(context, ["curves_", "splines", "parsers_", "chains_of_curves"]),
  ),
  part("generated-paths", "Generated calls of paths", (context) => generated(context, ["paths_", "chains_of_paths"])),
  part("generated-surfaces", "Generated calls of patches, surfaces and meshes", (context) =>
    generated(context, ["patches", "surfaces_", "chains_of_surfaces"]),
  ),
  { ...part("npm-package", "The npm package: more generated calls, every icon of a set", deepPackage), selects: false },
  part("wasm-chromium", "Rust tests as wasm, in Chromium", wasmChromium),
  part("page", "Page tests that take long, in Chromium", page),
];
