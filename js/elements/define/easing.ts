// casteljau/elements/easing: defines `<bezier-easing>`.
import { BezierEasing as Easing } from "../companions/easing.js";
import { define } from "./define.js";
import type { BezierEasingConstructor } from "../companions/types.js";

export { setTranslations } from "../../editor/translations.js";
export type { BezierEasingElement } from "../companions/types.js";

/** The class of `<bezier-easing>`. */
export const BezierEasing = define("bezier-easing", Easing) as BezierEasingConstructor;
