import { alphabet, frequent, length, text } from "../glue/surfaces-bytes.js";
import { initSync } from "../glue/surfaces.js";
import { registerModule } from "./wasm-module.js";

/**
 * The module with patches, surfaces and meshes; in the slim bundle the same as `curvesModule` (see xtask/bundle.js).
 *
 * @internal
 */
export const surfacesModule = /* @__PURE__ */ registerModule(initSync, { alphabet, frequent, length, text });
