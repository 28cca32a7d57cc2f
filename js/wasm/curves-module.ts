import { alphabet, frequent, length, text } from "../glue/curves-bytes.js";
import { initSync } from "../glue/curves.js";
import { registerModule } from "./wasm-module.js";

/**
 * The module with curves, splines and paths; in the slim bundle the complete module (see xtask/bundle.js).
 *
 * @internal
 */
export const curvesModule = /* @__PURE__ */ registerModule(initSync, { alphabet, frequent, length, text });
