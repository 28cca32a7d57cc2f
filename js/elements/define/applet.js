// casteljau/elements/applet: defines `<bezier-applet>`.
import { BezierApplet as Applet } from "../applet/element.js";
import { define } from "./define.js";

/** @import { BezierAppletConstructor } from "../types.js" */
/** @typedef {import("../types.js").BezierAppletElement} BezierAppletElement */

/** The class of `<bezier-applet>`. */
export const BezierApplet = /** @type {BezierAppletConstructor} */ (define("bezier-applet", Applet));
