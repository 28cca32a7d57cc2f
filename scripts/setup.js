// Setup of a fresh clone: Node's version, the Rust toolchain and its wasm target, node_modules.
import { existsSync, readFileSync } from "node:fs";
import { readFile, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { alone, outputOf, root, run, say } from "./run.js";
import { hashOf } from "./stamp.js";

const WASM_TARGET = "wasm32-unknown-unknown";

/** Fails with a version of Node that is older than package.json allows. */
export function checkNode() {
  const { engines } = JSON.parse(readFileSync(join(root, "package.json"), "utf8"));
  const [major, minor] = engines.node.match(/\d+/g).map(Number);
  const [found, foundMinor] = process.versions.node.split(".").map(Number);
  if (found < major || (found === major && foundMinor < minor))
    throw new Error(
      `Node ${process.versions.node} is too old: ${major}.${minor} or newer is needed (https://nodejs.org)`,
    );
}

/** Installs the toolchain that rust-toolchain.toml names, with rustfmt, clippy and the wasm target; rustup may not do so by itself. */
export async function rust() {
  if ((await sysroot()) === undefined) await toolchain();
  const installed = await sysroot();
  if (installed === undefined) throw new Error("rustc does not run: install Rust from https://rustup.rs");
  if (!existsSync(join(installed, "lib/rustlib", WASM_TARGET))) await run("rustup", ["target", "add", WASM_TARGET]);
  for (const [component, command] of [
    ["rustfmt", "fmt"],
    ["clippy", "clippy"],
  ])
    if ((await outputOf("cargo", [command, "--version"])) === undefined)
      await run("rustup", ["component", "add", component]);
}

const sysroot = () => outputOf("rustc", ["--print", "sysroot"]);

/** Installs the pinned toolchain; where that is not possible, an installed stable one serves. */
async function toolchain() {
  const [, channel] = (await readFile(join(root, "rust-toolchain.toml"), "utf8")).match(/channel = "(.*)"/) ?? [];
  await installRust(channel).catch((error) => {
    say(`${error.message}; Rust stable is used instead of ${channel}`);
    process.env.RUSTUP_TOOLCHAIN = "stable";
  });
}

/** @param {string} version */
const installRust = (version) =>
  run("rustup", ["toolchain", "install", version, "--profile", "minimal", "--no-self-update"]);

/** Whether a version of Rust is there; installs it if it can. @param {string} version */
export async function hasRust(version) {
  if (await outputOf("rustc", ["--version"], { RUSTUP_TOOLCHAIN: version })) return true;
  return installRust(version).then(
    () => true,
    () => false,
  );
}

/** Where the packages are noted that were installed for `npm start`. */
const STAMP = join(root, "node_modules/.installed-for-start");

/**
 * Installs the npm packages, unless they are there.
 *
 * @param {"start" | "all"} which "start": without those of tools/package.json, which only tests, benchmarks and releases need
 */
export const packages = (which) =>
  alone("packages", async () => {
    if (await isInstalled(which)) return;
    const words = [
      "ci",
      "--no-audit",
      "--no-fund",
      "--loglevel=error",
      ...(which === "start" ? ["--workspaces=false"] : []),
    ];
    await run("npm", words);
    if (which === "start") await writeFile(STAMP, hashOf(["package-lock.json"]));
  });

/** @param {"start" | "all"} which */
async function isInstalled(which) {
  const read = async (/** @type {string} */ path) => JSON.parse(await readFile(join(root, path), "utf8")).packages;
  const found = await read("node_modules/.package-lock.json").catch(() => ({}));
  const wanted = await read("package-lock.json");
  const missing = Object.entries(wanted).find(
    ([path, { version, optional, link }]) =>
      path.startsWith("node_modules/") && !optional && !link && found[path]?.version !== version,
  );
  if (!missing) return true;
  if (which === "all") return false;
  return (await readFile(STAMP, "utf8").catch(() => "")) === hashOf(["package-lock.json"]);
}
