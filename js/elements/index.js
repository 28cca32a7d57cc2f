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

/** @typedef {import("./tag-names.js").BezierElementTagNameMap} BezierElementTagNameMap */
/** @typedef {import("./types.js").BezierAppletElement} BezierAppletElement */
/** @typedef {import("./types.js").BezierSurfaceElement} BezierSurfaceElement */
/** @typedef {import("./types.js").AppletFigure} AppletFigure */
/** @typedef {import("./types.js").SurfaceFigure} SurfaceFigure */
/** @typedef {import("./types.js").SurfaceView} SurfaceView */
/** @typedef {import("./companions/types.js").BezierBernsteinElement} BezierBernsteinElement */
/** @typedef {import("./companions/types.js").BezierEquationElement} BezierEquationElement */
/** @typedef {import("./companions/types.js").BezierCoordinatesElement} BezierCoordinatesElement */
/** @typedef {import("./companions/types.js").BezierEasingElement} BezierEasingElement */

const registry = globalThis.customElements;

/**
 * Defines an element, once on a page: a second copy of this module takes the class of the first.
 *
 * @param {string} name
 * @param {CustomElementConstructor} type
 * @returns {CustomElementConstructor}
 */
function defined(name, type) {
  if (registry && !registry.get(name)) registry.define(name, type);
  return registry?.get(name) ?? type;
}

/** The class of `<bezier-applet>`. */
export const BezierApplet = /** @type {BezierAppletConstructor} */ (
  /** @type {unknown} */ (defined("bezier-applet", Applet))
);

/** The class of `<bezier-surface>`. */
export const BezierSurface = /** @type {BezierSurfaceConstructor} */ (
  /** @type {unknown} */ (defined("bezier-surface", Surface))
);
/** The class of `<bezier-bernstein>`. */
export const BezierBernstein = /** @type {BezierBernsteinConstructor} */ (
  /** @type {unknown} */ (defined("bezier-bernstein", Bernstein))
);
/** The class of `<bezier-equation>`. */
export const BezierEquation = /** @type {BezierEquationConstructor} */ (
  /** @type {unknown} */ (defined("bezier-equation", Equation))
);
/** The class of `<bezier-coordinates>`. */
export const BezierCoordinates = /** @type {BezierCoordinatesConstructor} */ (
  /** @type {unknown} */ (defined("bezier-coordinates", Coordinates))
);
/** The class of `<bezier-easing>`. */
export const BezierEasing = /** @type {BezierEasingConstructor} */ (
  /** @type {unknown} */ (defined("bezier-easing", Easing))
);
