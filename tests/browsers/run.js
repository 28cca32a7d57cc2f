// Runs the tests in other browsers, in one process, so that each browser starts once:
//
//     FIREFOX_PATH=… node tests/browsers/run.js [FILE_OR_NAME …]
//
// Without FIREFOX_PATH and WEBKIT_DRIVER the tests run in every browser that is on PATH. A file is chosen by its path or
// base name, with or without `.test.js`; other words choose tests by their names.
import { fileURLToPath } from "node:url";
import { chooseTests, runTests } from "../node-tests.js";
import { CHOSEN_FILES } from "./all.js";

const { files, patterns } = chooseTests(new URL("./", import.meta.url), process.argv.slice(2));
const all = fileURLToPath(new URL("./all.js", import.meta.url));
process.exitCode = await runTests({ files: [all], patterns }, { env: { [CHOSEN_FILES]: JSON.stringify(files) } });
