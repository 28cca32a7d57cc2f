// casteljau/nurbs: curves with weights, on the curves and splines of casteljau/core. xtask/bundle.js gives it one wasm module
// with the functions of both.
export * from "./types.js";
export type { RationalCurveJSON } from "./geometry/rational/rational-curve.js";
export type { NurbsCurveJSON, NurbsOptions } from "./geometry/rational/nurbs-curve.js";
export { init } from "./wasm/init.js";
export { RationalCurve } from "./geometry/rational/rational-curve.js";
export { NurbsCurve } from "./geometry/rational/nurbs-curve.js";
export { CoreCurve as Curve } from "./geometry/curve/core-curve.js";
export { CoreSpline as Spline } from "./geometry/spline/core-spline.js";
