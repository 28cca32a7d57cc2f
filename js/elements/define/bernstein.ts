// casteljau/elements/bernstein: defines `<bezier-bernstein>`.
import { BezierBernstein as Bernstein } from "../companions/bernstein.js";
import { define } from "./define.js";
import type { BezierBernsteinConstructor } from "../companions/types.js";

export { setTranslations } from "../../editor/translations.js";
export type { BezierBernsteinElement } from "../companions/types.js";

/** The class of `<bezier-bernstein>`. */
export const BezierBernstein = define("bezier-bernstein", Bernstein) as BezierBernsteinConstructor;
