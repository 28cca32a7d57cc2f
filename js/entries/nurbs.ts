// The bundle of casteljau/nurbs. Its copy of the classes explains what only `casteljau` has.
import { CURVE_METHODS, CURVE_STATICS, explainMissing, SPLINE_METHODS, SPLINE_STATICS } from "../geometry/missing.js";
import { Curve, Spline } from "../nurbs.js";
import { setCurveBytes } from "../wasm/nurbs-module.js";

export * from "../nurbs.js";

setCurveBytes();
const ENTRY = "casteljau/nurbs";
explainMissing(Curve, "Curve", ENTRY, CURVE_METHODS, CURVE_STATICS);
explainMissing(Spline, "Spline", ENTRY, SPLINE_METHODS, SPLINE_STATICS);
