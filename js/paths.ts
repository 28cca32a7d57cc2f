// casteljau/paths: curves, splines and paths without operations on regions, for lengths, nearest points, hit testing and
// conversions. It shares all files with casteljau.
export * from "./types.js";
export { init } from "./wasm/init.js";
export { Curve } from "./geometry/curve/curve.js";
export { Spline } from "./geometry/spline/spline.js";
export { Path } from "./geometry/core/path.js";
