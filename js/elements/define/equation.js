// casteljau/elements/equation: defines `<bezier-equation>`.
import { BezierEquation as Equation } from "../companions/equation.js";
import { define } from "./define.js";

/** @import { BezierEquationConstructor } from "../companions/types.js" */
/** @typedef {import("../companions/types.js").BezierEquationElement} BezierEquationElement */

/** The class of `<bezier-equation>`. */
export const BezierEquation = /** @type {BezierEquationConstructor} */ (define("bezier-equation", Equation));
