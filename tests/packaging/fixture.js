// A program that has installed the packed tarball, as a user would, in a folder of its own.
import { execFile } from "node:child_process";
import { cp, mkdir, mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";

const root = fileURLToPath(new URL("../../", import.meta.url));
const execute = promisify(execFile);

/** The variable with a folder in which run.js has installed the package: all test files copy it. */
export const INSTALLED_FOLDER = "CASTELJAU_INSTALLED";

/** A use of the package, and what it prints. */
export const PROGRAM = `import { Curve } from "casteljau";
console.log(JSON.stringify(new Curve([[0, 0], [1, 2], [2, 0]]).eval(0.5)));
`;
export const PRINTED = '{"x":1,"y":1}';

/** What a page with an element does: it prints how many triangles the element draws of a surface of the page's own. */
export const ELEMENTS_PROGRAM = `import { Surface } from "casteljau";
import "casteljau/elements";
const element = document.createElement("bezier-surface");
element.surface = Surface.teapot({ lid: false });
document.body.append(element);
const facts = () => element.shadowRoot.querySelector(".facts").textContent;
element.addEventListener("update", () => /triangles/.test(facts()) && console.log(facts().match(/[\\d,]+/)[0]));
`;
export const ELEMENTS_PRINTED = "6,912"; // 24 patches of 2 · 12² triangles

/** Runs a program; its output, trimmed. Fails with what it wrote if it ends badly. */
export async function run(program, args, options = {}) {
  const shell = process.platform === "win32" && program === "npm";
  try {
    return (await execute(program, args, { ...options, shell })).stdout.trim();
  } catch (/** @type {any} */ error) {
    throw new Error([error.message, error.stdout, error.stderr].join("\n"), { cause: error });
  }
}

/**
 * A folder in which the packed tarball is installed: a copy of the one that run.js has made, or else a new one.
 *
 * @returns {Promise<{ folder: string, tarball: string, installed: string, resolvePlugin: { name: string, resolveId(id: string): string | null }, write(name: string, text: string): Promise<string>, remove(): Promise<void> }>}
 */
export async function installed() {
  const folder = await mkdtemp(join(tmpdir(), "casteljau-packaging-"));
  const original = process.env[INSTALLED_FOLDER];
  if (original) await cp(original, folder, { recursive: true });
  else await install(folder);
  const { version } = JSON.parse(await readFile(join(root, "package.json"), "utf8"));
  const tarball = join(folder, `casteljau-${version}.tgz`);
  const write = async (name, text) => {
    const path = join(folder, name);
    await mkdir(join(path, ".."), { recursive: true });
    await writeFile(path, text);
    return path;
  };
  const remove = () => rm(folder, { recursive: true, force: true });
  const installed = join(folder, "node_modules/casteljau");
  const { exports } = JSON.parse(await readFile(join(installed, "package.json"), "utf8"));
  /** Resolves as @rollup/plugin-node-resolve does, by the conditions "module" and "default". @param {string} id */
  const resolveId = (id) => {
    if (!id.startsWith("casteljau")) return null;
    const entry = exports[id.replace("casteljau", ".")] ?? exports["./elements/*"];
    return join(installed, (entry.module ?? entry.default ?? entry).replace("*", id.split("/").at(-1)));
  };
  return { folder, tarball, installed, write, remove, resolvePlugin: { name: "resolve", resolveId } };
}

/**
 * Packs the repository and installs the tarball (offline: it has no dependencies).
 *
 * @param {string} folder
 */
async function install(folder) {
  const report = await run("npm", ["pack", "--json", "--ignore-scripts", "--pack-destination", folder], { cwd: root });
  const [{ filename } = {}] = JSON.parse(report);
  if (!filename) throw new Error(`npm pack: expected the name of a file, got ${report}`);
  await writeFile(join(folder, "package.json"), '{ "name": "fixture", "private": true, "type": "module" }\n');
  await run("npm", ["install", "--offline", "--ignore-scripts", "--no-audit", "--no-fund", join(folder, filename)], {
    cwd: folder,
  });
}
