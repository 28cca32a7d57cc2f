import { alphabet, frequent, length, text } from "../glue/regions-bytes.js";
import { initSync } from "../glue/regions.js";
import { registerModule } from "./wasm-module.js";

/**
 * The module with operations on regions, which only `Path` uses; in the slim bundle the same as `curvesModule` (see
 * xtask/bundle.js).
 *
 * @internal
 */
export const regionsModule = /* @__PURE__ */ registerModule(initSync, { alphabet, frequent, length, text });
