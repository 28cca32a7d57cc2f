// What the packages of the libraries say about themselves, for the build of the page.
import { existsSync, readFileSync } from "node:fs";
import { LIBRARIES } from "./libraries.js";

const root = new URL("../../", import.meta.url);

/** Packages that the libraries import. */
const THEIRS = ["web-worker"];

/** The folder of a package. @param {string} name */
const folderOf = (name) => (name === "casteljau" ? root : new URL(`node_modules/${name}/`, root));

/** @param {string} name @returns {{ version: string, license: string, author: string | { name: string } }} */
export const packageOf = (name) => JSON.parse(readFileSync(new URL("package.json", folderOf(name)), "utf8"));

/** Where a package without a file of its licence gets the text from: one with the same licence. */
const SAME_LICENSE = "verb-nurbs";

/** The text of the licence of a package, with its name before it. @param {string} name */
function licenseOf(name) {
  const { license, author, version } = packageOf(name);
  const file = ["LICENSE", "LICENSE.txt"].map((each) => new URL(each, folderOf(name))).find((each) => existsSync(each));
  if (file) return `${name} ${version} (${license})\n\n${readFileSync(file, "utf8").trim()}\n`;
  const same = packageOf(SAME_LICENSE).license;
  if (license !== same) throw new Error(`${name}: expected a file of its licence ${license}`);
  const text = readFileSync(new URL("LICENSE", folderOf(SAME_LICENSE)), "utf8");
  const holder = typeof author === "string" ? author : author.name;
  return `${name} ${version} (${license})\n\nCopyright (c) ${holder}\n\n${text.slice(text.indexOf("Permission is hereby")).trim()}\n`;
}

/** A plugin for Vite: verb finds the global object without compiling text, which the policy of the site does not allow. @type {import("vite").Plugin} */
export const verbWithoutEval = {
  name: "verb-without-eval",
  transform: (code, id) =>
    id.includes("/verb-nurbs/")
      ? { code: code.replaceAll('new Function("return this")()', "globalThis"), map: null }
      : null,
};

/** A plugin for Vite: the licences accompany the libraries that the page contains. @type {import("vite").Plugin} */
export const libraryLicenses = {
  name: "library-licenses",
  generateBundle() {
    const others = [
      ...LIBRARIES.map(({ packageName }) => packageName).filter((name) => name !== "casteljau"),
      ...THEIRS,
    ];
    this.emitFile({ type: "asset", fileName: "conformance/licenses.txt", source: others.map(licenseOf).join("\n\n") });
  },
};
