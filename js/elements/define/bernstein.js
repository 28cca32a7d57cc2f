// casteljau/elements/bernstein: defines `<bezier-bernstein>`.
import { BezierBernstein as Bernstein } from "../companions/bernstein.js";
import { define } from "./define.js";

/** @import { BezierBernsteinConstructor } from "../companions/types.js" */
/** @typedef {import("../companions/types.js").BezierBernsteinElement} BezierBernsteinElement */

/** The class of `<bezier-bernstein>`. */
export const BezierBernstein = /** @type {BezierBernsteinConstructor} */ (define("bezier-bernstein", Bernstein));
