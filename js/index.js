// The public interface. Importing it compiles nothing; the first call does.
export * from "./types.js";
export { init } from "./wasm/init.js";
export { Curve } from "./geometry/curve/curve.js";
export { Spline } from "./geometry/spline/spline.js";
export { Path } from "./geometry/path/path.js";
export { Patch } from "./geometry/patch/patch.js";
export { Surface } from "./geometry/surface/surface.js";
export { Mesh } from "./geometry/mesh.js";
export { easing } from "./geometry/easing.js";

/** @typedef {import("./geometry/easing.js").Easing} Easing */
/** @typedef {import("./geometry/easing.js").SpringEasing} SpringEasing */
/** @typedef {import("./geometry/easing-fit.js").FitEasingOptions} FitEasingOptions */
/** @typedef {import("./geometry/easing-fit.js").SpringOptions} SpringOptions */
