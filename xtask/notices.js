// The copyright notices of the software that dist/ contains: npm packages in the bundles, crates in the wasm modules.
import { execFile } from "node:child_process";
import { readFile, readdir } from "node:fs/promises";
import { dirname, join } from "node:path";
import { promisify } from "node:util";

const BINDINGS = "src/wasm/Cargo.toml";
const TARGET = "wasm32-unknown-unknown";
const LICENSE_FILE = /^(licen[cs]e|copying|notice)([-.].*)?$/i;

const INTRODUCTION = `Third-party software in this package

The JavaScript files contain parts of the npm packages listed below; the WebAssembly modules, which are also inside of
the JavaScript files as text, contain parts of the crates. They also contain parts of the Rust standard library
(https://www.rust-lang.org), Copyright (c) The Rust Project Contributors, under the Apache License 2.0, whose text is in
the file LICENSE-APACHE of this package, or the MIT license.
`;

/**
 * A dependency, its license as an SPDX expression, and the texts of its license files.
 *
 * @typedef {{ name: string, version: string, license: string, texts: string[] }} Notice
 */

/**
 * The notices of everything that is built into the package, as a text file.
 *
 * @param {readonly string[]} inputs the files that went into the bundles
 */
export async function noticesText(inputs) {
  const notices = [...(await npmNotices(inputs)), ...(await crateNotices())];
  const sections = notices.map(
    ({ name, version, license, texts }) =>
      `${"-".repeat(100)}\n${name} ${version}\nLicense: ${license}\n\n${texts.join("\n\n")}\n`,
  );
  return [INTRODUCTION, ...sections].join("\n");
}

/**
 * @param {readonly string[]} inputs
 * @returns {Promise<Notice[]>}
 */
export async function npmNotices(inputs) {
  const folders = inputs.map((path) => path.match(/^.*node_modules\/(@[^/]+\/)?[^/]+/)?.[0]);
  const packages = [...new Set(folders.filter((folder) => folder !== undefined))].sort();
  return Promise.all(
    packages.map(async (folder) => {
      const { name, version, license } = JSON.parse(await readFile(join(folder, "package.json"), "utf8"));
      return { name, version, license, texts: await licenseTexts(folder, name, license) };
    }),
  );
}

/**
 * The crates that the bindings need at run time; procedural macros and build scripts only run in the compiler.
 *
 * @returns {Promise<Notice[]>}
 */
export async function crateNotices() {
  const options = ["--format-version", "1", "--locked", "--filter-platform", TARGET, "--manifest-path", BINDINGS];
  const { stdout } = await promisify(execFile)("cargo", ["metadata", ...options], { maxBuffer: 2 ** 28 });
  const { packages, resolve } = JSON.parse(stdout);
  const known = new Map(packages.map((each) => [each.id, each]));
  const nodes = new Map(resolve.nodes.map((node) => [node.id, node]));
  const isMacro = (id) => known.get(id).targets.some(({ kind }) => kind.includes("proc-macro"));
  const reached = new Set([resolve.root]);
  for (const id of reached)
    for (const { pkg, dep_kinds: kinds } of nodes.get(id).deps)
      if (kinds.some(({ kind }) => kind === null) && !isMacro(pkg)) reached.add(pkg);
  const foreign = [...reached].map((id) => known.get(id)).filter(({ source }) => source !== null);
  foreign.sort((a, b) => (a.name < b.name ? -1 : 1));
  return Promise.all(
    foreign.map(async ({ name, version, license, manifest_path: path }) => {
      return { name, version, license, texts: await licenseTexts(dirname(path), name, license) };
    }),
  );
}

/**
 * The texts of the license files; of a choice of licenses only those of MIT, if it is among them.
 *
 * @param {string} folder
 * @param {string} name
 * @param {string} license
 */
async function licenseTexts(folder, name, license) {
  const files = (await readdir(folder)).filter((file) => LICENSE_FILE.test(file)).sort();
  const chosen = license.includes(" OR ") ? files.filter((file) => /mit/i.test(file)) : [];
  const texts = await Promise.all(
    (chosen.length > 0 ? chosen : files).map((file) => readFile(join(folder, file), "utf8")),
  );
  if (texts.length === 0) throw new Error(`${name}: expected a license file in its package, got none`);
  return texts.map((text) => text.replace(/\r\n/g, "\n").trim());
}
