// `npm start`: builds what the site needs and serves it; changes in js/ and www/ show at once. Arguments are Vite's
// (`npm start -- --port 8080`).
import { logged, run } from "./run.js";
import { bundles, glue } from "./build.js";
import { checkNode, packages, rust } from "./setup.js";

/** @param {number} since */
const seconds = (since) => `${((performance.now() - since) / 1000).toFixed(1).padStart(5)} s`;

/**
 * A part of the work: a line when it starts and one when it has ended. The output of programs is shown if it fails.
 *
 * @param {string} title
 * @param {() => Promise<unknown>} act
 */
async function part(title, act) {
  console.log(`         ${title} …`);
  const begin = performance.now();
  /** @type {string[]} */
  const log = [];
  await logged(log, act).catch((error) => {
    console.error(log.join(""));
    throw error;
  });
  console.log(`${seconds(begin)}  ${title}`);
}

try {
  checkNode();
  const wasm = async () => {
    await part("Rust toolchain", rust);
    await part("the core, compiled to WebAssembly", () => glue("development"));
  };
  await Promise.all([wasm(), part("npm packages", () => packages("start"))]);
  await part("scripts of the package", () => bundles("development"));
  console.log("         pages …");
  await run(process.execPath, [
    "node_modules/vite/bin/vite.js",
    "--config",
    "www/vite.config.js",
    ...process.argv.slice(2),
  ]);
} catch (error) {
  console.error(`\nerror: ${/** @type {Error} */ (error).message}`);
  process.exitCode = 1;
}
