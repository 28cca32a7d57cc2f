// casteljau/elements/equation: defines `<bezier-equation>`.
import { BezierEquation as Equation } from "../companions/equation.js";
import { define } from "./define.js";
import type { BezierEquationConstructor } from "../companions/types.js";

export { setTranslations } from "../../editor/translations.js";
export type { BezierEquationElement } from "../companions/types.js";

/** The class of `<bezier-equation>`. */
export const BezierEquation = define("bezier-equation", Equation) as BezierEquationConstructor;
