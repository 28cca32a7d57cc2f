// casteljau/nurbs: curves and surfaces with weights. xtask/bundle.js gives it two wasm modules: one for curves, with the functions
// of the curves and splines of casteljau/core, and one for surfaces, with those of casteljau/surfaces.
export * from "./types.js";
export type { RationalCurveJSON } from "./geometry/rational/rational-curve.js";
export type { NurbsCurveJSON, NurbsOptions } from "./geometry/rational/nurbs-curve.js";
export type { RationalPatchJSON } from "./geometry/rational/rational-patch.js";
export type { RationalSurfaceJSON, RationalSurfaceOptions } from "./geometry/rational/rational-surface.js";
export type { NurbsSurfaceJSON, NurbsSurfaceOptions } from "./geometry/rational/nurbs-surface.js";
export type { SectionLike, TurningOptions } from "./geometry/rational/sections.js";
export { init } from "./wasm/init.js";
export { RationalCurve } from "./geometry/rational/rational-curve.js";
export { NurbsCurve } from "./geometry/rational/nurbs-curve.js";
export { RationalPatch } from "./geometry/rational/rational-patch.js";
export { RationalSurface } from "./geometry/rational/rational-surface.js";
export { NurbsSurface } from "./geometry/rational/nurbs-surface.js";
export { CoreCurve as Curve } from "./geometry/curve/core-curve.js";
export { CoreSpline as Spline } from "./geometry/spline/core-spline.js";
export { Mesh } from "./geometry/mesh.js";
