// The entry point casteljau/easing: timing functions without wasm.
/** @import { Easing as EasingFunction } from "./geometry/easing.js" */
/** @typedef {EasingFunction} Easing */

export { easing } from "./geometry/easing.js";
