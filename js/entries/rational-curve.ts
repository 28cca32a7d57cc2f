// What the elements load of casteljau/nurbs for curves with weights.
import { setCurveBytes } from "../wasm/nurbs-module.js";

export { RationalCurve } from "../geometry/rational/rational-curve.js";

setCurveBytes();
