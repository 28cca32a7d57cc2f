// A Vite plugin: the samples of the reference as modules, one for each folder of www/api/entries, each loaded when a figure of its page is used.
import { entryFolders, readEntries } from "./entries.js";
import { importsOf, sampleSource, usedNames } from "./sample.js";

const PREFIX = "virtual:reference-samples";

export const referenceSamples = {
  name: "reference-samples",
  /** @param {string} id */
  resolveId: (id) => (id.startsWith(PREFIX) ? `\0${id}` : null),
  /** @param {string} id */
  load(id) {
    if (id === `\0${PREFIX}`) return allFolders();
    return id.startsWith(`\0${PREFIX}/`) ? folderModule(id.slice(PREFIX.length + 2)) : null;
  },
};

/** A module that loads the others. */
function allFolders() {
  const loaders = entryFolders().map((folder) => `${JSON.stringify(folder)}: () => import("${PREFIX}/${folder}")`);
  return `export default { ${loaders.join(", ")} };`;
}

/** The samples of one folder that have a figure. @param {string} folder */
export function folderModule(folder) {
  const live = [...readEntries(folder)].filter(([, entry]) => entry.js && entry.draw);
  const samples = live.map(
    ([name, { js, draw }]) => `${JSON.stringify(name)}: ${sampleSource(js?.code ?? "", draw?.code)}`,
  );
  const code = samples.join(",\n");
  return `${importsOf(usedNames(code))}export default {\n${code}\n};`;
}
