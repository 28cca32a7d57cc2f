// The chosen test files as one: see run.js.
import { pathToFileURL } from "node:url";

/** The variable with the paths of the files, as JSON. */
export const CHOSEN_FILES = "CASTELJAU_TEST_FILES";

for (const path of JSON.parse(process.env[CHOSEN_FILES] ?? "[]")) await import(pathToFileURL(path).href);
