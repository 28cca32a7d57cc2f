// Runs the page tests in one Chromium that all test files share:
//
//     node tests/page/run.js [--deep] [FILE_OR_NAME …]
//
// A file is chosen by its path or base name, with or without `.test.js`; other words choose tests by their names. `--deep`
// runs the slow files, *.deep.test.js, instead of the others.
import { chooseTests } from "../node-tests.js";
import { runInSharedBrowser } from "./chrome.js";

process.exitCode = await runInSharedBrowser(chooseTests(new URL("./", import.meta.url), process.argv.slice(2)));
