// Removes the parameter `surplus` from the declarations in dist/types. Methods have it to refuse arguments at run time
// that JavaScript would ignore; the compiler refuses them by itself. Called by scripts/build.js after tsc.
import { readdir, readFile, writeFile } from "node:fs/promises";
import { join } from "node:path";

const folder = "dist/types";
for (const name of await readdir(folder, { recursive: true })) {
  if (!name.endsWith(".d.ts")) continue;
  const path = join(folder, name);
  const text = await readFile(path, "utf8");
  const edited = text
    .replace(/,? ?\.\.\.surplus: never\[\]/g, "")
    .replace(/^\s*\* @param \{never\[\]\} surplus\n/gm, "");
  if (edited !== text) await writeFile(path, edited);
}
