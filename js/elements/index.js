// The custom elements of the package. Importing this module defines them; where there is no document it does nothing.
import { BezierSurface as Element } from "./surface/element.js";

/**
 * @import { BezierSurfaceConstructor } from "./types.js"
 */

const NAME = "bezier-surface";

/** The class of `<bezier-surface>`. */
export const BezierSurface = /** @type {BezierSurfaceConstructor} */ (/** @type {unknown} */ (Element));

const registry = globalThis.customElements;
if (registry && !registry.get(NAME)) registry.define(NAME, Element);
