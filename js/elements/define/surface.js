// casteljau/elements/surface: defines `<bezier-surface>`.
import { BezierSurface as Surface } from "../surface/element.js";
import { define } from "./define.js";

/** @import { BezierSurfaceConstructor } from "../types.js" */
/** @typedef {import("../types.js").BezierSurfaceElement} BezierSurfaceElement */

/** The class of `<bezier-surface>`. */
export const BezierSurface = /** @type {BezierSurfaceConstructor} */ (define("bezier-surface", Surface));
