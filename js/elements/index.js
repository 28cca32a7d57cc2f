// The custom elements of the package. Importing this module defines them; where there is no document it does nothing.
import { BezierApplet as Applet } from "./applet/element.js";
import { BezierSurface as Surface } from "./surface/element.js";

/**
 * @import { BezierAppletConstructor, BezierSurfaceConstructor } from "./types.js"
 */

/** The class of `<bezier-applet>`. */
export const BezierApplet = /** @type {BezierAppletConstructor} */ (/** @type {unknown} */ (Applet));

/** The class of `<bezier-surface>`. */
export const BezierSurface = /** @type {BezierSurfaceConstructor} */ (/** @type {unknown} */ (Surface));

/** What is defined, by its name. */
const ELEMENTS = { "bezier-applet": Applet, "bezier-surface": Surface };

const registry = globalThis.customElements;
for (const [name, type] of Object.entries(ELEMENTS)) if (registry && !registry.get(name)) registry.define(name, type);
