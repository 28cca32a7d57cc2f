// The custom elements of the package. Importing this module defines them; where there is no document it does nothing.
import { BezierApplet as Applet } from "./applet/element.js";
import { BezierBernstein as Bernstein } from "./companions/bernstein.js";
import { BezierCoordinates as Coordinates } from "./companions/coordinates.js";
import { BezierEasing as Easing } from "./companions/easing.js";
import { BezierEquation as Equation } from "./companions/equation.js";
import { BezierSurface as Surface } from "./surface/element.js";

/**
 * @import { BezierBernsteinConstructor, BezierCoordinatesConstructor, BezierEasingConstructor, BezierEquationConstructor } from "./companions/types.js"
 * @import { BezierAppletConstructor, BezierSurfaceConstructor } from "./types.js"
 */

/** The class of `<bezier-applet>`. */
export const BezierApplet = /** @type {BezierAppletConstructor} */ (/** @type {unknown} */ (Applet));

/** The class of `<bezier-surface>`. */
export const BezierSurface = /** @type {BezierSurfaceConstructor} */ (/** @type {unknown} */ (Surface));
/** The class of `<bezier-bernstein>`. */
export const BezierBernstein = /** @type {BezierBernsteinConstructor} */ (/** @type {unknown} */ (Bernstein));
/** The class of `<bezier-equation>`. */
export const BezierEquation = /** @type {BezierEquationConstructor} */ (/** @type {unknown} */ (Equation));
/** The class of `<bezier-coordinates>`. */
export const BezierCoordinates = /** @type {BezierCoordinatesConstructor} */ (/** @type {unknown} */ (Coordinates));
/** The class of `<bezier-easing>`. */
export const BezierEasing = /** @type {BezierEasingConstructor} */ (/** @type {unknown} */ (Easing));

/** What is defined, by its name. */
const ELEMENTS = {
  "bezier-applet": Applet,
  "bezier-surface": Surface,
  "bezier-bernstein": Bernstein,
  "bezier-equation": Equation,
  "bezier-coordinates": Coordinates,
  "bezier-easing": Easing,
};

const registry = globalThis.customElements;
for (const [name, type] of Object.entries(ELEMENTS)) if (registry && !registry.get(name)) registry.define(name, type);
