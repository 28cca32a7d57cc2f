// Incremental builds: the contents of the inputs are hashed and compared with those of the last run.
import { createHash } from "node:crypto";
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { mkdir, readFile, writeFile } from "node:fs/promises";
import { join, resolve } from "node:path";
import { root, say, target } from "./run.js";

/** All files below a folder of the repository, sorted, without node_modules and hidden files. @param {string} folder @returns {string[]} */
export function filesBelow(folder) {
  const items = existsSync(join(root, folder)) ? readdirSync(join(root, folder), { withFileTypes: true }) : [];
  const files = items
    .filter(({ name }) => !name.startsWith(".") && name !== "node_modules")
    .flatMap((item) => (item.isDirectory() ? filesBelow(`${folder}/${item.name}`) : `${folder}/${item.name}`));
  return files.sort();
}

/** A hash of texts and of the contents of files. @param {readonly string[]} files @param {readonly string[]} texts */
export function hashOf(files, texts = []) {
  const hash = createHash("sha256").update(JSON.stringify([texts, files]));
  for (const file of files) hash.update(readFileSync(resolve(root, file)));
  return hash.digest("hex");
}

/**
 * Runs `act` unless the last run had the same inputs and every output still exists.
 *
 * @param {{ name: string, inputs: readonly string[], texts?: readonly string[], outputs: readonly string[] }} work
 * @param {() => Promise<unknown>} act
 */
export async function unlessCurrent({ name, inputs, texts, outputs }, act) {
  const stamp = `${target}/scripts/${name}`;
  const key = hashOf(inputs, texts);
  const old = await readFile(stamp, "utf8").catch(() => "");
  if (old === key && outputs.every((output) => existsSync(join(root, output)))) return say(`${name}: up to date`);
  await act();
  await mkdir(`${target}/scripts`, { recursive: true });
  await writeFile(stamp, key);
}
