import { alphabet, frequent, length, text } from "../glue/nurbs-bytes.js";
import { curvesModule } from "./curves-module.js";
import { decodeBytes } from "./decode-bytes.js";

/**
 * Gives the module with curves of casteljau/nurbs its bytes, which are not in the file that the element of surfaces shares
 * (see xtask/bundle.js).
 *
 * @internal
 */
export function bringCurves() {
  curvesModule.bytes = () => decodeBytes(text, alphabet, frequent, length);
}
