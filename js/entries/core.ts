// The bundle of casteljau/core. Its copy of the classes explains what only `casteljau` has.
import { Curve, Path, Spline } from "../core.js";
import { CURVE_METHODS, CURVE_STATICS, explainMissing, SPLINE_METHODS, SPLINE_STATICS } from "../geometry/missing.js";

export * from "../core.js";

const ENTRY = "casteljau/core";
explainMissing(Curve, "Curve", ENTRY, CURVE_METHODS, CURVE_STATICS);
explainMissing(Spline, "Spline", ENTRY, SPLINE_METHODS, SPLINE_STATICS);
explainMissing(
  Path,
  "Path",
  ENTRY,
  "union intersect subtract exclude removeOverlaps divide clip stroke strokeContains dash offset roundCorners toArcs toThree " +
    "simplify intersections selfIntersections extrema timesAtCoordinate moments toCSS toPathData",
  "combine faces fromPathData index",
);
