// Loaded by `node --require` before vue-tsc and svelte-check: they need the compiler API, which TypeScript 7 has not.
const Module = /** @type {any} */ (require("node:module"));
const resolve = Module._resolveFilename;
Module._resolveFilename = (name, ...rest) => resolve(name.replace(/^typescript(?=$|\/)/, "typescript-api"), ...rest);
