// casteljau/elements/applet: defines `<bezier-applet>`.
import { BezierApplet as Applet } from "../applet/element.js";
import { define } from "./define.js";
import type { BezierAppletConstructor } from "../types.js";

export { setTranslations } from "../../editor/translations.js";
export type { BezierAppletElement } from "../types.js";

/** The class of `<bezier-applet>`. */
export const BezierApplet = define("bezier-applet", Applet) as BezierAppletConstructor;
