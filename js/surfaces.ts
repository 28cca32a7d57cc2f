// casteljau/surfaces: patches and surfaces on the curves of casteljau/core. xtask/bundle.js gives it one wasm module with the
// functions of both.
export * from "./types.js";
export { init } from "./wasm/init.js";
export { Curve } from "./geometry/core/curve.js";
export { Patch } from "./geometry/core/patch.js";
export { Surface } from "./geometry/core/surface.js";
export { Mesh } from "./geometry/mesh.js";
