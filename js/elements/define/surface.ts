// casteljau/elements/surface: defines `<bezier-surface>`.
import { BezierSurface as Surface } from "../surface/element.js";
import { define } from "./define.js";
import type { BezierSurfaceConstructor } from "../types.js";

export { setTranslations } from "../../editor/translations.js";
export type { BezierSurfaceElement } from "../types.js";

/** The class of `<bezier-surface>`. */
export const BezierSurface = define("bezier-surface", Surface) as BezierSurfaceConstructor;
