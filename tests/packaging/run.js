// Runs the tests of the packed tarball, which is packed and installed once, in one Chromium:
//
//     node tests/packaging/run.js [FILE_OR_NAME …]
//
// A file is chosen by its path or base name, with or without `.test.js`; other words choose tests by their names.
import { chooseTests } from "../node-tests.js";
import { runInSharedBrowser } from "../page/chrome.js";
import { installed, INSTALLED_FOLDER } from "./fixture.js";

const chosen = chooseTests(new URL("./", import.meta.url), process.argv.slice(2));
const fixture = await installed();
try {
  process.exitCode = await runInSharedBrowser(chosen, { [INSTALLED_FOLDER]: fixture.folder });
} finally {
  await fixture.remove();
}
