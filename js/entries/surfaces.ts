// The bundle of casteljau/surfaces. Its copy of the classes explains what only `casteljau` has.
import { CURVE_METHODS, CURVE_STATICS, explainMissing } from "../geometry/missing.js";
import { Curve } from "../surfaces.js";

export * from "../surfaces.js";

const MEASURES = "length timeAtLength pointAtLength equidistantTimes nearest area";
explainMissing(Curve, "Curve", "casteljau/surfaces", `${CURVE_METHODS} ${MEASURES}`, CURVE_STATICS);
