// `<!-- include sections/NAME.md -->` on a line of its own is replaced by that file: a long page can be written as one file for each section.
import { readFileSync } from "node:fs";
import { dirname, resolve } from "node:path";

const INCLUDE = /^<!-- include (\S+) -->$/gm;

/**
 * A preprocessor of Eleventy.
 *
 * @param {{ page: { inputPath: string } }} data
 * @param {string} content
 * @returns {string}
 */
export const includeFiles = ({ page }, content) =>
  content.replace(INCLUDE, (_, name) => readFileSync(resolve(dirname(page.inputPath), name), "utf8"));
