// casteljau/core: curves, splines and paths that evaluate, split, draw and measure: the classes that those of `casteljau` extend.
// xtask/bundle.js gives it a wasm module with only the functions that these classes call.
export * from "./types.js";
export { init } from "./wasm/init.js";
export { CoreCurve as Curve } from "./geometry/curve/core-curve.js";
export { CoreSpline as Spline } from "./geometry/spline/core-spline.js";
export { CorePath as Path } from "./geometry/path/core-path.js";
