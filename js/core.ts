// casteljau/core: curves, splines and paths that evaluate, split, draw and measure: the classes that those of `casteljau` extend.
// xtask/bundle.js gives it a wasm module with only the functions that these classes call.
import { CoreCurve } from "./geometry/curve/core-curve.js";
import { CoreSpline } from "./geometry/spline/core-spline.js";
import { CorePath } from "./geometry/path/core-path.js";
import { CURVE_METHODS, explainMissing } from "./geometry/missing.js";

export * from "./types.js";
export { init } from "./wasm/init.js";
export { CoreCurve as Curve, CoreSpline as Spline, CorePath as Path };

const ENTRY = "casteljau/core";
explainMissing(CoreCurve, "Curve", ENTRY, CURVE_METHODS, "interpolate");
explainMissing(
  CoreSpline,
  "Spline",
  ENTRY,
  "torsion frames extrema timesAtCoordinate intersections selfIntersections simplify offset toBSpline toThree",
  "interpolate fromBSpline fit",
);
explainMissing(
  CorePath,
  "Path",
  ENTRY,
  "union intersect subtract exclude removeOverlaps divide clip stroke strokeContains dash offset roundCorners toArcs toThree " +
    "simplify intersections selfIntersections extrema timesAtCoordinate moments toCSS toPathData",
  "combine faces fromPathData index",
);
