// casteljau/core: curves and splines without queries, for drawing and teaching. xtask/bundle.js gives it a wasm module with
// only the functions that these classes call.
export * from "./types.js";
export { init } from "./wasm/init.js";
export { Curve } from "./geometry/core/curve.js";
export { Spline } from "./geometry/core/spline.js";
