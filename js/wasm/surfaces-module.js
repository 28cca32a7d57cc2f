import { gate } from "./wasm-module.js";
import { alphabet, frequent, length, text } from "../glue/surfaces-bytes.js";
import { initSync } from "../glue/surfaces.js";

/**
 * The module of patches, surfaces and meshes; in the slim bundle the same as that of curves (see xtask/bundle.js).
 *
 * @internal
 */
export const surfaces = /* @__PURE__ */ gate(initSync, { alphabet, frequent, length, text });
