// The entry point casteljau/easing: timing functions without wasm.
/** @import { Easing as EasingFunction } from "./geometry/easing.js" */
/** @typedef {EasingFunction} Easing */
/** @typedef {import("./geometry/easing.js").SpringEasing} SpringEasing */
/** @typedef {import("./geometry/easing-fit.js").FitEasingOptions} FitEasingOptions */
/** @typedef {import("./geometry/easing-fit.js").SpringOptions} SpringOptions */

export { easing } from "./geometry/easing.js";
