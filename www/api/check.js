// Tells what the samples of an entry print where that differs from what the entry says:
//     node www/api/check.js curve/nearest spline …
// A name without a slash means all entries of a folder. `npm run build` must have been run.
import { entryFolders, readEntries } from "./build/entries.js";
import { differences } from "./build/run.js";

const wanted = process.argv.slice(2);
for (const folder of entryFolders()) {
  for (const [name, entry] of readEntries(folder)) {
    if (wanted.length > 0 && !wanted.includes(folder) && !wanted.includes(`${folder}/${name}`)) continue;
    try {
      for (const { where, says, is } of await differences(entry)) {
        console.log(`${entry.file}: ${where}\n  says ${says}\n  is   ${is}`);
        process.exitCode = 1;
      }
    } catch (error) {
      console.log(`${entry.file}: ${error instanceof Error ? error.stack : error}`);
      process.exitCode = 1;
    }
  }
}
