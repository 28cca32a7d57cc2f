// The entry point casteljau/easing: timing functions without wasm.
export type { Easing, SpringEasing } from "./geometry/easing.js";
export type { FitEasingOptions, SpringOptions } from "./geometry/easing-fit.js";

export { easing } from "./geometry/easing.js";
