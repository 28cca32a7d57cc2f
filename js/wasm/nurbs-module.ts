import { alphabet, frequent, length, text } from "../glue/nurbs-bytes.js";
import { curvesModule } from "./curves-module.js";
import { decodeBytes } from "./decode-bytes.js";

/**
 * Sets the bytes of the module with rational curves. They are in a file of their own, because `<bezier-surface>` loads the classes
 * and calls no function of curves (see `nurbsModules` in xtask/bundle.js).
 *
 * @internal
 */
export function setCurveBytes() {
  curvesModule.bytes = () => decodeBytes(text, alphabet, frequent, length);
}
