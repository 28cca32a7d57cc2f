// casteljau/elements/easing: defines `<bezier-easing>`.
import { BezierEasing as Easing } from "../companions/easing.js";
import { define } from "./define.js";

/** @import { BezierEasingConstructor } from "../companions/types.js" */
/** @typedef {import("../companions/types.js").BezierEasingElement} BezierEasingElement */

/** The class of `<bezier-easing>`. */
export const BezierEasing = /** @type {BezierEasingConstructor} */ (define("bezier-easing", Easing));
