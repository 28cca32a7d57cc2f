import { gate } from "./wasm-module.js";
import { alphabet, frequent, length, text } from "../glue/curves-bytes.js";
import { initSync } from "../glue/curves.js";

/**
 * The module of curves, splines and paths; in the slim bundle the whole module (see xtask/bundle.js).
 *
 * @internal
 */
export const curves = /* @__PURE__ */ gate(initSync, { alphabet, frequent, length, text });
