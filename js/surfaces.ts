// casteljau/surfaces: patches and surfaces on the curves of casteljau/core without their measures. xtask/bundle.js gives it one
// wasm module with the functions of both.
export * from "./types.js";
export { init } from "./wasm/init.js";
export { CoreCurve as Curve } from "./geometry/curve/core-curve.js";
export { CorePatch as Patch } from "./geometry/patch/core-patch.js";
export { CoreSurface as Surface } from "./geometry/surface/core-surface.js";
export { Mesh } from "./geometry/mesh.js";
