// The public interface. Importing it compiles nothing; the first call does.
export * from "./types.js";
export { init } from "./wasm/init.js";
export { Curve } from "./geometry/curve/curve.js";
export { Spline } from "./geometry/spline/spline.js";
export { Path } from "./geometry/path/path.js";
export { InkStroke } from "./geometry/ink-stroke.js";
export { Patch } from "./geometry/patch/patch.js";
export { Surface } from "./geometry/surface/surface.js";
export { Mesh } from "./geometry/mesh.js";
export { easing } from "./geometry/easing.js";

export type { Easing, SpringEasing } from "./geometry/easing.js";
export type { FitEasingOptions, SpringOptions } from "./geometry/easing-fit.js";
export type { InkOptions, InkSample } from "./geometry/ink-stroke.js";
